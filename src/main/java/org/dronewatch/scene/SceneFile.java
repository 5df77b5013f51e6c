package org.dronewatch.scene;

import java.nio.file.Path;
import java.util.Locale;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.file.SettingsFile;

/** A scene that is described in a file instead of a class: the same settings, written in YAML. */
public final class SceneFile extends Scene {
    private static final long serialVersionUID = 1L;

    private final transient Path file;

    /**
     * The scene of a file. It is read when the scene is described, so a wrong file is found there.
     *
     * @param file of at most 1 MiB, in UTF-8; names of files in it start from its directory
     */
    public SceneFile(Path file) {
        this.file = file;
    }

    /** Whether a name that a person gives to a command looks like that of a scene file. */
    public static boolean isFileName(String name) {
        String small = name.toLowerCase(Locale.ROOT);
        return small.endsWith(".yaml") || small.endsWith(".yml");
    }

    /** The file's name without its ending. */
    @Override
    public String name() {
        Path name = file.getFileName();
        return name == null ? "scene" : name.toString().replaceFirst("\\.[A-Za-z]+$", "");
    }

    /** That of the file. */
    @Override
    public Path directory() {
        Path parent = file.toAbsolutePath().normalize().getParent();
        return parent == null ? Path.of("") : parent;
    }

    /**
     * Reads the file.
     *
     * @throws InputException with a line for each mistake: file, line, column, setting, value and limit
     */
    @Override
    protected void build() {
        set(SettingsFile.read(file, SceneSettings.class, SensorKinds.kinds(Catalog.beside(directory()))));
    }
}
