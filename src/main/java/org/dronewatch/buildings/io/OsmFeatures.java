package org.dronewatch.buildings.io;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.setting.InputException;

/**
 * Makes outlines of the elements of OpenStreetMap: closed ways, and multipolygons, whose ways are joined end to end.
 * What lies outside the area is dropped as soon as it is read.
 */
final class OsmFeatures implements OsmElements {
    private static final int MOST_NODES = 30_000_000;
    private static final long MOST_CORNERS = 100_000_000;

    /** Elements that are sensible tags of buildings: anything else about a feature is not needed. */
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
    private final LongIndex nodes = new LongIndex();
    private double[] coordinates = new double[1 << 12];
    private final Map<Long, Way> ways = new LinkedHashMap<>();
    private final List<Relation> relations = new ArrayList<>();
    private final Map<String, Integer> leftOut = new LinkedHashMap<>();
    private long corners;
    private boolean dropped;
    private boolean late;

    private record Way(long id, long[] nodes, Map<String, String> tags) {
        boolean isClosed() {
            return nodes.length > 3 && nodes[0] == nodes[nodes.length - 1];
        }
    }

    private record Relation(long id, List<Member> ways, Map<String, String> tags) {}

    /**
     * Nothing yet.
     *
     * @param file its name
     * @param area what lies elsewhere is dropped
     * @param keepsAll whether ways are kept although their nodes are not there yet
     */
    OsmFeatures(String file, MapArea area, boolean keepsAll) {
        this.file = file;
        this.area = area;
        this.keepsAll = keepsAll;
    }

    /** Whether ways were dropped whose nodes may have come later: the file must be read again, keeping all. */
    boolean isIncomplete() {
        return dropped && late;
    }

    @Override
    public void node(long id, double longitude, double latitude) {
        if (!area.contains(longitude, latitude)) {
            return;
        }
        late |= dropped;
        int number = nodes.size();
        if (nodes.get(id) >= 0) {
            return;
        }
        if (number >= MOST_NODES) {
            throw new InputException(
                    file + ": more than " + MOST_NODES + " nodes near the origin: choose a smaller radius");
        }
        nodes.put(id, number);
        if (2 * number + 2 > coordinates.length) {
            coordinates = Arrays.copyOf(coordinates, 2 * coordinates.length);
        }
        coordinates[2 * number] = longitude;
        coordinates[2 * number + 1] = latitude;
    }

    @Override
    public void taggedNode(Map<String, String> tags) {
        if (isBuilding(tags)) {
            leave("point");
        }
    }

    @Override
    public void way(long id, long[] refs, Map<String, String> tags) {
        if (!keepsAll && Arrays.stream(refs).noneMatch(node -> nodes.get(node) >= 0)) {
            dropped = true;
            return;
        }
        corners += refs.length;
        if (corners > MOST_CORNERS) {
            throw new InputException(file + ": ways with more than " + MOST_CORNERS
                    + " corners: cut out the site with 'osmium extract'");
        }
        ways.putIfAbsent(id, new Way(id, refs, isWanted(tags) ? sensible(tags) : Map.of()));
    }

    @Override
    public void relation(long id, List<Member> members, Map<String, String> tags) {
        boolean isArea = "multipolygon".equals(tags.get("type")) || "building".equals(tags.get("type"));
        if (isArea && isWanted(tags) && !members.isEmpty()) {
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
            } else if (Arrays.stream(way.nodes).anyMatch(node -> nodes.get(node) < 0)) {
                leave("outline beyond the area or the file");
            } else if (!built.add(key(way.nodes))) {
                leave("outline given twice");
            } else {
                features.add(new MapFeature("way/" + way.id, List.of(ring(way.nodes)), List.of(), way.tags));
            }
        }
        return features;
    }

    private Optional<MapFeature> feature(Relation relation, Set<Set<Long>> built) {
        List<long[]> outers = joined(relation, true);
        List<long[]> inners = joined(relation, false);
        if (outers.isEmpty()) {
            // A relation of type 'building' may only bind together an outline and its parts, which are ways of their
            // own.
            if ("multipolygon".equals(relation.tags.get("type")) && isNear(relation)) {
                leave("outline beyond the area or the file");
            }
            return Optional.empty();
        }
        List<double[]> kept = new ArrayList<>();
        for (long[] outer : outers) {
            if (built.add(key(outer))) {
                kept.add(ring(outer));
            } else {
                leave("outline given twice");
            }
        }
        return kept.isEmpty()
                ? Optional.empty()
                : Optional.of(new MapFeature(
                        "relation/" + relation.id,
                        kept,
                        inners.stream().map(this::ring).toList(),
                        relation.tags));
    }

    private boolean isNear(Relation relation) {
        return relation.ways.stream()
                .map(member -> ways.get(member.way()))
                .anyMatch(way -> way != null && Arrays.stream(way.nodes).anyMatch(node -> nodes.get(node) >= 0));
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
        joinOpen(open, closed);
        closed.removeIf(ring -> Arrays.stream(ring).anyMatch(node -> nodes.get(node) < 0));
        return closed;
    }

    private static void joinOpen(List<long[]> open, List<long[]> closed) {
        while (!open.isEmpty()) {
            Deque<Long> line = new ArrayDeque<>();
            for (long node : open.remove(open.size() - 1)) {
                line.addLast(node);
            }
            boolean grew = true;
            while (grew && !line.peekFirst().equals(line.peekLast())) {
                grew = false;
                for (int i = 0; i < open.size() && !grew; i++) {
                    grew = append(line, open.get(i));
                    if (grew) {
                        open.remove(i);
                    }
                }
            }
            if (line.size() > 3 && line.peekFirst().equals(line.peekLast())) {
                closed.add(line.stream().mapToLong(Long::longValue).toArray());
            }
        }
    }

    private static boolean append(Deque<Long> line, long[] way) {
        long end = line.peekLast();
        if (way[0] == end) {
            for (int i = 1; i < way.length; i++) {
                line.addLast(way[i]);
            }
            return true;
        }
        if (way[way.length - 1] == end) {
            for (int i = way.length - 2; i >= 0; i--) {
                line.addLast(way[i]);
            }
            return true;
        }
        return false;
    }

    private double[] ring(long[] closed) {
        double[] ring = new double[2 * (closed.length - 1)];
        for (int i = 0; i < closed.length - 1; i++) {
            int node = nodes.get(closed[i]);
            ring[2 * i] = coordinates[2 * node];
            ring[2 * i + 1] = coordinates[2 * node + 1];
        }
        return ring;
    }
}
