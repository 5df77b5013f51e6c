package org.dronewatch.buildings.io;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.geo.MapExtent;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.input.HeapBudget;

/**
 * Makes outlines of the elements of OpenStreetMap: closed ways, and multipolygons, whose ways are joined end to end.
 * What lies outside the area is dropped as soon as it is read.
 */
final class OsmFeatures implements OsmElements {
    private static final long MOST_CORNERS = 100_000_000;

    /** Beginnings of the keys of tags that are needed; all other tags of a feature are dropped. */
    private static final List<String> TAGS = List.of(
            "building",
            "roof",
            "height",
            "min_height",
            "location",
            "material",
            "levels",
            "name",
            "level",
            "type",
            "natural",
            "landuse");

    private final String file;
    private final MapArea area;
    private final boolean keepsAll;
    private final OsmNodes nodes;
    private final Map<Long, Way> ways = new LinkedHashMap<>();
    private final List<Relation> relations = new ArrayList<>();
    private final Map<String, Integer> leftOut = new LinkedHashMap<>();
    private final MapExtent.Collector extent = new MapExtent.Collector();
    private long corners;
    private boolean dropped;
    private boolean late;

    private record Way(long id, long[] nodes, Map<String, String> tags) {
        boolean isClosed() {
            return OsmRings.isClosed(nodes);
        }
    }

    private record Relation(long id, List<Member> ways, Map<String, String> tags) {}

    /**
     * Nothing yet.
     *
     * @param file its name
     * @param area what lies elsewhere is dropped
     * @param keepsAll whether ways are kept although their nodes are not there yet
     * @param budget memory for all that is kept
     */
    OsmFeatures(String file, MapArea area, boolean keepsAll, HeapBudget budget) {
        this.file = file;
        this.area = area;
        this.keepsAll = keepsAll;
        this.nodes = new OsmNodes(file, budget);
    }

    /** The nodes of the area. */
    OsmNodes nodes() {
        return nodes;
    }

    /** The coordinate system of all nodes in the file, with the extent of their coordinates. */
    MapSystem system() {
        return new MapSystem(MapSystem.Rule.ALWAYS_DEGREES, Optional.empty(), "", extent.extent(), Optional.empty());
    }

    /** Whether ways were dropped whose nodes may have come later: the file must be read again, keeping all. */
    boolean isIncomplete() {
        return dropped && late;
    }

    @Override
    public void node(long id, double longitude, double latitude) {
        extent.add(longitude, latitude);
        if (!area.contains(longitude, latitude)) {
            return;
        }
        late |= dropped;
        nodes.add(id, longitude, latitude);
    }

    @Override
    public void taggedNode(Map<String, String> tags) {
        if (isBuilding(tags)) {
            leave("point");
        }
    }

    @Override
    public void way(long id, long[] refs, Map<String, String> tags) {
        if (!keepsAll && !nodes.containsAny(refs)) {
            dropped = true;
            return;
        }
        corners += refs.length;
        if (corners > MOST_CORNERS) {
            throw new InputException(file + ": ways with more than " + MOST_CORNERS
                    + " corners: extract the site with 'osmium extract'");
        }
        nodes.takeMemoryOfWay(refs.length, isWanted(tags) ? tags : Map.of());
        ways.putIfAbsent(id, new Way(id, refs, isWanted(tags) ? sensible(tags) : Map.of()));
    }

    @Override
    public void relation(long id, List<Member> members, Map<String, String> tags) {
        boolean isArea = "multipolygon".equals(tags.get("type")) || "building".equals(tags.get("type"));
        if (isArea && isWanted(tags) && !members.isEmpty()) {
            nodes.takeMemoryOfWay(8 * members.size(), tags);
            relations.add(new Relation(id, members, sensible(tags)));
        }
    }

    private static boolean isBuilding(Map<String, String> tags) {
        return isYes(tags.get("building")) || isYes(tags.get("building:part"));
    }

    private static boolean isWood(Map<String, String> tags) {
        return "wood".equals(tags.get("natural")) || "forest".equals(tags.get("landuse"));
    }

    /** Whether something becomes a feature. */
    private static boolean isWanted(Map<String, String> tags) {
        return isBuilding(tags) || isWood(tags);
    }

    private static boolean isYes(String value) {
        return value != null && !value.equals("no") && !value.isBlank();
    }

    private static Map<String, String> sensible(Map<String, String> tags) {
        Map<String, String> kept = new HashMap<>(tags);
        kept.keySet().removeIf(key -> TAGS.stream().noneMatch(key::startsWith));
        return kept;
    }

    private void leave(String what) {
        leftOut.merge(what, 1, Integer::sum);
    }

    Map<String, Integer> leftOut() {
        return leftOut;
    }

    /**
     * The outlines: relations, which have courtyards, before ways, so that a way that is tagged as well is not built
     * again.
     */
    List<MapFeature> features() {
        List<MapFeature> features = new ArrayList<>();
        Set<Set<Long>> built = new HashSet<>();
        for (Relation relation : relations) {
            feature(relation, built).ifPresent(features::add);
        }
        for (Way way : ways.values()) {
            if (!isWanted(way.tags)) {
                continue;
            }
            if (!way.isClosed()) {
                leave("outline not closed");
            } else if (!nodes.containsAll(way.nodes)) {
                leave("outline reaching beyond the area or the file");
            } else if (!built.add(key(way.nodes))) {
                leave("outline given twice");
            } else {
                features.add(new MapFeature("way/" + way.id, List.of(nodes.ring(way.nodes)), List.of(), way.tags));
            }
        }
        return features;
    }

    private Optional<MapFeature> feature(Relation relation, Set<Set<Long>> built) {
        List<long[]> outers = joined(relation, true);
        List<long[]> inners = joined(relation, false);
        if (outers.isEmpty()) {
            // A relation of type 'building' may only bind together an outline and its parts, which are separate
            // ways.
            if ("multipolygon".equals(relation.tags.get("type")) && isNear(relation)) {
                leave("outline reaching beyond the area or the file");
            }
            return Optional.empty();
        }
        List<double[]> kept = new ArrayList<>();
        for (long[] outer : outers) {
            if (built.add(key(outer))) {
                kept.add(nodes.ring(outer));
            } else {
                leave("outline given twice");
            }
        }
        return kept.isEmpty()
                ? Optional.empty()
                : Optional.of(new MapFeature(
                        "relation/" + relation.id,
                        kept,
                        inners.stream().map(nodes::ring).toList(),
                        relation.tags));
    }

    private boolean isNear(Relation relation) {
        return relation.ways.stream()
                .map(member -> ways.get(member.way()))
                .anyMatch(way -> way != null && nodes.containsAny(way.nodes));
    }

    /** The same corners, whichever is the first and whichever way round. */
    private static Set<Long> key(long[] ring) {
        Set<Long> key = new HashSet<>();
        for (long node : ring) {
            key.add(node);
        }
        return key;
    }

    /**
     * The ways of a role joined end to end into closed lines; those that do not close, or lack a node, are left out.
     */
    private List<long[]> joined(Relation relation, boolean isOuter) {
        boolean isMultipolygon = "multipolygon".equals(relation.tags.get("type"));
        List<long[]> closed = new ArrayList<>();
        List<long[]> open = new ArrayList<>();
        for (Member member : relation.ways) {
            Way way = ways.get(member.way());
            boolean asked = isOuter
                    ? member.role().equals("outer")
                            || isMultipolygon && member.role().isEmpty()
                    : member.role().equals("inner");
            if (asked && way != null && way.nodes.length > 1) {
                (way.isClosed() ? closed : open).add(way.nodes);
            }
        }
        OsmRings.join(open, closed);
        closed.removeIf(ring -> !nodes.containsAll(ring));
        return closed;
    }
}
