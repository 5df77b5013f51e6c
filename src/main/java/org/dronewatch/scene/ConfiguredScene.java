package org.dronewatch.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.flight.Steered;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.scenario.InputFiles;
import org.dronewatch.scenario.Overrides;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenario.SceneWriter;
import org.dronewatch.scenario.SweepSettings;
import org.dronewatch.setting.CurrentPath;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.SettingsPath;

/** A scene with its overrides: the settings of its runs, and where each was set. Nothing is loaded. */
final class ConfiguredScene {
    private final Scene scene;
    private final Map<String, String> overrides = new LinkedHashMap<>();
    /** Overridden paths as typed by the user, keyed by the same paths with current names. */
    private final Map<String, String> overridden = new LinkedHashMap<>();

    private FormerNames formerNames = new FormerNames();
    private Path directory;
    private StorePlace store = StorePlace.ofProcess();
    private Catalog catalog;

    ConfiguredScene(Scene scene) {
        this.scene = scene;
        directory(scene.directory());
    }

    /** Overrides a setting, taking precedence over earlier overrides. */
    void set(String path, String value) {
        overrides.put(path, value);
    }

    /** Sets the directory against which relative paths are resolved, and which contains the user's catalogue files. */
    void directory(Path path) {
        this.directory = path;
        this.catalog = Catalog.beside(path);
    }

    Path directory() {
        return directory;
    }

    /** Sets where prepared sites are kept. */
    void store(StorePlace place) {
        this.store = place;
    }

    StorePlace store() {
        return store;
    }

    /** The models of its runs. */
    ModelCache models(Consumer<String> notes) {
        return scene.models(directory, store, notes);
    }

    /** Settings of the scene as a scene file. */
    String text(SceneSettings settings, Path file) {
        return SceneWriter.text(scene.name(), settings, directory, file);
    }

    /** The files in which the settings are written, without the models. */
    InputFiles inputs(SceneSettings settings) {
        return InputFiles.of(settings).withScene(scene.files(), catalog.filesRead());
    }

    /**
     * The scene's settings with all overrides, checked; nothing is loaded.
     *
     * @throws InputException when an override does not fit
     */
    SceneSettings settings() {
        formerNames = new FormerNames();
        overridden.clear();
        SceneSettings settings = described();
        for (Map.Entry<String, String> override : overrides.entrySet()) {
            String path = currentPath(settings, override.getKey());
            boolean sweptPath =
                    path.equals(sweptPath(settings, new FormerNames()).orElse(""));
            try {
                settings = writer().override(settings, override.getKey(), override.getValue());
            } catch (InputException e) {
                throw new InputException("--set " + e.getMessage(), e);
            }
            settings = sweptPath ? settings.withoutSweep() : settings;
        }
        settings = withCurrentSweep(settings);
        settingsOfRuns(settings);
        return settings;
    }

    /** The path of an override with current names; no other override may refer to it under another name. */
    private String currentPath(SceneSettings settings, String path) {
        String option = "--set " + path;
        String current = new CurrentPath(settings, formerNames).of(path, option);
        String other = overridden.putIfAbsent(current, path);
        if (other != null) {
            throw new InputException(option + ": it is already given as --set " + other
                    + ": both are names of the same setting, now called '" + current + "'");
        }
        return current;
    }

    /** The path of the swept setting with current names. */
    private Optional<String> sweptPath(SceneSettings settings, FormerNames used) {
        return settings.sweep().map(SweepSettings::parameter).map(path -> new CurrentPath(settings, used)
                .of(path, scene.placeOf("sweep.parameter").orElse("sweep of " + path)));
    }

    /** The settings with the swept parameter under its current name, as used in results and files. */
    private SceneSettings withCurrentSweep(SceneSettings settings) {
        return sweptPath(settings, formerNames)
                .filter(path -> !path.equals(settings.sweep().orElseThrow().parameter()))
                .map(path -> new SettingsPath("sweep.parameter").write(settings, path))
                .orElse(settings);
    }

    /** The settings with another value, as a sweep writes it. */
    SceneSettings write(SceneSettings settings, String path, String value) {
        return writer().write(settings, path, value);
    }

    /** A line for each former name of a setting found by {@link #settings()}, keyed by the renamed setting. */
    Map<FormerNames.Renamed, String> formerNames() {
        FormerNames all = new FormerNames();
        all.addAll(scene.formerNames());
        all.addAll(catalog.formerNames());
        all.addAll(formerNames);
        return all.warnings();
    }

    private Overrides writer() {
        return new Overrides(catalog);
    }

    private SceneSettings described() {
        scene.prepare(overrides, directory, store);
        try {
            return scene.describe();
        } catch (IllegalArgumentException e) {
            throw new InputException("scene " + scene.name() + ": " + e.getMessage(), e);
        }
    }

    /**
     * The settings of each run; reads every value of the sweep, so that the last cannot fail after the first has run.
     */
    List<SceneSettings> settingsOfRuns(SceneSettings settings) {
        Optional<SweepSettings> sweep = settings.sweep();
        if (sweep.isEmpty()) {
            return List.of(settings);
        }
        SettingsPath path = new SettingsPath(sweep.get().parameter());
        List<SceneSettings> runs = new ArrayList<>();
        String here = "sweep.parameter";
        try {
            path.read(settings);
            here = "sweep.from";
            List<String> values = sweep.get().values(path.quantity(settings));
            for (int i = 0; i < values.size(); i++) {
                here = "sweep.values." + i;
                runs.add(writer().write(settings.asRunWith(i, values.get(i)), path.toString(), values.get(i)));
            }
        } catch (IllegalArgumentException | InputException e) {
            throw new InputException(placeOf(here) + "sweep of " + path + ": " + e.getMessage(), e);
        }
        return runs;
    }

    /**
     * Checks a run without a pilot: a steered drone would only hover, which is not what its scene intends.
     *
     * @throws InputException when a drone is steered
     */
    void checkUnpiloted(SceneSettings settings) {
        settings.drones().forEach((id, drone) -> {
            if (drone.flight() instanceof Steered) {
                String path = "drones." + id + ".flight";
                throw new InputException(placeOf(path) + path + ": is steered, but no pilot steers '" + id
                        + "': set a pilot with SceneRunner.pilot(...), override pilot() in a Java scene, steer from a DSOL"
                        + " model that holds the scene, or use another kind of flight");
            }
        });
    }

    /** The beginning of a message about a setting: the option that set it or its parent, or its line in a file. */
    private String placeOf(String path) {
        return placeOf(path, set -> path.equals(set) || path.startsWith(set + "."));
    }

    /**
     * The beginning of a message about a file that a setting names: an error in the file is not due to an override of
     * its scale.
     */
    String placeOfFile(String path) {
        return placeOf(path, set -> set.equals(path) || set.equals(path + ".file"));
    }

    private String placeOf(String path, Predicate<String> isBehind) {
        for (Map.Entry<String, String> override : overridden.entrySet()) {
            if (isBehind.test(override.getKey())) {
                return "--set " + override.getValue() + "=" + overrides.get(override.getValue()) + ": ";
            }
        }
        return scene.placeOf(path).map(place -> place + ": ").orElse("");
    }
}
