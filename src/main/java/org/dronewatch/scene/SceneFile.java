package org.dronewatch.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.scenario.InputFiles;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.file.FileHash;
import org.dronewatch.setting.file.SettingsFile;

/** A scene that is described in a file instead of a class: the same settings, written in YAML. */
public final class SceneFile extends Scene {
    private static final long serialVersionUID = 1L;

    private final transient Path file;
    private transient List<FileHash> files = List.of();
    private transient FormerNames formerNames = new FormerNames();

    /**
     * The scene of a file. The file is read when the scene is described, which is when errors in it are found.
     *
     * @param file of at most 1 MiB, in UTF-8; file names in it are relative to its directory
     */
    public SceneFile(Path file) {
        this.file = file;
    }

    /** The scene of a file as a model for a DSOL simulator. */
    public SceneFile(Path file, DevsSimulatorInterface<Double> simulator) {
        super(simulator);
        this.file = file;
    }

    /** Whether a name on the command line looks like that of a scene file. */
    public static boolean isFileName(String name) {
        String small = name.toLowerCase(Locale.ROOT);
        return small.endsWith(".yaml") || small.endsWith(".yml");
    }

    /** The file's name without its extension. */
    @Override
    public String name() {
        Path name = file.getFileName();
        return name == null ? "scene" : name.toString().replaceFirst("\\.[A-Za-z]+$", "");
    }

    /** The file's directory. */
    @Override
    public Path directory() {
        Path parent = file.toAbsolutePath().normalize().getParent();
        return parent == null ? Path.of("") : parent;
    }

    /** The scene file, then the entries of the user's catalogue that it uses. */
    @Override
    public List<FileHash> files() {
        return files;
    }

    @Override
    FormerNames formerNames() {
        return formerNames;
    }

    @Override
    Optional<String> placeOf(String path) {
        return Optional.of(SettingsFile.document(file).markOf(path).toString());
    }

    /**
     * Reads the file.
     *
     * @throws InputException with a line for each mistake: file, line, column, setting, value and limit
     */
    @Override
    protected void build() {
        Catalog catalog = Catalog.beside(directory());
        formerNames = catalog.formerNames();
        set(SettingsFile.read(file, SceneSettings.class, SensorKinds.kinds(catalog), formerNames));
        List<Path> read = new ArrayList<>(List.of(file));
        read.addAll(catalog.filesRead());
        files = read.stream().map(InputFiles::hash).toList();
    }
}
