package org.dronewatch.buildings;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.buildings.land.LandRaster;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.input.FileHash;

/**
 * The buildings made from a map.
 *
 * @param mesh closed solids in the world frame, whose triangles face outwards
 * @param woods canopies in the world frame; without triangles if there are none
 * @param colours colours of the materials in daylight, by name: red, green and blue in the lowest 24 bits
 * @param outlines outlines of all buildings and parts
 * @param attribution the text that the map requires wherever its data are shown; empty if it requires none
 * @param count number of buildings and parts
 * @param area area of the outlines of buildings and parts, without courtyards, m2
 * @param assumed number of buildings and parts with an assumed height
 * @param file the map, with the hash of its bytes as read
 * @param landCover land cover of the ground, if it was requested
 * @param description description of the map, in lines for the report
 * @param warnings warnings about suspicious content, one line each
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
        Optional<LandRaster> landCover,
        List<String> description,
        List<String> warnings) {
    /** Copies the collections: later changes by the caller have no effect. */
    public LoadedBuildings {
        colours = Map.copyOf(colours);
        outlines = List.copyOf(outlines);
        description = List.copyOf(description);
        warnings = List.copyOf(warnings);
    }

    /** The attribution, in the shortest form that is permitted in a picture. */
    public Optional<String> credit() {
        return attribution.map(text -> "© OpenStreetMap contributors");
    }
}
