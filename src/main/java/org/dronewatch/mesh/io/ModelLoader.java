package org.dronewatch.mesh.io;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.file.FileHash;

/**
 * Reads triangle meshes from Wavefront OBJ files, with the materials of their MTL files. Polygons are cut into triangles, in
 * fans where these cover them; triangles without area are dropped and counted; lines, curves, normals, texture coordinates
 * and what else the format has are skipped and counted. What cannot be right is an {@link InputException} that names file and
 * line.
 */
public final class ModelLoader {
    private final Path directory;

    /**
     * A loader of models by name.
     *
     * @param directory where relative paths start
     */
    public ModelLoader(Path directory) {
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
        TriangleMesh mesh = collector.toMesh(warnings);
        List<FileHash> files = new ArrayList<>(List.of(file.hash()));
        MaterialLibraries materials = new MaterialLibraries(file);
        materials.read(collector.libraries(), collector.materialNames());
        files.addAll(materials.files());
        warnings.addAll(materials.warnings());
        int dropped = collector.triangles() - mesh.triangleCount();
        return new LoadedModel(file.name(), mesh, dropped, collector.skipped(), materials.colours(), files, warnings);
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
        try (Reader text = file.text();
                ObjLines lines = new ObjLines(text)) {
            ObjMeshCollector collector = new ObjMeshCollector(file.name(), lines, placement);
            try {
                new ObjParser(file.name(), lines, collector).read();
            } catch (IOException e) {
                throw new InputException(lines.at(file.name()) + e.getMessage(), e);
            }
            collector.finish();
            return collector;
        } catch (IOException e) {
            throw new InputException("model file " + file.name() + " cannot be read: " + e.getMessage(), e);
        }
    }
}
