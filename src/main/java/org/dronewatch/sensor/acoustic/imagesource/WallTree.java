package org.dronewatch.sensor.acoustic.imagesource;

import java.util.Arrays;

/**
 * A bounding volume hierarchy of walls: each node has a bounding sphere of its walls and a cone of their normals, whose
 * signs do not matter (L. Shirman and S. Abi-Ezzi, The cone of normals technique, Computer Graphics Forum 12, 261,
 * 1993). Immutable.
 */
final class WallTree {
    /** The node of all walls. */
    static final int ROOT = 0;

    /** Nodes of up to this number of walls are not divided. */
    private static final int MAX_LEAF_SIZE = 8;

    /** Bits of a coordinate along each axis in the Morton code. */
    private static final int CELL_BITS = 10;

    /**
     * The numbers of a node: the centre and the radius of its sphere, the axis of its cone, and the cosine and sine of
     * the cone's half-angle.
     */
    private static final int STRIDE = 9;

    private static final int RADIUS = 3;
    private static final int AXIS = 4;
    private static final int COSINE = 7;
    private static final int SINE = 8;

    /** A tolerance above the rounding errors of spheres and cones. */
    private static final double ROUNDING = 1e-9;

    private final int[] walls;
    private final int[] starts;
    private final int[] ends;

    /** The right child of each node, 0 for a leaf; the left child comes directly after its parent. */
    private final int[] rights;

    private final double[] numbers;
    private int nodes;
    private int depth;

    /** A tree of all walls of a world. */
    WallTree(WallPlanes planes) {
        this.walls = mortonOrder(planes);
        int count = nodesFor(walls.length);
        this.starts = new int[count];
        this.ends = new int[count];
        this.rights = new int[count];
        this.numbers = new double[STRIDE * count];
        if (walls.length > 0) {
            add(planes, 0, walls.length, 1);
        }
    }

    /** The number of nodes of a tree or branch with a number of walls, as {@link #add} divides it. */
    private static int nodesFor(int count) {
        return count <= MAX_LEAF_SIZE ? 1 : 1 + nodesFor(count / 2) + nodesFor(count - count / 2);
    }

    /** The walls in the Morton order of their centres: walls that follow one another are near each other. */
    private static int[] mortonOrder(WallPlanes planes) {
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int wall = 0; wall < planes.count(); wall++) {
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], centre(planes, wall, axis));
                high[axis] = Math.max(high[axis], centre(planes, wall, axis));
            }
        }
        long[] keys = new long[planes.count()];
        for (int wall = 0; wall < keys.length; wall++) {
            int code = 0;
            for (int axis = 0; axis < 3; axis++) {
                double part = (centre(planes, wall, axis) - low[axis]) / Math.max(high[axis] - low[axis], ROUNDING);
                code |= spread((int) (part * ((1 << CELL_BITS) - 1))) << axis;
            }
            keys[wall] = (long) code << Integer.SIZE | wall;
        }
        Arrays.sort(keys);
        return Arrays.stream(keys).mapToInt(key -> (int) key).toArray();
    }

    private static double centre(WallPlanes planes, int wall, int axis) {
        return 0.5 * (planes.low(wall, axis) + planes.high(wall, axis));
    }

    /** Inserts two zeros between successive bits. */
    private static int spread(int bits) {
        int spread = 0;
        for (int bit = 0; bit < CELL_BITS; bit++) {
            spread |= (bits >> bit & 1) << 3 * bit;
        }
        return spread;
    }

    private int add(WallPlanes planes, int start, int end, int level) {
        int node = nodes++;
        depth = Math.max(depth, level);
        starts[node] = start;
        ends[node] = end;
        bound(planes, node);
        if (end - start > MAX_LEAF_SIZE) {
            int middle = (start + end) >>> 1;
            add(planes, start, middle, level + 1);
            rights[node] = add(planes, middle, end, level + 1);
        }
        return node;
    }

    private void bound(WallPlanes planes, int node) {
        int at = STRIDE * node;
        double diagonal = 0.0;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = starts[node]; i < ends[node]; i++) {
                low = Math.min(low, planes.low(walls[i], axis));
                high = Math.max(high, planes.high(walls[i], axis));
            }
            numbers[at + axis] = 0.5 * (low + high);
            diagonal += (high - low) * (high - low);
        }
        numbers[at + RADIUS] = 0.5 * Math.sqrt(diagonal) * (1.0 + ROUNDING);
        boundNormals(planes, node);
    }

    private void boundNormals(WallPlanes planes, int node) {
        int at = STRIDE * node;
        int first = walls[starts[node]];
        double[] axis = {planes.normal(first, 0), planes.normal(first, 1), planes.normal(first, 2)};
        double[] sum = new double[3];
        for (int i = starts[node]; i < ends[node]; i++) {
            double sign = Math.signum(cosine(planes, walls[i], axis));
            for (int k = 0; k < 3; k++) {
                sum[k] += sign * planes.normal(walls[i], k);
            }
        }
        double length = Math.sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
        for (int k = 0; k < 3; k++) {
            axis[k] = sum[k] / length;
            numbers[at + AXIS + k] = axis[k];
        }
        double least = 1.0;
        for (int i = starts[node]; i < ends[node]; i++) {
            least = Math.min(least, Math.abs(cosine(planes, walls[i], axis)));
        }
        double cosine = Math.max(0.0, least - ROUNDING);
        numbers[at + COSINE] = cosine;
        numbers[at + SINE] = Math.sqrt(1.0 - cosine * cosine);
    }

    private static double cosine(WallPlanes planes, int wall, double[] axis) {
        return planes.normal(wall, 0) * axis[0] + planes.normal(wall, 1) * axis[1] + planes.normal(wall, 2) * axis[2];
    }

    int wallCount() {
        return walls.length;
    }

    /** The number of nodes from the root to the lowest leaf. */
    int depth() {
        return depth;
    }

    boolean isLeaf(int node) {
        return rights[node] == 0;
    }

    int left(int node) {
        return node + 1;
    }

    int right(int node) {
        return rights[node];
    }

    /** The index of a node's first wall in the order of the tree. */
    int start(int node) {
        return starts[node];
    }

    /** One more than the index of a node's last wall in the order of the tree. */
    int end(int node) {
        return ends[node];
    }

    int wall(int index) {
        return walls[index];
    }

    /** A coordinate of the centre of a node's sphere, m. */
    double centre(int node, int axis) {
        return numbers[STRIDE * node + axis];
    }

    /** The radius of a node's sphere, m. */
    double radius(int node) {
        return numbers[STRIDE * node + RADIUS];
    }

    /** A component of the unit vector along the axis of a node's cone. */
    double axis(int node, int axis) {
        return numbers[STRIDE * node + AXIS + axis];
    }

    /** Cosine of the angle between the axis of a node's cone and the farthest normal, 0 or more. */
    double cosine(int node) {
        return numbers[STRIDE * node + COSINE];
    }

    /** Sine of the angle between the axis and the farthest normal. */
    double sine(int node) {
        return numbers[STRIDE * node + SINE];
    }
}
