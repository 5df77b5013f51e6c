package org.dronewatch.mesh.io;

import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import org.dronewatch.setting.InputException;

/** Reads triangle meshes from model files, in whatever formats the class path has a {@link MeshReader} for. */
public final class ModelLoader {
    private final Path directory;

    /**
     * A loader of models by name.
     *
     * @param directory of relative paths
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
        MeshReaders readers = MeshReaders.found();
        if (file.name().toLowerCase(Locale.ROOT).endsWith(".ifc") && !readers.knows(file.name())) {
            throw new InputException(
                    file.name() + ": IFC files are not read: 'IfcConvert --use-world-coords model.ifc model.glb' of"
                            + " IfcOpenShell converts them");
        }
        try {
            return readers.of(file.name()).read(file, settings);
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

    /**
     * Reads a model in the file's own coordinates, unconverted.
     *
     * @param file path of a model file, or {@code packaged:NAME}
     * @throws InputException when the file is missing, too large, or no mesh
     */
    public LoadedModel loadAsWritten(String file) {
        return load(ModelSettings.of(file).withUpAxis(UpAxis.Z));
    }
}
