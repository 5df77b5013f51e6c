package org.dronewatch.buildings.io;

import java.util.List;

/**
 * The buildings of a city model, with their walls and roofs. The arrays are not copied: callers must not modify them.
 *
 * @param vertices x, y and height of each vertex in turn, in the map's coordinates
 * @param solids the buildings, in the order of the file
 */
public record CityModel(double[] vertices, List<Solid> solids) {
    /** Copies the list: later changes by the caller have no effect. */
    public CityModel {
        solids = List.copyOf(solids);
    }

    /**
     * The surfaces of a building, which should enclose it.
     *
     * @param id identifier of the building in the model
     * @param surfaces the surfaces: for each, its outline, counter-clockwise as seen from outside, then its openings,
     *     all given by the numbers of their vertices
     */
    public record Solid(String id, List<List<int[]>> surfaces) {
        /** Copies the list: later changes by the caller have no effect. */
        public Solid {
            surfaces = List.copyOf(surfaces);
        }
    }
}
