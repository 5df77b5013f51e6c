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
    /** About thirty buildings are higher, m, and so is a house of two floors if its file is in centimetres. */
    private static final double HIGHEST = 500.0;

    /** Less than any drone or obstacle, m; a house whose file is in kilometres is smaller. */
    private static final double SMALLEST = 0.05;

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
     * @throws CancellationException when the thread is interrupted while the model is read
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
     * @throws CancellationException when the thread is interrupted while the model is read
     * @throws InputException when the file is missing, too large, or not a mesh, or the model has a crs and the origin
     *     is not known
     */
    public LoadedModel load(ModelSettings settings, Optional<Origin> sceneOrigin) {
        ModelFile file = ModelFile.find(directory, settings.file()).inScene(sceneOrigin);
        MeshReaders readers = MeshReaders.found();
        if (file.name().toLowerCase(Locale.ROOT).endsWith(".ifc") && !readers.knows(file.name())) {
            throw new InputException(file.name() + ": IFC files are not supported: IfcOpenShell converts them, as in"
                    + " 'IfcConvert --use-world-coords model.ifc model.glb'");
        }
        try {
            LoadedModel model = readers.of(file.name()).read(file, settings);
            String doubt = doubtAboutSize(model, settings.role());
            return doubt.isEmpty() ? doubtIfFar(model, settings) : withWarning(model, doubt);
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

    /** A warning about a model in millimetres that is read in metres, or the other way around; otherwise nothing. */
    private static String doubtAboutSize(LoadedModel model, ModelRole role) {
        AABB box = model.mesh().bounds();
        double high = box.maxZ() - box.minZ();
        double largest = Math.max(high, Math.max(box.maxX() - box.minX(), box.maxY() - box.minY()));
        if (role != ModelRole.TERRAIN && high > HIGHEST) {
            return size("%s: is %,.0f m x %,.0f m x %,.0f m", model)
                    + ", higher than almost any building: unless its unit is the metre, set its scale, as in"
                    + " scale: 0.001 for millimetres";
        }
        return largest < SMALLEST
                ? size("%s: is %.4f m x %.4f m x %.4f m", model) + ", too small to hide anything: check its scale"
                : "";
    }

    private static String size(String format, LoadedModel model) {
        AABB box = model.mesh().bounds();
        return String.format(
                Locale.ROOT,
                format,
                model.name(),
                box.maxX() - box.minX(),
                box.maxY() - box.minY(),
                box.maxZ() - box.minZ());
    }

    private static LoadedModel withWarning(LoadedModel model, String warning) {
        List<String> warnings = new ArrayList<>(model.warnings());
        warnings.add(warning);
        return new LoadedModel(
                model.name(), model.mesh(), model.dropped(), model.skipped(), model.colours(), model.files(), warnings);
    }

    /** Only a model in coordinates of a map lies so far away, and its floats have lost their precision. */
    private static LoadedModel doubtIfFar(LoadedModel model, ModelSettings settings) {
        AABB box = model.mesh().bounds();
        double far = Math.max(
                Math.max(Math.abs(box.minX()), Math.abs(box.maxX())),
                Math.max(Math.abs(box.minY()), Math.abs(box.maxY())));
        if (far <= In.FARTHEST) {
            return model;
        }
        String warning = String.format(
                Locale.ROOT,
                "%s: lies %.0f km from the scene's origin, where coordinates are rounded to %.2g m: %s",
                model.name(),
                far / 1000.0,
                Math.ulp((float) far),
                settings.crs()
                        .map(crs ->
                                "check that its coordinates, plus any shift given by its origin, are those of " + crs)
                        .orElse("if they are those of a national grid, name it, as in crs: EPSG:28992, or set the"
                                + " model's origin to a point of the file, as in origin: [155000, 463000, 0]"));
        return withWarning(model, warning);
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
