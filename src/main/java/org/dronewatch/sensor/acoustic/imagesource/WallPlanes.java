package org.dronewatch.sensor.acoustic.imagesource;

import java.util.Arrays;
import java.util.Collections;
import java.util.Map;
import java.util.WeakHashMap;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.world.World;

/**
 * The planes in which a mesh reflects specularly: all triangles in one plane, of any material and winding, are one
 * wall. The result does not depend on the directions of the axes. Immutable.
 */
public final class WallPlanes {
    /** The wall number of a triangle that does not reflect specularly. */
    public static final int NONE = -1;

    /**
     * The greatest distance of a corner from the plane to which its triangle is assigned, as a fraction of the size of
     * the mesh: coordinates of single precision are accurate to 6e-8 of that size, and the plane of a small triangle is
     * extended over the wall.
     */
    private static final double RELATIVE_TOLERANCE = 1e-6;

    private static final double LEAST_TOLERANCE = 1e-5;

    private static final double ALMOST_PARALLEL = 0.99;

    /** The planes of worlds in use: many sensors share one world. */
    private static final Map<World, WallPlanes> KNOWN = Collections.synchronizedMap(new WeakHashMap<>());

    private static final int NUMBERS = 4;
    private static final int BOUNDS = 6;

    private final double[] planes;
    private final double[] bounds;
    private final int[] triangleOf;
    private final int[] wallOf;
    private final boolean[] isMixed;
    private final double tolerance;
    private final WallTree tree;

    /** The planes of a world; they are found once per world. */
    public static WallPlanes of(World world) {
        return KNOWN.computeIfAbsent(world, WallPlanes::found);
    }

    private static WallPlanes found(World world) {
        BandSurfaces surfaces = new BandSurfaces(world.surfaces());
        TriangleMesh mesh = world.mesh();
        return new WallPlanes(
                mesh,
                triangle -> surfaces.mirrors(mesh.material(triangle))
                        || world.materialsOf(triangle).anyMatch(surfaces::mirrors));
    }

    /** The planes of a mesh whose triangles each have one material. */
    public WallPlanes(TriangleMesh mesh, BandSurfaces surfaces) {
        this(mesh, triangle -> surfaces.mirrors(mesh.material(triangle)));
    }

    private WallPlanes(TriangleMesh mesh, IntPredicate mirrors) {
        this.tolerance = Math.max(LEAST_TOLERANCE, RELATIVE_TOLERANCE * Math.max(1.0, mesh.greatestCoordinate()));
        this.wallOf = new int[mesh.triangleCount()];
        Arrays.fill(wallOf, NONE);
        WallGrouping grouping = new WallGrouping(mesh, tolerance);
        // The largest triangle has the most accurate plane, so it comes first: the order is by area, then by number.
        long[] order = IntStream.range(0, wallOf.length)
                .filter(triangle -> mirrors.test(triangle) && grouping.area(triangle) > 0.0f)
                .mapToLong(triangle -> (long) -Float.floatToIntBits(grouping.area(triangle)) << Integer.SIZE | triangle)
                .sorted()
                .toArray();
        for (long triangle : order) {
            wallOf[(int) triangle] = grouping.add((int) triangle);
        }
        this.planes = grouping.planes();
        this.triangleOf = grouping.triangles();
        this.bounds = bounds(mesh);
        this.isMixed = mixed(mesh);
        // This reads the planes, so it comes last: all other fields are set.
        this.tree = new WallTree(this);
    }

    private double[] bounds(TriangleMesh mesh) {
        double[] boxes = new double[BOUNDS * triangleOf.length];
        for (int wall = 0; wall < triangleOf.length; wall++) {
            Arrays.fill(boxes, BOUNDS * wall, BOUNDS * wall + 3, Double.POSITIVE_INFINITY);
            Arrays.fill(boxes, BOUNDS * wall + 3, BOUNDS * wall + BOUNDS, Double.NEGATIVE_INFINITY);
        }
        double margin = 2.0 * tolerance;
        for (int triangle = 0; triangle < wallOf.length; triangle++) {
            for (int corner = 0; wallOf[triangle] != NONE && corner < 3; corner++) {
                for (int axis = 0; axis < 3; axis++) {
                    double at = mesh.coordinate(triangle, corner, axis);
                    int low = BOUNDS * wallOf[triangle] + axis;
                    boxes[low] = Math.min(boxes[low], at - margin);
                    boxes[low + 3] = Math.max(boxes[low + 3], at + margin);
                }
            }
        }
        return boxes;
    }

    private boolean[] mixed(TriangleMesh mesh) {
        boolean[] isOfSeveral = new boolean[triangleOf.length];
        for (int triangle = 0; triangle < wallOf.length; triangle++) {
            int wall = wallOf[triangle];
            if (wall != NONE && mesh.material(triangle) != mesh.material(triangleOf[wall])) {
                isOfSeveral[wall] = true;
            }
        }
        return isOfSeveral;
    }

    /** Whether the triangles in a plane have more than one material, so that some of them may coincide. */
    public boolean isMixed(int wall) {
        return isMixed[wall];
    }

    /** The number of planes that reflect. */
    public int count() {
        return triangleOf.length;
    }

    /** The plane in which a triangle lies, or {@link #NONE}. */
    public int wallOf(int triangle) {
        return wallOf[triangle];
    }

    /** The largest triangle in a plane. */
    public int triangleOf(int wall) {
        return triangleOf[wall];
    }

    /** The maximum distance of a point from a plane to which it is assigned, m. */
    public double tolerance() {
        return tolerance;
    }

    /** Signed distance of a point from a plane, m; positive on the side to which the plane's normal points. */
    public double height(int wall, double x, double y, double z) {
        int at = NUMBERS * wall;
        return planes[at] * x + planes[at + 1] * y + planes[at + 2] * z - planes[at + 3];
    }

    /**
     * A component of a plane's unit normal.
     *
     * @param axis 0 for x, 1 for y, 2 for z
     */
    public double normal(int wall, int axis) {
        return planes[NUMBERS * wall + axis];
    }

    /** Whether two planes meet at an edge instead of nearly coinciding, as parts of one imperfectly flat wall do. */
    public boolean meet(int some, int other) {
        int a = NUMBERS * some;
        int b = NUMBERS * other;
        double cosine = planes[a] * planes[b] + planes[a + 1] * planes[b + 1] + planes[a + 2] * planes[b + 2];
        return Math.abs(cosine) < ALMOST_PARALLEL;
    }

    /**
     * Mirrors a point in a plane: reads three coordinates of {@code points} from index {@code from} on, and writes
     * three coordinates into {@code images} from index {@code to} on.
     */
    public void mirror(int wall, double[] points, int from, double[] images, int to) {
        int at = NUMBERS * wall;
        double twice = 2.0 * height(wall, points[from], points[from + 1], points[from + 2]);
        images[to] = points[from] - twice * planes[at];
        images[to + 1] = points[from + 1] - twice * planes[at + 1];
        images[to + 2] = points[from + 2] - twice * planes[at + 2];
    }

    /**
     * Whether a point in a plane lies in the bounding box of the plane's triangles: if not, nothing is reflected there.
     */
    public boolean mayContain(int wall, double x, double y, double z) {
        int at = BOUNDS * wall;
        return x >= bounds[at]
                && x <= bounds[at + 3]
                && y >= bounds[at + 1]
                && y <= bounds[at + 4]
                && z >= bounds[at + 2]
                && z <= bounds[at + 5];
    }

    /** The least coordinate of all triangles in a plane, less a margin, m. */
    double low(int wall, int axis) {
        return bounds[BOUNDS * wall + axis];
    }

    /** The greatest coordinate of all triangles in a plane, with a margin, m. */
    double high(int wall, int axis) {
        return bounds[BOUNDS * wall + 3 + axis];
    }

    WallTree tree() {
        return tree;
    }
}
