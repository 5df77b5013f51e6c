package org.dronewatch.terrain;

import java.util.List;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.input.FileHash;

/**
 * A terrain made from elevation files.
 *
 * @param mesh triangles in the world frame, counter-clockwise as seen from above
 * @param posts number of posts near the origin that have a height
 * @param holes number of posts near the origin that have no height
 * @param all number of triangles if every post were kept
 * @param error the greatest vertical distance of a post from the triangle below or above it, m
 * @param files the files, with hashes of their bytes as read
 * @param description description of the files, in lines for the report
 * @param warnings warnings about suspicious content, one line each
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
