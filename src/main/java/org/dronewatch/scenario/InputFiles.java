package org.dronewatch.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.setting.CanonicalSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.input.FileHash;

/**
 * The input of a scene's run: the hash of its settings, and its files as they were when they were read.
 *
 * @param settingsHash SHA-256 of the effective settings, with all overrides, as {@link CanonicalSettings} writes them
 * @param scene the files that describe the scene, the scene file first; none for a scene in Java
 * @param models the files of each model that was loaded, the model file first, then its material libraries; by the
 *     model's name in the settings
 */
public record InputFiles(String settingsHash, List<FileHash> scene, Map<String, List<FileHash>> models) {
    /** Copies the lists: later changes by the caller have no effect. */
    public InputFiles {
        scene = List.copyOf(scene);
        models = Collections.unmodifiableMap(new LinkedHashMap<>(models));
    }

    /** The input of a run whose settings do not come from a known file. */
    public static InputFiles of(SceneSettings settings) {
        return new InputFiles(FileHash.ofText(CanonicalSettings.of(settings)), List.of(), Map.of());
    }

    /**
     * These inputs with other files that describe the scene, each listed once.
     *
     * @param described files that have been hashed
     * @param more files to be hashed, which follow the others
     */
    public InputFiles withScene(List<FileHash> described, List<Path> more) {
        List<FileHash> all = new ArrayList<>(described);
        more.stream().map(InputFiles::hash).filter(file -> !all.contains(file)).forEach(all::add);
        return new InputFiles(settingsHash, all, models);
    }

    /** These inputs with the models that were loaded. */
    public InputFiles withModels(Map<String, List<FileHash>> loaded) {
        return new InputFiles(settingsHash, scene, loaded);
    }

    /**
     * The name and the hash of a file.
     *
     * @throws InputException with a one-line message when the file cannot be read
     */
    public static FileHash hash(Path file) {
        try (InputStream bytes = Files.newInputStream(file)) {
            return FileHash.of(String.valueOf(file.getFileName()), bytes);
        } catch (IOException e) {
            throw new InputException(file + ": cannot be read: " + e.getMessage(), e);
        }
    }
}
