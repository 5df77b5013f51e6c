package org.dronewatch.sensor.acoustic.imagesource;

import java.util.Arrays;

/**
 * Finds the walls that may reflect sound specularly from one point straight to another: at the point of reflection, a
 * wall's normal bisects the angle between the directions to both. Whole branches of a tree of walls are ruled out by
 * the sphere around them and the cone of their normals, so that few walls of a terrain need to be tried. The result
 * contains every wall that reflects, and may contain others. For use by one thread.
 */
public final class SingleReflections {
    /** A tolerance far above the rounding errors of angles, and far below the angles of cones. */
    private static final double ROUNDING = 1e-6;

    private final WallTree tree;
    private final int[] waiting;
    private int[] found = new int[64];
    private int count;

    /** Reflections in a world's walls. */
    public SingleReflections(WallPlanes planes) {
        this.tree = planes.tree();
        this.waiting = new int[tree.depth() + 1];
    }

    /** Finds the walls for two points, m. */
    public void find(double ax, double ay, double az, double bx, double by, double bz) {
        count = 0;
        int stacked = 0;
        if (tree.wallCount() > 0) {
            waiting[stacked++] = WallTree.ROOT;
        }
        while (stacked > 0) {
            int node = waiting[--stacked];
            if (!mayReflect(node, ax, ay, az, bx, by, bz)) {
                continue;
            }
            if (tree.isLeaf(node)) {
                take(node);
            } else {
                waiting[stacked++] = tree.left(node);
                waiting[stacked++] = tree.right(node);
            }
        }
        // The walls are sorted, so that sound is added up in the order of their numbers, whatever the order in which
        // the tree found them.
        Arrays.sort(found, 0, count);
    }

    /** The number of walls that the last search found. */
    public int count() {
        return count;
    }

    /** One of the walls, in ascending order of their numbers. */
    public int wall(int i) {
        return found[i];
    }

    private void take(int node) {
        int walls = tree.end(node) - tree.start(node);
        if (count + walls > found.length) {
            found = Arrays.copyOf(found, 2 * (count + walls));
        }
        for (int i = tree.start(node); i < tree.end(node); i++) {
            found[count++] = tree.wall(i);
        }
    }

    /**
     * Whether the bisector of the directions from some point of a node's sphere to both points may be the normal of a
     * plane in the node, or the opposite.
     */
    private boolean mayReflect(int node, double ax, double ay, double az, double bx, double by, double bz) {
        double radius = tree.radius(node);
        double toAx = ax - tree.centre(node, 0);
        double toAy = ay - tree.centre(node, 1);
        double toAz = az - tree.centre(node, 2);
        double toBx = bx - tree.centre(node, 0);
        double toBy = by - tree.centre(node, 1);
        double toBz = bz - tree.centre(node, 2);
        double toA = Math.sqrt(toAx * toAx + toAy * toAy + toAz * toAz);
        double toB = Math.sqrt(toBx * toBx + toBy * toBy + toBz * toBz);
        if (toA <= radius || toB <= radius) {
            return true;
        }
        double x = toAx / toA + toBx / toB;
        double y = toAy / toA + toBy / toB;
        double z = toAz / toA + toBz / toB;
        double sum = Math.sqrt(x * x + y * y + z * z);
        // The greatest change of the sum of both unit vectors within the sphere.
        double sine = (chord(radius / toA) + chord(radius / toB)) / sum + ROUNDING;
        if (!(sine < 1.0)) {
            return true;
        }
        double cosine = Math.sqrt(1.0 - sine * sine);
        // The cosine of the widest angle between the bisector and the axis of the cone of normals.
        double least = tree.cosine(node) * cosine - tree.sine(node) * sine;
        double along = (x * tree.axis(node, 0) + y * tree.axis(node, 1) + z * tree.axis(node, 2)) / sum;
        return least <= 0.0 || Math.abs(along) >= least;
    }

    /** The distance between two unit vectors, given the sine of the angle between them, which is below 90 degrees. */
    private static double chord(double sine) {
        // This form avoids cancellation where the sine is small.
        return sine * Math.sqrt(2.0 / (1.0 + Math.sqrt(1.0 - sine * sine)));
    }
}
