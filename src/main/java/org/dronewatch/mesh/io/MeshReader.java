package org.dronewatch.mesh.io;

import java.util.Set;

/**
 * A reader of one model format. Readers are found by {@link java.util.ServiceLoader}: a jar names its readers in {@code
 * META-INF/services/org.dronewatch.mesh.io.MeshReader}. Readers must be thread-safe.
 */
public interface MeshReader {

    /**
     * File extensions, in lower-case letters and digits without the dot, such as {@code obj}; no two readers may share
     * an extension.
     */
    Set<String> extensions();

    /** A one-line description of the format. */
    String summary();

    /**
     * Reads a model and places it in the world; a {@link ModelCollector} does everything except parsing the format.
     *
     * @param file the model file, of bounded size, with access to the files beside it
     * @param settings up axis, scale, position and heading
     * @throws org.dronewatch.setting.InputException with file and location if the file is not such a model
     */
    LoadedModel read(ModelFile file, ModelSettings settings);
}
