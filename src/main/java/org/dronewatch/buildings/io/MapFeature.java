package org.dronewatch.buildings.io;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * A feature of a map: a building, a part of one, or a wood. The arrays are not copied: callers must not modify them.
 *
 * @param id identifier of the feature on the map, such as {@code way/4713}
 * @param outers closed outlines: x and y of each corner in turn, in the map's coordinates, without repeating the first
 *     one
 * @param inners courtyards, in the same form
 * @param tags what the map states about the feature, by key
 */
public record MapFeature(String id, List<double[]> outers, List<double[]> inners, Map<String, String> tags) {
    /** Copies the lists: later changes by the caller have no effect. */
    public MapFeature {
        outers = List.copyOf(outers);
        inners = List.copyOf(inners);
        tags = Map.copyOf(tags);
    }

    /** Whether this feature is a wood rather than a building. */
    public boolean isWood() {
        String building = tags.getOrDefault("building", "no");
        return building.equals("no") && ("wood".equals(tags.get("natural")) || "forest".equals(tags.get("landuse")));
    }

    /** All outlines, including those of courtyards. */
    public Stream<double[]> rings() {
        return Stream.concat(outers.stream(), inners.stream());
    }
}
