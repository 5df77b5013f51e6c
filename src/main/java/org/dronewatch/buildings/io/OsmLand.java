package org.dronewatch.buildings.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronewatch.setting.InputException;

/**
 * Collects the land cover from the elements of OpenStreetMap. A lake may reach far beyond the area whose nodes were
 * kept: its outline is completed by reading the file again, first for the ways that are missing, then for the nodes.
 */
final class OsmLand {
    private static final long MOST_CORNERS = 100_000_000;

    private final String file;
    private final OsmNodes nodes;
    private final Map<Long, Way> ways = new LinkedHashMap<>();
    private final List<Relation> relations = new ArrayList<>();
    private final Set<Long> missing = new HashSet<>();
    private final Set<Long> outlines = new HashSet<>();
    private final List<MapShape> shapes = new ArrayList<>();
    private long corners;

    private record Way(long[] nodes, Map<String, String> tags) {}

    private record Relation(long id, List<OsmElements.Member> ways, Map<String, String> tags) {}

    /** Reads all elements of a file once more. */
    interface Pass {
        void read(OsmElements target) throws IOException;
    }

    private OsmLand(String file, OsmNodes nodes) {
        this.file = file;
        this.nodes = nodes;
    }

    /**
     * Reads the land cover of a file.
     *
     * @param file its name, for messages
     * @param nodes those in the area; receives more
     * @throws InputException with a one-line message when it is damaged, or there is too much
     */
    static MapLand read(String file, OsmNodes nodes, Pass pass) throws IOException {
        OsmLand land = new OsmLand(file, nodes);
        pass.read(land.new NearWays());
        land.dropOthers();
        if (!land.missing.isEmpty()) {
            pass.read(land.new MissingWays());
        }
        land.missing.clear();
        land.ways.values().forEach(way -> Arrays.stream(way.nodes)
                .filter(node -> !nodes.contains(node))
                .forEach(land.missing::add));
        if (!land.missing.isEmpty()) {
            pass.read(land.new MissingNodes());
        }
        return land.collected();
    }

    /** Receives nothing; passes override what they need. */
    private static class Quiet implements OsmElements {
        @Override
        public void node(long id, double longitude, double latitude) {
            // Not needed in this pass.
        }

        @Override
        public void taggedNode(Map<String, String> tags) {
            // Points cover nothing.
        }

        @Override
        public void way(long id, long[] refs, Map<String, String> tags) {
            // Not needed in this pass.
        }

        @Override
        public void relation(long id, List<Member> members, Map<String, String> tags) {
            // Not needed in this pass.
        }
    }

    /** Ways with a node in the area, and relations with such a way. */
    private final class NearWays extends Quiet {
        @Override
        public void way(long id, long[] refs, Map<String, String> tags) {
            if (refs.length > 1 && nodes.containsAny(refs)) {
                keep(id, refs, MapLand.isLand(tags) ? tags : Map.of());
            }
        }

        @Override
        public void relation(long id, List<Member> members, Map<String, String> tags) {
            if ("multipolygon".equals(tags.get("type"))
                    && MapLand.isLand(tags)
                    && members.stream().anyMatch(member -> ways.containsKey(member.way()))) {
                nodes.takeMemoryOfWay(8 * members.size(), tags);
                relations.add(new Relation(id, members, tags));
            }
        }
    }

    private void keep(long id, long[] refs, Map<String, String> tags) {
        corners += refs.length;
        if (corners > MOST_CORNERS) {
            throw new InputException(file + ": ways with more than " + MOST_CORNERS
                    + " corners: extract the site with 'osmium extract'");
        }
        nodes.takeMemoryOfWay(refs.length, tags);
        ways.putIfAbsent(id, new Way(refs, tags));
    }

    /**
     * Of the ways in the area, only those that cover the ground, or bound an area that does, are needed from here on.
     */
    private void dropOthers() {
        Set<Long> members = new HashSet<>();
        for (Relation relation : relations) {
            for (OsmElements.Member member : relation.ways) {
                members.add(member.way());
                if (!member.role().equals("inner")) {
                    outlines.add(member.way());
                }
                if (!ways.containsKey(member.way())) {
                    missing.add(member.way());
                }
            }
        }
        ways.entrySet().removeIf(way -> way.getValue().tags.isEmpty() && !members.contains(way.getKey()));
    }

    private final class MissingWays extends Quiet {
        @Override
        public void way(long id, long[] refs, Map<String, String> tags) {
            if (missing.contains(id) && refs.length > 1) {
                // It only bounds an area; what it represents by itself lies outside the area that is read.
                keep(id, refs, Map.of());
            }
        }
    }

    private final class MissingNodes extends Quiet {
        @Override
        public void node(long id, double longitude, double latitude) {
            if (missing.contains(id)) {
                nodes.add(id, longitude, latitude);
            }
        }
    }

    private MapLand collected() {
        relations.forEach(this::add);
        ways.forEach((id, way) -> {
            // The outline of a relation is not added again by itself, without the courtyards of the relation.
            boolean isOutline = outlines.contains(id) && OsmRings.isClosed(way.nodes);
            if (!way.tags.isEmpty() && !isOutline) {
                add("way/" + id, way);
            }
        });
        return new MapLand(shapes);
    }

    /** Adds a relation with all of its rings, outer and inner; if one is not whole, the others would mislead. */
    private void add(Relation relation) {
        List<long[]> open = new ArrayList<>();
        List<long[]> closed = new ArrayList<>();
        List<double[]> pieces = new ArrayList<>();
        boolean isWhole = true;
        for (OsmElements.Member member : relation.ways) {
            Way way = ways.get(member.way());
            isWhole &= way != null && nodes.containsAll(way.nodes);
            if (way != null) {
                pieces.addAll(pieces(way.nodes));
                (OsmRings.isClosed(way.nodes) ? closed : open).add(way.nodes);
            }
        }
        isWhole = isWhole && OsmRings.join(open, closed) == 0;
        List<double[]> lines = isWhole ? closed.stream().map(nodes::ring).toList() : pieces;
        shapes.add(new MapShape("relation/" + relation.id, isWhole, lines, relation.tags));
    }

    private void add(String id, Way way) {
        boolean isClosed = OsmRings.isClosed(way.nodes) && nodes.containsAll(way.nodes);
        List<double[]> lines = isClosed ? List.of(nodes.ring(way.nodes)) : pieces(way.nodes);
        shapes.add(new MapShape(id, isClosed, lines, way.tags));
    }

    /** The parts of a line whose nodes are there: roads end where the file does. */
    private List<double[]> pieces(long[] line) {
        List<double[]> pieces = new ArrayList<>();
        int from = 0;
        for (int i = 0; i <= line.length; i++) {
            if (i == line.length || !nodes.contains(line[i])) {
                if (i - from > 1) {
                    pieces.add(nodes.line(line, from, i));
                }
                from = i + 1;
            }
        }
        return pieces;
    }
}
