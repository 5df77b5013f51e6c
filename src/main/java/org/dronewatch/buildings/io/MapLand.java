package org.dronewatch.buildings.io;

import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The land cover of a map.
 *
 * @param shapes areas and lines, in the order of the file; areas whose outlines are incomplete in the file are not
 *     closed
 */
public record MapLand(List<MapShape> shapes) {
    /** No land cover: not requested, or not stated by the map. */
    public static final MapLand NONE = new MapLand(List.of());

    /** Keys of OpenStreetMap, at least one of which is set on everything that describes land cover. */
    private static final Set<String> KEYS = Set.of(
            "landuse",
            "natural",
            "leisure",
            "amenity",
            "waterway",
            "highway",
            "area:highway",
            "railway",
            "aeroway",
            "man_made",
            "place");

    /** Copies the list: later changes by the caller have no effect. */
    public MapLand {
        shapes = List.copyOf(shapes);
    }

    /** Whether tags may describe land cover. Those of buildings do not, whatever else they are. */
    static boolean isLand(Map<String, String> tags) {
        String building = tags.getOrDefault("building", "no");
        return building.equals("no") && tags.keySet().stream().anyMatch(KEYS::contains);
    }
}
