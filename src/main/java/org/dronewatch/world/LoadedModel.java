package org.dronewatch.world;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.TriangleMesh;

/**
 * What was read from a model file.
 *
 * @param name the file's name
 * @param mesh its triangles, placed in the world's frame
 * @param dropped how many triangles without area were left out
 * @param colours what its materials look like in daylight, red, green and blue in the lowest 24 bits, by material name;
 *     those without a colour are left out
 * @param warnings what looked odd but did not stop the reading, one line each
 */
public record LoadedModel(
        String name, TriangleMesh mesh, int dropped, Map<String, Integer> colours, List<String> warnings) {

    /** Keeps its own lists. */
    public LoadedModel {
        colours = Map.copyOf(colours);
        warnings = List.copyOf(warnings);
    }

    /** One line for a person: triangles and extent. */
    public String describe() {
        AABB bounds = mesh.bounds();
        return String.format(
                Locale.ROOT,
                "%s: %,d triangles (%d without area dropped), %.2f x %.2f x %.2f m along x, y, z, %d materials",
                name,
                mesh.triangleCount(),
                dropped,
                bounds.maxX() - bounds.minX(),
                bounds.maxY() - bounds.minY(),
                bounds.maxZ() - bounds.minZ(),
                mesh.materialNames().size());
    }
}
