package org.dronewatch.mesh.io;

import java.util.Set;

/**
 * Reads models of one format. Readers are found by {@link java.util.ServiceLoader}: a jar names its own in
 * {@code META-INF/services/org.dronewatch.mesh.io.MeshReader}. Any number of threads may use a reader at a time.
 */
public interface MeshReader {

    /**
     * File extensions, in lower-case letters and digits without the dot: {@code obj}; no other reader has any
     * of them.
     */
    Set<String> extensions();

    /** A one-line description of the format. */
    String summary();

    /**
     * Reads a model and places it in the world; a {@link ModelCollector} does all but the format.
     *
     * @param file of bounded size, with whatever lies beside it
     * @param settings up axis, scale, position and heading
     * @throws org.dronewatch.setting.InputException with file and location if the file is not such a model
     */
    LoadedModel read(ModelFile file, ModelSettings settings);
}
