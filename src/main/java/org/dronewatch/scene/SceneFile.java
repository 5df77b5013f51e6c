package org.dronewatch.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.geo.features.Features;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.scenario.InputFiles;
import org.dronewatch.scenario.PlaceForms;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenario.SweepSettings;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.SettingsFile;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.world.Places;

/** A scene that is described in a YAML file instead of a class. */
public final class SceneFile extends Scene {
    private static final long serialVersionUID = 1L;

    /** The settings on which the positions of places depend. */
    private static final Pattern OF_THE_SITE = Pattern.compile("world\\.(origin|terrain|models|buildings)\\b.*");

    private final transient Path file;
    private transient List<FileHash> files = List.of();
    private transient FormerNames formerNames = new FormerNames();
    private transient Map<String, String> overrides = Map.of();
    private transient Optional<ScenePlaces> places = Optional.empty();

    /**
     * A scene from a file. The file is read, and errors in it are found, when the scene is described.
     *
     * @param file the file, of at most 1 MiB, in UTF-8; file names in it are relative to its directory
     */
    public SceneFile(Path file) {
        this.file = file;
    }

    /** A scene from a file as a model for a DSOL simulator. */
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

    @Override
    void prepare(Map<String, String> changes, Path names, StorePlace store) {
        overrides = new LinkedHashMap<>(changes);
        places = places.filter(known -> known.isFor(names, store)).or(() -> Optional.of(new ScenePlaces(names, store)));
    }

    @Override
    ModelCache models(Path names, StorePlace store, Consumer<String> notes) {
        return places.filter(known -> known.isFor(names, store))
                .flatMap(known -> known.models(notes))
                .orElseGet(() -> super.models(names, store, notes));
    }

    @Override
    Function<Optional<String>, Features> maps() {
        return new FeatureFiles(file);
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
        Kinds kinds = SensorKinds.kinds(catalog);
        ScenePlaces site = places.orElseGet(() -> new ScenePlaces(directory(), StorePlace.ofProcess()));
        places = Optional.of(site);
        FeatureFiles maps = new FeatureFiles(file);
        PlacedOnce placed = new PlacedOnce(() -> site.of(file, kinds, overrides));
        SceneSettings settings =
                SettingsFile.read(file, SceneSettings.class, PlaceForms.in(kinds, placed, maps), formerNames);
        if (placed.isUsed()) {
            settings.sweep().ifPresent(this::checkSite);
        }
        set(settings);
        List<Path> read = new ArrayList<>(List.of(file));
        read.addAll(catalog.filesRead());
        read.addAll(maps.read());
        files = read.stream().map(InputFiles::hash).toList();
    }

    /** Places are found once, for all runs of a sweep. */
    private void checkSite(SweepSettings sweep) {
        if (OF_THE_SITE.matcher(sweep.parameter()).matches()) {
            String path = "sweep.parameter";
            throw new InputException(placeOf(path).orElse("") + ": " + path + ": '" + sweep.parameter()
                    + "' cannot be swept in a scene with places given by latitude and longitude or above the surface: these"
                    + " are located only once, on a single site");
        }
    }

    /** The places of a file, found when they are first wanted. */
    private static final class PlacedOnce implements Supplier<Optional<Places>> {
        private final Supplier<Optional<Places>> source;
        private Optional<Places> places = Optional.empty();
        private boolean used;

        PlacedOnce(Supplier<Optional<Places>> source) {
            this.source = source;
        }

        boolean isUsed() {
            return used;
        }

        @Override
        public Optional<Places> get() {
            if (!used) {
                places = source.get();
                used = true;
            }
            return places;
        }
    }
}
