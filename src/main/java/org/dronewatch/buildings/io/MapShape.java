package org.dronewatch.buildings.io;

import java.util.List;
import java.util.Map;

/**
 * A shape on a map that states the land cover: an area, or a line such as a road. The arrays are not copied: callers
 * must not modify them.
 *
 * @param id identifier of the shape on the map, such as {@code way/4713}
 * @param isClosed whether its lines are closed, so that it may be an area
 * @param lines x and y of each corner in turn, in the map's coordinates; closed ones, including those around courtyards
 *     and islands, without repeating the first corner
 * @param tags what the map states about the shape, by key
 */
public record MapShape(String id, boolean isClosed, List<double[]> lines, Map<String, String> tags) {
    /** Copies list and map: later changes by the caller have no effect. */
    public MapShape {
        lines = List.copyOf(lines);
        tags = Map.copyOf(tags);
    }
}
