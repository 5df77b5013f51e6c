package org.dronewatch.sensor.acoustic.imagesource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
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
     * How far a corner may lie off the plane to which its triangle is assigned, relative to the size of the mesh:
     * coordinates of single precision are exact to 6e-8 of it, and a small triangle's plane is extended over the wall.
     */
    private static final double RELATIVE_TOLERANCE = 1e-6;

    private static final double LEAST_TOLERANCE = 1e-5;

    /** Planes whose unit normals differ by more in any coordinate are not compared. */
    private static final double NORMAL_CELL = 1e-2;

    private static final double ALMOST_PARALLEL = 0.99;

    /** The normal of a plane is the one on this side, whatever the winding of its triangles; any direction would do. */
    private static final double[] SIDE = {0.6, 0.48, 0.64};

    /** Normals that are perpendicular to it may have been assigned to either side. */
    private static final double EITHER_SIDE = 0.05;

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
        this.tolerance = Math.max(LEAST_TOLERANCE, RELATIVE_TOLERANCE * size(mesh));
        this.wallOf = new int[mesh.triangleCount()];
        Arrays.fill(wallOf, NONE);
        Grouping grouping = new Grouping(mesh);
        // The largest triangle has the most exact plane, so it comes first: by its area, then by its number.
        long[] order = IntStream.range(0, wallOf.length)
                .filter(triangle -> mirrors.test(triangle) && grouping.area(triangle) > 0.0f)
                .mapToLong(triangle -> (long) -Float.floatToIntBits(grouping.area(triangle)) << Integer.SIZE | triangle)
                .sorted()
                .toArray();
        for (long triangle : order) {
            grouping.add((int) triangle);
        }
        this.planes = grouping.planes();
        this.triangleOf = grouping.triangles();
        this.bounds = bounds(mesh);
        this.isMixed = mixed(mesh);
        this.tree = new WallTree(this);
    }

    private static double size(TriangleMesh mesh) {
        double size = 1.0;
        for (int vertex = 0; vertex < mesh.vertexCount(); vertex++) {
            for (int axis = 0; axis < 3; axis++) {
                size = Math.max(size, Math.abs(mesh.vertexCoordinate(vertex, axis)));
            }
        }
        return size;
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

    /** Their greatest coordinate, with a margin, m. */
    double high(int wall, int axis) {
        return bounds[BOUNDS * wall + 3 + axis];
    }

    WallTree tree() {
        return tree;
    }

    /** Assigns triangles to planes, one after another. */
    private final class Grouping {
        private final TriangleMesh mesh;
        private final double[] normal = new double[3];
        private final List<double[]> found = new ArrayList<>();
        private final List<Integer> largest = new ArrayList<>();
        private final Map<Integer, List<Integer>> byNormal = new HashMap<>();

        Grouping(TriangleMesh mesh) {
            this.mesh = mesh;
        }

        float area(int triangle) {
            mesh.normal(triangle, normal);
            return (float) (0.5 * length());
        }

        private double length() {
            return Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        }

        void add(int triangle) {
            mesh.normal(triangle, normal);
            double length = length();
            for (int axis = 0; axis < 3; axis++) {
                normal[axis] /= length;
            }
            double side = normal[0] * SIDE[0] + normal[1] * SIDE[1] + normal[2] * SIDE[2];
            double sign = side < 0.0 ? -1.0 : 1.0;
            for (int axis = 0; axis < 3; axis++) {
                normal[axis] *= sign;
            }
            int wall = find(triangle, 1.0);
            if (wall == NONE && Math.abs(side) < EITHER_SIDE) {
                wall = find(triangle, -1.0);
            }
            wallOf[triangle] = wall == NONE ? open(triangle) : wall;
        }

        private int open(int triangle) {
            double offset = normal[0] * mesh.coordinate(triangle, 0, 0)
                    + normal[1] * mesh.coordinate(triangle, 0, 1)
                    + normal[2] * mesh.coordinate(triangle, 0, 2);
            found.add(new double[] {normal[0], normal[1], normal[2], offset});
            largest.add(triangle);
            int cell = key(cell(normal[0]), cell(normal[1]), cell(normal[2]));
            byNormal.computeIfAbsent(cell, key -> new ArrayList<>()).add(found.size() - 1);
            return found.size() - 1;
        }

        private int find(int triangle, double sign) {
            int x = cell(sign * normal[0]);
            int y = cell(sign * normal[1]);
            int z = cell(sign * normal[2]);
            for (int i = -1; i <= 1; i++) {
                for (int j = -1; j <= 1; j++) {
                    for (int k = -1; k <= 1; k++) {
                        int cell = key(x + i, y + j, z + k);
                        for (int wall : byNormal.getOrDefault(cell, List.of())) {
                            if (contains(found.get(wall), triangle)) {
                                return wall;
                            }
                        }
                    }
                }
            }
            return NONE;
        }

        private boolean contains(double[] plane, int triangle) {
            for (int corner = 0; corner < 3; corner++) {
                double height = plane[0] * mesh.coordinate(triangle, corner, 0)
                        + plane[1] * mesh.coordinate(triangle, corner, 1)
                        + plane[2] * mesh.coordinate(triangle, corner, 2)
                        - plane[3];
                if (Math.abs(height) > tolerance) {
                    return false;
                }
            }
            return true;
        }

        private static int cell(double coordinate) {
            return (int) Math.round(coordinate / NORMAL_CELL);
        }

        /** Cells are numbered from -100 to 100 along each axis. */
        private static int key(int x, int y, int z) {
            return x << 2 * Byte.SIZE ^ (y & 0xFF) << Byte.SIZE ^ z & 0xFF;
        }

        double[] planes() {
            return found.stream().flatMapToDouble(Arrays::stream).toArray();
        }

        int[] triangles() {
            return largest.stream().mapToInt(Integer::intValue).toArray();
        }
    }
}
