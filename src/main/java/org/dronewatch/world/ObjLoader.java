package org.dronewatch.world;

import de.javagl.obj.FloatTuple;
import de.javagl.obj.Mtl;
import de.javagl.obj.MtlReader;
import de.javagl.obj.ObjReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.dronewatch.setting.InputException;

/**
 * Reads triangle meshes from Wavefront OBJ files, with the materials of their MTL files. Polygons are cut into fans
 * in the order of their corners; triangles without area are dropped and counted; lines, curves, normals and texture
 * coordinates are ignored. What cannot be right is an {@link InputException} that names file and line.
 */
public final class ObjLoader {
    private final Path directory;

    /**
     * A loader of models by name.
     *
     * @param directory where relative paths start
     */
    public ObjLoader(Path directory) {
        this.directory = directory;
    }

    /**
     * Reads a model and places it.
     *
     * @throws CancellationException when the thread is interrupted meanwhile
     * @throws InputException when the file is missing, too large, or no mesh
     */
    public LoadedModel load(ModelSettings settings) {
        ModelFile file = ModelFile.find(directory, settings.file());
        ObjMeshCollector collector = read(file, new Placement(settings));
        List<String> warnings = new ArrayList<>(collector.warnings());
        Map<String, Integer> colours = new HashMap<>();
        warnings.addAll(readMaterials(file, collector, colours));
        return new LoadedModel(file.name(), collector.toMesh(file.name()), collector.dropped(), colours, warnings);
    }

    /**
     * Reads a model in the file's own coordinates, unconverted.
     *
     * @param file path of an .obj file, or {@code packaged:NAME}
     * @throws InputException when the file is missing, too large, or no mesh
     */
    public LoadedModel loadAsWritten(String file) {
        return load(ModelSettings.of(file).withUpAxis(UpAxis.Z));
    }

    private static ObjMeshCollector read(ModelFile file, Placement placement) {
        try (Reader text = new InputStreamReader(file.open(), StandardCharsets.UTF_8);
                ObjLines lines = new ObjLines(text)) {
            ObjMeshCollector collector = new ObjMeshCollector(file.name(), lines, placement);
            try {
                ObjReader.read(lines, collector);
            } catch (InputException | CancellationException e) {
                throw e;
            } catch (IOException | RuntimeException e) {
                // The parser throws whatever its string handling happens to throw on a line it did not expect.
                throw new InputException(lines.at(file.name()) + reason(e), e);
            }
            collector.finish();
            return collector;
        } catch (IOException e) {
            throw new InputException("model file " + file.name() + " cannot be read: " + e.getMessage(), e);
        }
    }

    private static String reason(Exception problem) {
        Throwable cause = problem.getCause() == null ? problem : problem.getCause();
        if (cause instanceof NumberFormatException) {
            return "not a number: " + cause.getMessage();
        }
        return cause.getMessage() == null ? "is no line of an OBJ file" : cause.getMessage();
    }

    private static List<String> readMaterials(
            ModelFile file, ObjMeshCollector collector, Map<String, Integer> colours) {
        List<String> warnings = new ArrayList<>();
        Set<String> defined = new HashSet<>();
        for (String library : collector.libraries()) {
            Optional<ModelFile> found = file.beside(library);
            if (found.isEmpty()) {
                warnings.add(file.name() + ": material library '" + library
                        + "' is not beside it; its materials are names only");
                return warnings;
            }
            readMaterials(found.get(), defined, colours, warnings);
        }
        Set<String> undefined = new HashSet<>(collector.materialNames());
        undefined.removeAll(defined);
        undefined.remove(ObjMeshCollector.NO_MATERIAL);
        if (!collector.libraries().isEmpty() && !undefined.isEmpty()) {
            warnings.add(file.name() + ": used but defined in no material library: "
                    + String.join(", ", undefined.stream().sorted().toList()));
        }
        return warnings;
    }

    private static void readMaterials(
            ModelFile library, Set<String> defined, Map<String, Integer> colours, List<String> warnings) {
        try (Reader text = new InputStreamReader(library.open(), StandardCharsets.UTF_8)) {
            for (Mtl material : MtlReader.read(text)) {
                defined.add(material.getName());
                if (material.getKd() != null) {
                    colours.put(material.getName(), colour(material.getKd()));
                }
            }
        } catch (IOException | RuntimeException e) {
            warnings.add(library.name() + ": not a material library: " + e.getMessage());
        }
    }

    /** A diffuse colour of an MTL file, each part between 0 and 1, as it is shown on a screen. */
    private static int colour(FloatTuple diffuse) {
        int rgb = 0;
        for (int channel = 0; channel < 3; channel++) {
            // Not a number becomes 0, as a cast does.
            rgb = rgb << 8 | (int) (255.0f * Math.max(0.0f, Math.min(1.0f, diffuse.get(channel))) + 0.5f);
        }
        return rgb;
    }
}
