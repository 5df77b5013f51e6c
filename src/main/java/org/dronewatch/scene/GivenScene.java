package org.dronewatch.scene;

import java.nio.file.Path;
import org.dronewatch.scenario.SceneSettings;

/** A scene whose settings are already complete, such as one case of many. */
public final class GivenScene extends Scene {
    private static final long serialVersionUID = 1L;

    private final String name;
    private final transient Path directory;
    private final transient SceneSettings settings;

    /**
     * A scene.
     *
     * @param name name of the scene in results and in the titles of windows
     * @param directory directory against which file names in the settings are resolved
     * @param settings complete settings, positions included
     */
    public GivenScene(String name, Path directory, SceneSettings settings) {
        this.name = name;
        this.directory = directory;
        this.settings = settings;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public Path directory() {
        return directory;
    }

    @Override
    protected void build() {
        set(settings);
    }
}
