package org.dronewatch.buildings;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.file.FileHash;

/**
 * What was made of a map.
 *
 * @param mesh closed solids in the world frame, whose triangles face outwards
 * @param woods canopies in the world frame; without triangles if there are none
 * @param colours of the materials in daylight, by name: red, green and blue in the lowest 24 bits
 * @param outlines of all that stands there
 * @param attribution what the map asks to be said wherever its data are shown, if it does
 * @param count how many buildings and parts stand there
 * @param area of their outlines, without courtyards, m2
 * @param assumed how many of them have an assumed height
 * @param file the map with the bytes that it had
 * @param description what was read, a line for each thing
 * @param warnings what looks odd, a line for each thing
 */
public record LoadedBuildings(
        TriangleMesh mesh,
        TriangleMesh woods,
        Map<String, Integer> colours,
        List<BuildingOutline> outlines,
        Optional<String> attribution,
        int count,
        double area,
        int assumed,
        FileHash file,
        List<String> description,
        List<String> warnings) {
    /** Copies the collections: later changes by the caller have no effect. */
    public LoadedBuildings {
        colours = Map.copyOf(colours);
        outlines = List.copyOf(outlines);
        description = List.copyOf(description);
        warnings = List.copyOf(warnings);
    }
}
