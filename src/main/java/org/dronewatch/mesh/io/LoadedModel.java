package org.dronewatch.mesh.io;

import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.input.FileHash;

/**
 * A model read from a file.
 *
 * @param name the file's name
 * @param mesh triangles of the model, placed in the world frame
 * @param dropped number of triangles without area that were left out
 * @param skipped number of statements without effect, by keyword
 * @param colours colours of the materials in daylight, red, green and blue in the lowest 24 bits, by material name;
 *     those without a colour are left out
 * @param files the files, with hashes of their bytes: the model file first, then the files beside it that were read,
 *     such as material libraries
 * @param warnings warnings about suspicious content that is not an error, one line each
 */
public record LoadedModel(
        String name,
        TriangleMesh mesh,
        int dropped,
        Map<String, Integer> skipped,
        Map<String, Integer> colours,
        List<FileHash> files,
        List<String> warnings) {

    /** Copies the lists: later changes by the caller have no effect. */
    public LoadedModel {
        skipped = Collections.unmodifiableMap(new TreeMap<>(skipped));
        colours = Map.copyOf(colours);
        files = List.copyOf(files);
        warnings = List.copyOf(warnings);
    }

    /** A one-line summary: triangles and extent, and the number of skipped statements. */
    public String describe() {
        AABB bounds = mesh.bounds();
        return String.format(
                Locale.ROOT,
                "%s: %s%s, %.2f x %.2f x %.2f m along x, y, z, %s%s",
                name,
                Counted.of(mesh.triangleCount(), "triangle"),
                dropped == 0 ? "" : String.format(Locale.ROOT, " (%,d of zero area dropped)", dropped),
                bounds.maxX() - bounds.minX(),
                bounds.maxY() - bounds.minY(),
                bounds.maxZ() - bounds.minZ(),
                Counted.of(mesh.materialNames().size(), "material"),
                skipped.isEmpty() ? "" : "; skipped " + listSkipped());
    }

    private String listSkipped() {
        int total = skipped.values().stream().mapToInt(Integer::intValue).sum();
        return skipped.entrySet().stream()
                        .map(entry -> String.format(Locale.ROOT, "%,d '%s'", entry.getValue(), entry.getKey()))
                        .collect(Collectors.joining(", "))
                + (total == 1 ? " statement" : " statements");
    }
}
