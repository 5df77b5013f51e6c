package org.dronewatch.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.SettingsPath;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.Node;
import org.dronewatch.setting.file.SettingsFile;
import org.dronewatch.world.Ground;
import org.dronewatch.world.Places;
import org.dronewatch.world.WorldSettings;

/**
 * Finds the positions of the places in a scene file while it is read, from the origin in the same file and the surface
 * of the site. The site is loaded for the first place given by its height above the surface, and need not be loaded
 * again for the scene's runs.
 */
final class ScenePlaces {
    private static final String WORLD = "world";

    /** Sources of noise are on the site, but do not change it: they may themselves be given by places. */
    private static final List<String> WITHOUT = List.of("noiseSources");

    private final Path directory;
    private final StorePlace store;
    private final HeldNotes notes = new HeldNotes();
    private final ModelCache models;
    private boolean loaded;
    private boolean handedOver;

    /**
     * Places on a site that has not been loaded.
     *
     * @param directory directory against which relative file names are resolved
     * @param store where prepared sites are kept
     */
    ScenePlaces(Path directory, StorePlace store) {
        this.directory = directory;
        this.store = store;
        this.models = new ModelCache(directory, store, notes);
    }

    /** Keeps lines until there is a receiver for them. */
    private static final class HeldNotes implements Consumer<String> {
        private final List<String> held = new ArrayList<>();
        private Consumer<String> target = held::add;

        @Override
        public void accept(String line) {
            target.accept(line);
        }

        void to(Consumer<String> receiver) {
            held.forEach(receiver);
            held.clear();
            target = receiver;
        }
    }

    /** Whether these places were created with these arguments. */
    boolean isFor(Path names, StorePlace place) {
        return directory.equals(names) && store.equals(place);
    }

    /**
     * The models that were loaded for places, if any; only the first caller gets them.
     *
     * @param receiver receives the lines about these models so far, and all later lines
     */
    Optional<ModelCache> models(Consumer<String> receiver) {
        if (!loaded || handedOver) {
            return Optional.empty();
        }
        handedOver = true;
        notes.to(receiver);
        return Optional.of(models);
    }

    /**
     * The places of a file; empty when its world cannot be read.
     *
     * @param file the scene file; file names in it are relative to its directory
     * @param kinds kinds of settings
     * @param overrides overrides of the file's settings; only those of the world count
     */
    Optional<Places> of(Path file, Kinds kinds, Map<String, String> overrides) {
        Node.Mapping document = SettingsFile.document(file);
        return document.mapping(WORLD)
                .flatMap(part -> world(part.without(WITHOUT), kinds, file))
                .map(world -> overridden(world, overrides))
                .filter(ScenePlaces::isComplete)
                .map(world -> new Places(world, () -> ground(world, document)));
    }

    private static Optional<WorldSettings> world(Node.Mapping part, Kinds kinds, Path file) {
        try {
            Path here = file.resolveSibling("").toAbsolutePath();
            return Optional.of(SettingsFile.read(part, WorldSettings.class, kinds, here, new FormerNames()));
        } catch (InputException e) {
            // Reading the whole file reports this, together with its other mistakes.
            return Optional.empty();
        }
    }

    /** Whether the settings are complete; if not, reading the whole file reports what is missing. */
    private static boolean isComplete(WorldSettings world) {
        try {
            SceneSettings.of(world);
            return true;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }

    private static WorldSettings overridden(WorldSettings world, Map<String, String> overrides) {
        WorldSettings changed = world;
        for (Map.Entry<String, String> override : overrides.entrySet()) {
            String path = override.getKey();
            if (path.startsWith(WORLD + ".")) {
                try {
                    changed = new SettingsPath(path.substring(WORLD.length() + 1)).write(changed, override.getValue());
                } catch (InputException e) {
                    // This override is refused later, when the scene's settings are overridden.
                    return changed;
                }
            }
        }
        return changed;
    }

    private Ground ground(WorldSettings world, Node.Mapping document) {
        loaded = true;
        placing("world.terrain", document, () -> models.readTerrain(world));
        placing("world.buildings", document, () -> models.readBuildings(world));
        for (int i = 0; i < world.models().size(); i++) {
            int number = i;
            placing("world.models." + i, document, () -> models.readModel(world, number));
        }
        return Workers.available() > 1 ? models.ground(world) : inParallel(world);
    }

    /** A scene is described before a run has its threads, and a large site takes long to load on one thread. */
    private Ground inParallel(WorldSettings world) {
        try (Workers workers = new Workers(Runtime.getRuntime().availableProcessors())) {
            return workers.call(() -> models.ground(world));
        }
    }

    private static void placing(String path, Node.Mapping document, Runnable reading) {
        try {
            reading.run();
        } catch (InputException e) {
            throw new InputException(document.markOf(path) + ": " + path + ": " + e.getMessage(), e);
        }
    }
}
