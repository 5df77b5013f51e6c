package org.dronewatch.run.store;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.dronewatch.buildings.BuildingLoader;
import org.dronewatch.buildings.BuildingSettings;
import org.dronewatch.buildings.LoadedBuildings;
import org.dronewatch.buildings.io.MapFiles;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.SahCost;
import org.dronewatch.kdtree.TreeParts;
import org.dronewatch.parallel.LongTask;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.terrain.KnownGround;
import org.dronewatch.terrain.LoadedTerrain;
import org.dronewatch.terrain.TerrainGround;
import org.dronewatch.terrain.TerrainLoader;
import org.dronewatch.terrain.TerrainSettings;
import org.dronewatch.terrain.io.ElevationFiles;

/**
 * Prepares the parts of a site, or takes them from the store if an earlier run of the program kept them there; the
 * result is the same. Parts that took at least {@value SiteStore#WORTH} s to prepare are kept. The tree over a mesh is
 * looked up by the mesh itself, so it does not matter from which files the mesh came; this process remembers the most
 * recent trees, even without a store. Not thread-safe.
 */
public final class PreparedSites {
    private static final double NANO = 1e-9;

    /** The tree over fewer triangles is built faster than it is found in the store. */
    private static final int SMALL = 20_000;

    /** Building the tree over more triangles takes more than a second. */
    private static final int MANY = 500_000;

    private final Path directory;
    private final SiteStore store;
    private final TreeMemory memory;
    private final int small;
    private final Consumer<String> progress;

    /**
     * Prepares sites.
     *
     * @param directory directory against which relative paths are resolved
     * @param place where prepared sites are kept
     * @param progress receives a line before each step that takes seconds, and one if the store cannot be written
     */
    public PreparedSites(Path directory, StorePlace place, Consumer<String> progress) {
        this(directory, SiteStore.standard(place, progress), TreeMemory.SHARED, SMALL, progress);
        CodeStamp.prepare();
    }

    /**
     * Sites prepared with another store.
     *
     * @param small number of triangles below which the tree over a mesh is not looked up
     */
    PreparedSites(Path directory, SiteStore store, TreeMemory memory, int small, Consumer<String> progress) {
        this.directory = directory;
        this.store = store;
        this.memory = memory;
        this.small = small;
        this.progress = progress;
    }

    /**
     * Prepares a terrain.
     *
     * @throws InputException as {@link TerrainLoader#load}
     */
    public PreparedTerrain terrain(TerrainSettings settings, Origin origin) {
        Optional<PreparedTerrain> kept = store.mayFind()
                ? hashes(settings).flatMap(files -> store.find(key(settings, origin, files), StoredForms.TERRAIN))
                : Optional.empty();
        if (kept.isPresent()) {
            return kept.get();
        }
        long start = System.nanoTime();
        LoadedTerrain terrain = new TerrainLoader(directory, progress).load(settings, origin);
        PreparedTerrain prepared = new PreparedTerrain(terrain, new KnownGround(new TerrainGround(terrain.mesh())));
        store.keep(() -> key(settings, origin, terrain.files()), StoredForms.TERRAIN, prepared, since(start));
        return prepared;
    }

    /** The hashes of the files as they are now; empty if one cannot be read, which the loader reports. */
    private Optional<List<FileHash>> hashes(TerrainSettings settings) {
        try {
            ElevationFiles source = new ElevationFiles(directory);
            return Optional.of(settings.allFiles().stream().map(source::hash).toList());
        } catch (InputException e) {
            return Optional.empty();
        }
    }

    private static StoreKey key(TerrainSettings settings, Origin origin, List<FileHash> files) {
        return StoreKey.of("terrain", files, settings, origin);
    }

    /**
     * Prepares buildings.
     *
     * @param terrain the ground on which they stand, which must be the one that {@code terrainSettings} describe; if
     *     empty, they stand at the level of the origin
     * @param terrainSettings settings of that ground
     * @throws InputException as {@link BuildingLoader#load}
     */
    public LoadedBuildings buildings(
            BuildingSettings settings,
            Origin origin,
            Optional<TerrainSettings> terrainSettings,
            Optional<PreparedTerrain> terrain) {
        List<FileHash> ground =
                terrain.map(prepared -> prepared.terrain().files()).orElse(List.of());
        Optional<LoadedBuildings> kept = store.mayFind()
                ? hash(settings)
                        .flatMap(file ->
                                store.find(key(settings, origin, terrainSettings, ground, file), StoredForms.BUILDINGS))
                : Optional.empty();
        if (kept.isPresent()) {
            return kept.get();
        }
        long start = System.nanoTime();
        LoadedBuildings built = new BuildingLoader(directory, progress)
                .load(settings, origin, terrain.map(prepared -> prepared.ground()
                        .ground()));
        double seconds = since(start);
        store.keep(
                () -> key(settings, origin, terrainSettings, ground, built.file()),
                StoredForms.BUILDINGS,
                built,
                seconds);
        return built;
    }

    private Optional<FileHash> hash(BuildingSettings settings) {
        try {
            return settings.file().map(new MapFiles(directory)::hash);
        } catch (InputException e) {
            return Optional.empty();
        }
    }

    private static StoreKey key(
            BuildingSettings settings,
            Origin origin,
            Optional<TerrainSettings> terrain,
            List<FileHash> ground,
            FileHash file) {
        return StoreKey.of("buildings", List.of(file), settings, origin, terrain, ground);
    }

    /** Prepares the tree over a mesh. */
    public KDTree tree(TriangleMesh mesh, SahCost costs) {
        if (mesh.triangleCount() < small) {
            return grown(mesh, costs);
        }
        StoreKey key = StoreKey.of("tree", mesh, costs);
        Optional<KDTree> kept =
                memory.find(key).or(() -> store.find(key, StoredForms.TREE)).flatMap(parts -> over(parts, mesh, costs));
        long start = System.nanoTime();
        KDTree tree = kept.orElseGet(() -> grown(mesh, costs));
        TreeParts parts = TreeParts.of(tree);
        memory.keep(key, parts);
        if (kept.isEmpty()) {
            store.keep(() -> key, StoredForms.TREE, parts, since(start));
        }
        return tree;
    }

    private KDTree grown(TriangleMesh mesh, SahCost costs) {
        int count = mesh.triangleCount();
        String what = String.format(Locale.ROOT, "building the tree over %,d triangles", count);
        try (LongTask task = LongTask.begin(what, count, count >= MANY, progress)) {
            return KDTree.of(mesh, costs, task);
        }
    }

    private static Optional<KDTree> over(TreeParts parts, TriangleMesh mesh, SahCost costs) {
        try {
            return Optional.of(parts.over(mesh, costs));
        } catch (IllegalArgumentException e) {
            // A file with a right checksum, but not written by this program.
            return Optional.empty();
        }
    }

    private static double since(long start) {
        return NANO * (System.nanoTime() - start);
    }
}
