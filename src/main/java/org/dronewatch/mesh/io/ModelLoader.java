package org.dronewatch.mesh.io;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.AABB;
import org.dronewatch.setting.In;
import org.dronewatch.setting.InputException;

/** Reads triangle meshes from model files, in all formats with a {@link MeshReader} on the class path. */
public final class ModelLoader {
    private final Path directory;

    /**
     * A loader of models by name.
     *
     * @param directory directory against which relative paths are resolved
     */
    public ModelLoader(Path directory) {
        this.directory = directory;
    }

    /**
     * Reads a model that is not in coordinates of a national grid, and places it.
     *
     * @throws CancellationException when the thread is interrupted meanwhile
     * @throws InputException when the file is missing, too large, or not a mesh
     */
    public LoadedModel load(ModelSettings settings) {
        return load(settings, Optional.empty());
    }

    /**
     * Reads a model and places it.
     *
     * @param sceneOrigin geographic position of the scene's origin, which a model with a {@linkplain
     *     ModelSettings#crs() crs} needs
     * @throws CancellationException when the thread is interrupted meanwhile
     * @throws InputException when the file is missing, too large, or not a mesh, or the model has a crs and the origin
     *     is not known
     */
    public LoadedModel load(ModelSettings settings, Optional<Origin> sceneOrigin) {
        ModelFile file = ModelFile.find(directory, settings.file()).inScene(sceneOrigin);
        MeshReaders readers = MeshReaders.found();
        if (file.name().toLowerCase(Locale.ROOT).endsWith(".ifc") && !readers.knows(file.name())) {
            throw new InputException(
                    file.name() + ": IFC files are not read: 'IfcConvert --use-world-coords model.ifc model.glb' of"
                            + " IfcOpenShell converts them");
        }
        try {
            return doubtIfFar(readers.of(file.name()).read(file, settings), settings);
        } catch (InputException e) {
            if (readers.knows(file.name())) {
                throw e;
            }
            throw new InputException(
                    e.getMessage()
                            + "; it was read as OBJ, because no reader for files of this name is on the class path",
                    e);
        }
    }

    /** Nothing else may lie so far away: it is in coordinates of a map, and its floats have lost what they say. */
    private static LoadedModel doubtIfFar(LoadedModel model, ModelSettings settings) {
        AABB box = model.mesh().bounds();
        double far = Math.max(
                Math.max(Math.abs(box.minX()), Math.abs(box.maxX())),
                Math.max(Math.abs(box.minY()), Math.abs(box.maxY())));
        if (far <= In.FARTHEST) {
            return model;
        }
        List<String> warnings = new ArrayList<>(model.warnings());
        warnings.add(String.format(
                Locale.ROOT,
                "%s: lies %.0f km from the scene's origin, where coordinates are rounded to %.2g m: %s",
                model.name(),
                far / 1000.0,
                Math.ulp((float) far),
                settings.crs()
                        .map(crs ->
                                "check that its coordinates, plus any shift given by its origin, are those of " + crs)
                        .orElse("if they are those of a national grid, name it, as in crs: EPSG:28992, or set the"
                                + " model's origin to a point of the file, as in origin: [155000, 463000, 0]")));
        return new LoadedModel(
                model.name(), model.mesh(), model.dropped(), model.skipped(), model.colours(), model.files(), warnings);
    }

    /**
     * Reads a model in the file's own coordinates, unconverted.
     *
     * @param file path of a model file, or {@code packaged:NAME}
     * @throws InputException when the file is missing, too large, or not a mesh
     */
    public LoadedModel loadAsWritten(String file) {
        return load(ModelSettings.of(file).withUpAxis(UpAxis.Z));
    }
}
