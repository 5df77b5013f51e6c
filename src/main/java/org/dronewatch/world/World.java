package org.dronewatch.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.dronewatch.buildings.land.LandRaster;
import org.dronewatch.bvh.RayPacket;
import org.dronewatch.bvh.RayTraversal;
import org.dronewatch.bvh.TracingIndex;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Hit;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.Ray;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.raster.TileTracer;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Quantity;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.terrain.KnownGround;
import org.jogamp.vecmath.Point3d;

/**
 * The site: everything stationary, as one mesh with one kd-tree over it, and the background noise. World frame: metres,
 * right-handed, x east, y north, z up. Immutable, shared by all threads.
 */
public final class World {
    private final TracingIndex index;
    private final BackgroundNoise backgroundNoise;
    private final List<SurfaceMaterial> surfaces;
    private final Atmosphere atmosphere;
    private final double rain;
    private final Light light;
    private final Map<String, NoiseSource> noiseSources;

    /** Where the ground is known; everywhere if empty. */
    private final Optional<KnownGround> known;

    /** What a map shows on the ground; null for none. */
    private final CoveredGround cover;

    /** The models by the number of the first triangle of each. */
    private final NavigableMap<Integer, SiteModel> models;

    /** What runs have computed from sites and share; null for nothing. */
    private final SiteMemory memory;

    /**
     * A world from a finished tree.
     *
     * @param tree tree over the mesh, in the world's frame
     * @param backgroundNoise the sound of the site without drones and noise sources
     * @param surfaces acoustic surfaces of the mesh's materials
     * @param atmosphere the air
     */
    public World(KDTree tree, BackgroundNoise backgroundNoise, SurfaceSettings surfaces, Atmosphere atmosphere) {
        this(new TracingIndex(tree), backgroundNoise, surfaces, atmosphere);
    }

    /**
     * A world from a finished index. Worlds that share an index share its BVH, too.
     *
     * @param index index of the mesh, in the world's frame
     * @param backgroundNoise the sound of the site without drones and noise sources
     * @param surfaces acoustic surfaces of the mesh's materials
     * @param atmosphere the air
     */
    public World(TracingIndex index, BackgroundNoise backgroundNoise, SurfaceSettings surfaces, Atmosphere atmosphere) {
        this(
                index,
                backgroundNoise,
                index.tree().mesh().materialNames().stream().map(surfaces::of).toList(),
                atmosphere);
    }

    /**
     * A world from a finished tree, with given surfaces instead of those of the table.
     *
     * @param tree tree over the mesh, in the world's frame
     * @param backgroundNoise the sound of the site without drones and noise sources
     * @param surfaces acoustic surfaces, one for each material of the mesh, by the mesh's material numbers
     * @param atmosphere the air
     * @throws IllegalArgumentException when there are more or fewer surfaces than materials
     */
    public World(KDTree tree, BackgroundNoise backgroundNoise, List<SurfaceMaterial> surfaces, Atmosphere atmosphere) {
        this(new TracingIndex(tree), backgroundNoise, surfaces, atmosphere);
    }

    private World(
            TracingIndex index,
            BackgroundNoise backgroundNoise,
            List<SurfaceMaterial> surfaces,
            Atmosphere atmosphere) {
        int materials = index.tree().mesh().materialNames().size();
        if (surfaces.size() != materials) {
            throw new IllegalArgumentException(
                    surfaces.size() + " surfaces for " + materials + " materials: there must be one for each");
        }
        this.index = index;
        this.backgroundNoise = backgroundNoise;
        this.surfaces = List.copyOf(surfaces);
        this.atmosphere = atmosphere;
        this.rain = 0.0;
        this.light = Light.DAY;
        this.noiseSources = Map.of();
        this.known = Optional.empty();
        this.cover = null;
        this.models = new TreeMap<>(Map.of(0, SiteModel.UNNAMED));
        this.memory = null;
    }

    private World(World other, SiteMemory memory) {
        this.index = other.index;
        this.backgroundNoise = other.backgroundNoise;
        this.surfaces = other.surfaces;
        this.atmosphere = other.atmosphere;
        this.rain = other.rain;
        this.light = other.light;
        this.noiseSources = other.noiseSources;
        this.known = other.known;
        this.cover = other.cover;
        this.models = other.models;
        this.memory = memory;
    }

    private World(World other, CoveredGround cover, List<SurfaceMaterial> surfaces) {
        this.index = other.index;
        this.backgroundNoise = other.backgroundNoise;
        this.surfaces = surfaces;
        this.atmosphere = other.atmosphere;
        this.rain = other.rain;
        this.light = other.light;
        this.noiseSources = other.noiseSources;
        this.known = other.known;
        this.cover = cover;
        this.models = other.models;
        this.memory = other.memory;
    }

    private World(
            World other,
            double rain,
            Light light,
            Map<String, NoiseSource> noiseSources,
            Optional<KnownGround> known,
            NavigableMap<Integer, SiteModel> models) {
        this.index = other.index;
        this.backgroundNoise = other.backgroundNoise;
        this.surfaces = other.surfaces;
        this.atmosphere = other.atmosphere;
        this.rain = rain;
        this.light = light;
        this.noiseSources = noiseSources;
        this.known = known;
        this.cover = other.cover;
        this.models = models;
        this.memory = other.memory;
    }

    /** This world with the given rain rate, mm/h, 0 or more. */
    public World withRain(double millimetresPerHour) {
        return new World(
                this,
                Check.notNegative("rain", millimetresPerHour, Quantity.PRECIPITATION),
                light,
                noiseSources,
                known,
                models);
    }

    /** This world with other light settings. */
    public World withLight(Light other) {
        return new World(this, rain, other, noiseSources, known, models);
    }

    /** This world with noise sources by name, in addition to its background. */
    public World withNoiseSources(Map<String, NoiseSource> byName) {
        Map<String, NoiseSource> ordered = Collections.unmodifiableMap(new LinkedHashMap<>(byName));
        return new World(this, rain, light, ordered, known, models);
    }

    /**
     * This world with a record of the models that it was merged from.
     *
     * @param byFirstTriangle models by the number of the first triangle of each in the mesh; the first begins at 0
     * @throws IllegalArgumentException when no model begins at triangle 0
     */
    public World withModels(NavigableMap<Integer, SiteModel> byFirstTriangle) {
        if (!byFirstTriangle.containsKey(0)) {
            throw new IllegalArgumentException(
                    "the first model must begin at triangle 0, but models begin at " + byFirstTriangle.keySet());
        }
        return new World(this, rain, light, noiseSources, known, new TreeMap<>(byFirstTriangle));
    }

    /** This world with ground that is known only within a terrain from files. */
    public World withKnownGround(KnownGround ground) {
        return new World(this, rain, light, noiseSources, Optional.of(ground), models);
    }

    /**
     * This world with the land cover of a map on its ground. The ground is the first of the models that this world was
     * merged from.
     *
     * @param raster the land cover
     * @param settings acoustic surfaces of the land cover's materials
     */
    public World withLandCover(LandRaster raster, SurfaceSettings settings) {
        Integer next = models.higherKey(0);
        int groundTriangles = next == null ? mesh().triangleCount() : next;
        CoveredGround covering = new CoveredGround(mesh(), raster, groundTriangles);
        List<SurfaceMaterial> more = new ArrayList<>(surfaces);
        covering.names().stream().skip(surfaces.size()).map(settings::of).forEach(more::add);
        return new World(this, covering, List.copyOf(more));
    }

    /**
     * This world with a cache of what is computed from its mesh; other worlds of the same index may share that cache.
     */
    public World withMemory(SiteMemory shared) {
        return new World(this, shared);
    }

    /**
     * An object that depends only on the world's mesh and a key: made once where runs share a {@link SiteMemory},
     * otherwise each time.
     *
     * @param key everything else on which the object depends, compared with {@code equals}
     * @param make makes it; must give the same result at any time and on any thread
     */
    public <T extends SiteMemory.Kept> T remembered(Object key, Class<T> type, Supplier<T> make) {
        return memory == null ? make.get() : memory.get(new SiteMemory.Key(index, key), type, make);
    }

    /**
     * Whether the ground below the line between two points is known everywhere: unknown ground may hide anything. In a
     * world of models, all ground is known.
     */
    public boolean isKnown(Position from, Position to) {
        return known.isEmpty() || known.get().containsLine(from.x(), from.y(), to.x(), to.y());
    }

    /** Whether all of the ground is known, as in a world of models. */
    public boolean isKnownEverywhere() {
        return known.isEmpty();
    }

    /** A world of a mesh with negligible background noise (0 dB re 20 uPa, A-weighted). */
    public static World of(TriangleMesh mesh) {
        return new World(KDTree.of(mesh), BackgroundNoise.of(0.0), SurfaceSettings.DEFAULT, Atmosphere.STANDARD);
    }

    /**
     * Merges meshes into one, for a single tree. The source number of each triangle becomes its index in the merged
     * mesh; a single mesh is returned unchanged.
     */
    public static TriangleMesh merge(List<TriangleMesh> meshes) {
        if (meshes.size() == 1) {
            return meshes.get(0);
        }
        int vertexCount = meshes.stream().mapToInt(TriangleMesh::vertexCount).reduce(0, Math::addExact);
        int triangleCount =
                meshes.stream().mapToInt(TriangleMesh::triangleCount).reduce(0, Math::addExact);
        float[] vertices = new float[Math.multiplyExact(3, vertexCount)];
        int[] corners = new int[Math.multiplyExact(3, triangleCount)];
        int[] materials = new int[triangleCount];
        int[] numbers = new int[triangleCount];
        Map<String, Integer> materialNumbers = new LinkedHashMap<>();
        int vertex = 0;
        int triangle = 0;
        for (TriangleMesh mesh : meshes) {
            System.arraycopy(mesh.vertices(), 0, vertices, 3 * vertex, 3 * mesh.vertexCount());
            int[] moved = mesh.corners();
            for (int i = 0; i < moved.length; i++) {
                corners[3 * triangle + i] = vertex + moved[i];
            }
            int[] merged = new int[mesh.materialNames().size()];
            Arrays.fill(merged, -1);
            for (int i = 0; i < mesh.triangleCount(); i++) {
                int own = mesh.material(i);
                if (merged[own] < 0) {
                    String name = mesh.materialNames().get(own);
                    merged[own] = materialNumbers.computeIfAbsent(name, unseen -> materialNumbers.size());
                }
                materials[triangle + i] = merged[own];
                numbers[triangle + i] = triangle + i;
            }
            vertex += mesh.vertexCount();
            triangle += mesh.triangleCount();
        }
        return new TriangleMesh(vertices, corners, materials, numbers, List.copyOf(materialNumbers.keySet()));
    }

    /**
     * The closest hit along a ray; empty if there is none. For convenience: for many rays, use one
     * {@link #newRayTracer()}.
     */
    public Optional<Hit> closestHit(Ray ray) {
        return newRayTracer().closestHit(ray);
    }

    /**
     * Whether an obstacle lies between two points. A surface within {@link Visibility#MARGIN} of either end hides
     * nothing, so that points on surfaces are mutually visible. For convenience: for many segments, use one
     * {@link Visibility}.
     */
    public boolean isOccluded(Point3d from, Point3d to) {
        return !new Visibility(this).isFree(from.x, from.y, from.z, to.x, to.y, to.z);
    }

    /**
     * The height of the highest surface at a point.
     *
     * @param x east, m
     * @param y north, m
     * @return its z in metres, empty where there is none
     */
    public OptionalDouble surfaceHeight(double x, double y) {
        return newGround().height(x, y);
    }

    /**
     * The heights of the highest surfaces, for use by one thread: faster than {@link #surfaceHeight} for many points.
     */
    public Ground newGround() {
        return groundOf(index);
    }

    /** The heights of the highest surfaces of a mesh, for use by one thread. */
    public static Ground groundOf(TracingIndex index) {
        RayTracer traversal = index.newRayTracer();
        double above = index.tree().bounds().maxZ() + 1.0;
        return (x, y) -> traversal.closestHit(x, y, above, 0.0, 0.0, -1.0, 0.0, Double.POSITIVE_INFINITY)
                ? OptionalDouble.of(above - traversal.distance())
                : OptionalDouble.empty();
    }

    /**
     * Whether a point appears to be inside a wall or below the ground: most of the rays from the point that hit a
     * surface, and at least four of them, hit one that faces away from the point. A point on a surface, such as a
     * microphone on a wall, counts as in front of it. Valid for meshes whose triangles are wound counter-clockwise seen
     * from outside, as is usual.
     */
    public boolean isInsideWall(Position position) {
        return new Surroundings(this).showTheirBacks(new Clearance(this).of(position));
    }

    /** A ray tracer for use by one thread. */
    public RayTracer newRayTracer() {
        return index.newRayTracer();
    }

    /**
     * A ray tracer for incoherent rays, such as those of diffuse sound, for use by one thread: faster than
     * {@link #newRayTracer()} where the processor's vector instructions can be used.
     */
    public RayTracer newIncoherentRayTracer() {
        return index.newIncoherentRayTracer();
    }

    /** A packet of incoherent rays that are traced together, for use by one thread; empty if that is not faster. */
    public Optional<RayPacket> newRayPacket() {
        return index.newRayPacket();
    }

    /**
     * A tracer of images, for use by one thread.
     *
     * @param tree the tree of the world, or of a drone
     */
    public TileTracer newTileTracer(KDTree tree) {
        return index.traversal() == RayTraversal.FASTEST
                ? new TileTracer(tree)
                : TileTracer.singly(tree, index.newRayTracer(tree));
    }

    /** The world's tree. */
    public KDTree tree() {
        return index.tree();
    }

    /** The world's mesh. */
    public TriangleMesh mesh() {
        return tree().mesh();
    }

    /**
     * The number of the material of a triangle at a point on it. In a world without land cover, it is that of the mesh.
     *
     * @param x east, m
     * @param y north, m
     */
    public int material(int triangle, double x, double y) {
        return cover == null ? mesh().material(triangle) : cover.material(triangle, x, y);
    }

    /**
     * The numbers of all materials that a triangle may have: that of the mesh and, on the ground, those of the land
     * cover.
     */
    public IntStream materialsOf(int triangle) {
        IntStream own = IntStream.of(mesh().material(triangle));
        return cover == null || !cover.isGround(triangle)
                ? own
                : IntStream.concat(own, IntStream.range(mesh().materialNames().size(), surfaces.size()));
    }

    /** The name of the material where a ray hits. */
    public String materialName(Ray ray, Hit hit) {
        Point3d at = ray.pointAt(hit.distance());
        return materialNames().get(material(hit.triangle(), at.x, at.y));
    }

    /** The names of the materials by their numbers: those of the mesh, and after them those of the land cover. */
    public List<String> materialNames() {
        return cover == null ? mesh().materialNames() : cover.names();
    }

    /** The box around the world, m. */
    public AABB bounds() {
        return tree().bounds();
    }

    /** Whether at least one of the models that it was merged from is known to be terrain. */
    boolean statesTerrain() {
        return models.values().stream().anyMatch(model -> model.role() == ModelRole.TERRAIN);
    }

    /** A triangle of the mesh, as an obstacle in a line of sight. */
    public Obstacle obstacle(int triangle) {
        String material = mesh().materialNames().get(mesh().material(triangle));
        return new Obstacle(models.floorEntry(triangle).getValue(), material);
    }

    /** A triangle of the mesh at a point on it, m, with the material there. */
    Obstacle obstacle(int triangle, double x, double y) {
        return new Obstacle(
                models.floorEntry(triangle).getValue(), materialNames().get(material(triangle, x, y)));
    }

    /** The sound of the site without drones and noise sources. */
    public BackgroundNoise backgroundNoise() {
        return backgroundNoise;
    }

    /** The noise sources of the site, by name. */
    public Map<String, NoiseSource> noiseSources() {
        return noiseSources;
    }

    /** The acoustic surface of each material, by the numbers of {@link #materialNames()}. */
    public List<SurfaceMaterial> surfaces() {
        return surfaces;
    }

    /** The air. */
    public Atmosphere atmosphere() {
        return atmosphere;
    }

    /** Visibility, daylight and turbulence. */
    public Light light() {
        return light;
    }

    /** The rain rate, mm/h. */
    public double rain() {
        return rain;
    }
}
