package org.dronewatch.scene;

import java.nio.file.Path;

/** A scene whose site is a level floor of 18 m x 18 m at a height of 0 m, which hides nothing. */
public abstract class FloorScene extends Scene {
    private static final long serialVersionUID = 1L;

    /** Where its models are. */
    public static final Path MODELS = Path.of("src", "test", "resources", "models");

    @Override
    public final Path directory() {
        return MODELS;
    }

    /** Makes the floor the site. */
    protected final void loadFloor() {
        loadWorld(load("floor.obj"));
    }
}
