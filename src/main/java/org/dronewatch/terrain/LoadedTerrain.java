package org.dronewatch.terrain;

import java.util.List;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.file.FileHash;

/**
 * What was made of files of elevations.
 *
 * @param mesh triangles in the world frame, counter-clockwise seen from above
 * @param posts how many posts near the origin have a height
 * @param holes how many posts there have none
 * @param all how many triangles there would be if every post were kept
 * @param error the greatest vertical distance of a post from the triangle under or over it, m
 * @param files the files with the bytes that they had
 * @param description what was read, a line for each thing
 * @param warnings what looks odd, a line for each thing
 */
public record LoadedTerrain(
        TriangleMesh mesh,
        int posts,
        int holes,
        int all,
        double error,
        List<FileHash> files,
        List<String> description,
        List<String> warnings) {
    /** Copies the lists: later changes by the caller have no effect. */
    public LoadedTerrain {
        files = List.copyOf(files);
        description = List.copyOf(description);
        warnings = List.copyOf(warnings);
    }
}
