package org.dronewatch.run.model;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.WeakHashMap;
import java.util.function.Consumer;
import org.dronewatch.buildings.LoadedBuildings;
import org.dronewatch.buildings.land.LandClass;
import org.dronewatch.bvh.TracingIndex;
import org.dronewatch.bvh.TracingSettings;
import org.dronewatch.flight.FlightsFile;
import org.dronewatch.flight.file.FlightFromFile;
import org.dronewatch.flight.file.FlightSource;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.LoadedModel;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.run.store.PreparedSites;
import org.dronewatch.run.store.PreparedTerrain;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.terrain.KnownGround;
import org.dronewatch.terrain.LoadedTerrain;
import org.dronewatch.world.Ground;
import org.dronewatch.world.SiteMemory;
import org.dronewatch.world.SiteModel;
import org.dronewatch.world.World;
import org.dronewatch.world.WorldSettings;

/**
 * Loads each model and builds each tree once, however many runs need them, and measures how long that takes; reads each
 * file of recorded flights once. Of models and sites that differ from run to run, only the latest are kept.
 * Thread-safe; calls are serialised.
 */
public final class ModelCache {
    private static final double NANO = 1e-9;

    /** Where the site or a drone's model varies from run to run, only the latest are kept: there may be a million. */
    private static final int MOST_SITES = 64;

    private static final int MOST_WARNINGS = 10_000;

    private final ModelLoader loader;
    private final Consumer<String> notes;
    private final Recent<SiteKeys.Model, LoadedModel> models = new Recent<>(MOST_SITES);
    private final PreparedSites sites;
    private final Recent<SiteKeys.Place, PreparedTerrain> terrains = new Recent<>(MOST_SITES);
    private final Recent<SiteKeys.Town, LoadedBuildings> towns = new Recent<>(MOST_SITES);
    private final Recent<SiteKeys.Site, TracingIndex> indexes = new Recent<>(MOST_SITES);
    private final Map<String, List<FileHash>> files = new LinkedHashMap<>();
    private final FlightFiles flightFiles;
    private final Set<String> noted = new HashSet<>();
    private final Set<KDTree> examined = Collections.newSetFromMap(new WeakHashMap<>());
    private Optional<SiteMemory> memory = Optional.empty();
    private double loadSeconds;
    private double buildSeconds;

    /**
     * An empty cache; prepared sites are kept in the {@link StorePlace#ofProcess store of this process}.
     *
     * @param directory directory against which relative paths are resolved
     * @param notes receives a line for each file read, and each warning
     */
    public ModelCache(Path directory, Consumer<String> notes) {
        this(directory, StorePlace.ofProcess(), notes);
    }

    /**
     * An empty cache.
     *
     * @param directory directory against which relative paths are resolved
     * @param place where prepared sites are kept
     * @param notes receives a line for each file read, and each warning
     */
    public ModelCache(Path directory, StorePlace place, Consumer<String> notes) {
        this.loader = new ModelLoader(directory);
        this.notes = notes;
        this.sites = new PreparedSites(directory, place, notes);
        this.flightFiles = new FlightFiles(directory, (name, hash) -> files.put(name, List.of(hash)), notes);
    }

    /** Lets the worlds of all runs that are set up from now on share a cache. */
    public synchronized void share(SiteMemory shared) {
        memory = Optional.of(shared);
    }

    /** The given world with the runs' shared cache attached, if there is one. */
    public synchronized World remembering(World world) {
        return memory.map(world::withMemory).orElse(world);
    }

    /** Reads a drone's model, once. */
    public synchronized void read(ModelSettings settings) {
        model(SiteKeys.Model.of(settings));
    }

    /**
     * Reads one of the models of a world, once.
     *
     * @param number index of the model in the world's list
     */
    public synchronized void readModel(WorldSettings world, int number) {
        model(SiteKeys.Model.of(world).get(number));
    }

    private LoadedModel model(SiteKeys.Model model) {
        return models.computeIfAbsent(model, this::load);
    }

    /**
     * Reads the recorded flights of a file, once.
     *
     * @param file name of the file in the settings
     * @throws InputException when the file cannot be read, or is invalid
     */
    public synchronized FlightsFile flights(String file) {
        return flightFiles.recorded(file);
    }

    /**
     * Reads a flight from a file of another program, once.
     *
     * @throws InputException when the file cannot be read, or is invalid
     */
    public synchronized FlightSource flight(FlightFromFile settings) {
        return flightFiles.of(settings);
    }

    /** Reads the terrain of a world, if it has one, once. */
    public synchronized void readTerrain(WorldSettings world) {
        SiteKeys.Place.of(world).ifPresent(this::terrain);
    }

    private LoadedTerrain terrain(SiteKeys.Place place) {
        return prepared(place).terrain();
    }

    private synchronized PreparedTerrain prepared(SiteKeys.Place place) {
        PreparedTerrain prepared = terrains.get(place);
        if (prepared == null) {
            long start = System.nanoTime();
            prepared = sites.terrain(place.terrain(), place.origin());
            loadSeconds += NANO * (System.nanoTime() - start);
            terrains.put(place, prepared);
            LoadedTerrain known = prepared.terrain();
            for (int i = 0; i < known.files().size(); i++) {
                files.put(
                        place.terrain().allFiles().get(i), List.of(known.files().get(i)));
            }
            known.description().forEach(notes);
            known.warnings().forEach(this::warn);
        }
        return prepared;
    }

    /** Reads the buildings of a world, if it has a map of them, once. */
    public synchronized void readBuildings(WorldSettings world) {
        SiteKeys.Town.of(world).ifPresent(this::buildings);
    }

    private synchronized LoadedBuildings buildings(SiteKeys.Town town) {
        LoadedBuildings known = towns.get(town);
        if (known == null) {
            Optional<PreparedTerrain> ground = town.terrain().map(this::prepared);
            long start = System.nanoTime();
            known = sites.buildings(
                    town.buildings(), town.origin(), town.terrain().map(SiteKeys.Place::terrain), ground);
            loadSeconds += NANO * (System.nanoTime() - start);
            towns.put(town, known);
            files.put(town.buildings().file().orElseThrow(), List.of(known.file()));
            known.description().forEach(notes);
            known.warnings().forEach(this::warn);
        }
        return known;
    }

    /** Where the ground of a world is known; empty for a world without a terrain from files. */
    public synchronized Optional<KnownGround> knownGround(WorldSettings world) {
        return SiteKeys.Place.of(world).map(place -> prepared(place).ground());
    }

    /** Descriptions of the terrain and the buildings that were read for a world, in lines for the report. */
    public synchronized List<String> siteNotes(WorldSettings world) {
        List<String> lines = new ArrayList<>();
        SiteKeys.Place.of(world).ifPresent(place -> lines.addAll(terrain(place).description()));
        SiteKeys.Town.of(world).ifPresent(town -> lines.addAll(buildings(town).description()));
        return lines;
    }

    /** The buildings of a world's map, if it has one. */
    public synchronized Optional<LoadedBuildings> buildings(WorldSettings world) {
        return SiteKeys.Town.of(world).map(this::buildings);
    }

    /** The ray-tracing index over a world's terrain, buildings and models, merged into one mesh. */
    public synchronized TracingIndex index(WorldSettings world) {
        return indexes.computeIfAbsent(SiteKeys.Site.of(world), this::build);
    }

    /** The ray-tracing index over a drone's model. */
    public synchronized TracingIndex index(ModelSettings model, TracingSettings tracing) {
        return indexes.computeIfAbsent(SiteKeys.Site.of(model, tracing), this::build);
    }

    /**
     * The heights of the highest surfaces of a world, for use by one thread; loads what is not loaded yet.
     *
     * @throws InputException when a file cannot be read, or is invalid
     */
    public Ground ground(WorldSettings world) {
        return World.groundOf(index(world));
    }

    /** The colours of a world's materials, by name: red, green and blue in the lowest 24 bits. */
    public synchronized Map<String, Integer> colours(WorldSettings world) {
        Map<String, Integer> colours = new HashMap<>();
        for (SiteKeys.Model model : SiteKeys.Model.of(world)) {
            model(model).colours().forEach(colours::putIfAbsent);
        }
        SiteKeys.Town.of(world).ifPresent(town -> buildings(town).colours().forEach(colours::putIfAbsent));
        world.terrain().ifPresent(terrain -> colours.putIfAbsent(terrain.material(), terrain.colour()));
        if (buildings(world).flatMap(LoadedBuildings::landCover).isPresent()) {
            LandClass.all().forEach(land -> colours.putIfAbsent(land.material(), land.colour()));
        }
        return colours;
    }

    /** The colours of the materials of a drone's model, by name. */
    public synchronized Map<String, Integer> colours(ModelSettings model) {
        return model(SiteKeys.Model.of(model)).colours();
    }

    /** A world's terrain, buildings and models, in this order, by the first triangle of each in the tree's mesh. */
    public synchronized NavigableMap<Integer, SiteModel> firstTriangles(WorldSettings world) {
        NavigableMap<Integer, SiteModel> starts = new TreeMap<>();
        int next = 0;
        Optional<SiteKeys.Place> place = SiteKeys.Place.of(world);
        if (place.isPresent()) {
            starts.put(next, SiteModel.of(place.get().terrain()));
            next += terrain(place.get()).mesh().triangleCount();
        }
        Optional<SiteKeys.Town> town = SiteKeys.Town.of(world);
        if (town.isPresent()) {
            starts.put(next, SiteModel.of(town.get().buildings()));
            next += buildings(town.get()).mesh().triangleCount();
            int woods = buildings(town.get()).woods().triangleCount();
            if (woods > 0) {
                starts.put(next, SiteModel.ofWoods(town.get().buildings()));
                next += woods;
            }
        }
        for (SiteKeys.Model model : SiteKeys.Model.of(world)) {
            starts.put(next, SiteModel.of(model.settings()));
            next += model(model).mesh().triangleCount();
        }
        return starts;
    }

    /**
     * The files of each model or recorded flight, by its name in the settings, in the order in which they were read.
     */
    public synchronized Map<String, List<FileHash>> files() {
        return new LinkedHashMap<>(files);
    }

    private TracingIndex build(SiteKeys.Site site) {
        List<TriangleMesh> meshes = new ArrayList<>();
        site.terrain().ifPresent(place -> meshes.add(terrain(place).mesh()));
        site.town().ifPresent(town -> {
            meshes.add(buildings(town).mesh());
            if (buildings(town).woods().triangleCount() > 0) {
                meshes.add(buildings(town).woods());
            }
        });
        site.models().forEach(model -> meshes.add(model(model).mesh()));
        long start = System.nanoTime();
        KDTree tree = sites.tree(World.merge(meshes), site.tracing().costs());
        TracingIndex index = new TracingIndex(tree, site.tracing().traversal());
        buildSeconds += NANO * (System.nanoTime() - start);
        return index;
    }

    private synchronized LoadedModel load(SiteKeys.Model which) {
        long start = System.nanoTime();
        LoadedModel model = loader.load(which.settings(), which.origin());
        loadSeconds += NANO * (System.nanoTime() - start);
        files.put(which.settings().file(), model.files());
        notes.accept("read " + model.describe());
        model.warnings().forEach(warning -> notes.accept("warning: " + warning));
        return model;
    }

    /**
     * Claims, for the calling run, the check for vertical offsets between a site's models and the ground, so that only
     * one of the runs that share the site performs the check.
     *
     * @param site the tree over the site
     * @return whether no run has claimed the check before
     */
    public synchronized boolean claimExamination(KDTree site) {
        return examined.add(site);
    }

    /** Warns, once for each message; after ten thousand messages, further ones are dropped. */
    public synchronized void warn(String text) {
        if (noted.size() < MOST_WARNINGS && noted.add(text)) {
            notes.accept("warning: " + text);
        }
    }

    /** How long reading files has taken so far, s. */
    public synchronized double loadSeconds() {
        return loadSeconds;
    }

    /** How long building trees has taken so far, s. */
    public synchronized double buildSeconds() {
        return buildSeconds;
    }
}
