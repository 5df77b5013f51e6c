package org.dronewatch.kdtree;

import java.util.Arrays;
import org.dronewatch.geometry.Position;

/**
 * Finds the triangles of a tree that come near an ellipsoid with two foci: the points for which the sum of the
 * distances from both foci is at most a limit, such as the points that a path of bounded length between the foci can
 * reach. The result contains every triangle that intersects the ellipsoid, and a few near it, because boxes are tested
 * instead of triangles. Allocates only when a query finds more triangles than any before it. For use by one thread.
 */
public final class EllipsoidQuery {
    private final KDTree tree;
    private final float[] corners;

    /** The query in which each triangle was last met: one in several leaves is tested once. */
    private final int[] lastMet;

    private int query;
    private int[] found = new int[64];
    private int count;

    private double ax;
    private double ay;
    private double az;
    private double bx;
    private double by;
    private double bz;
    private double limit;
    private boolean cuts;
    private double nx;
    private double ny;
    private double nz;
    private double planeSlack;

    /** Queries of a tree. */
    public EllipsoidQuery(KDTree tree) {
        this.tree = tree;
        this.corners = tree.triangles().corners();
        this.lastMet = new int[tree.triangles().count()];
    }

    /**
     * Finds the triangles near an ellipsoid.
     *
     * @param a one focus, m
     * @param b the other focus, m
     * @param sum sum of the distances of a point on the ellipsoid from both foci, m
     */
    public void find(Position a, Position b, double sum) {
        cuts = false;
        search(a, b, sum);
    }

    /**
     * Finds the triangles that are near an ellipsoid and also reach a plane through its foci.
     *
     * @param a one focus, m
     * @param b the other focus, m
     * @param sum sum of the distances of a point on the ellipsoid from both foci, m
     * @param normal normal of the plane, of length 1
     * @param slack triangles up to this distance from the plane are included, m
     */
    public void findAtPlane(Position a, Position b, double sum, Position normal, double slack) {
        cuts = true;
        nx = normal.x();
        ny = normal.y();
        nz = normal.z();
        planeSlack = slack;
        search(a, b, sum);
    }

    /** The number of triangles that the most recent query found. */
    public int count() {
        return count;
    }

    /** The index in the mesh of one of the triangles found, which are numbered from 0 to {@link #count()} - 1. */
    public int triangle(int i) {
        return tree.triangles().numbers()[found[i]];
    }

    /**
     * A coordinate of one of the triangles found, m: faster to read here than in the mesh.
     *
     * @param i 0 to {@link #count()} - 1
     * @param corner 0 to 2
     * @param axis 0 to 2 for x, y and z
     */
    public float coordinate(int i, int corner, int axis) {
        return corners[9 * found[i] + 3 * corner + axis];
    }

    private void search(Position a, Position b, double sum) {
        ax = a.x();
        ay = a.y();
        az = a.z();
        bx = b.x();
        by = b.y();
        bz = b.z();
        // Boxes are of single precision and rounded outwards; the sum itself is rounded.
        limit = sum * (1.0 + 1e-12);
        count = 0;
        if (query == Integer.MAX_VALUE) {
            Arrays.fill(lastMet, 0);
            query = 0;
        }
        query++;
        float[] box = tree.rootBox();
        visit(0, box[0], box[1], box[2], box[3], box[4], box[5]);
    }

    private void visit(int index, double x0, double y0, double z0, double x1, double y1, double z1) {
        if (isOutside(x0, y0, z0, x1, y1, z1)) {
            return;
        }
        long node = tree.nodes()[index];
        int kind = KDNode.kind(node);
        if (kind == KDNode.LEAF) {
            visitLeaf(node);
            return;
        }
        double split = KDNode.split(node);
        int left = KDNode.leftChild(index);
        int right = KDNode.rightChild(node);
        visit(left, x0, y0, z0, kind == 0 ? split : x1, kind == 1 ? split : y1, kind == 2 ? split : z1);
        visit(right, kind == 0 ? split : x0, kind == 1 ? split : y0, kind == 2 ? split : z0, x1, y1, z1);
    }

    private void visitLeaf(long node) {
        int from = KDNode.first(node);
        int to = from + KDNode.count(node);
        for (int i = from; i < to; i++) {
            int triangle = tree.leafTriangles()[i];
            if (lastMet[triangle] != query) {
                lastMet[triangle] = query;
                if (isNear(9 * triangle)) {
                    if (count == found.length) {
                        found = Arrays.copyOf(found, 2 * count);
                    }
                    found[count++] = triangle;
                }
            }
        }
    }

    private boolean isNear(int at) {
        float[] c = corners;
        return (!cuts || reachesPlane(at))
                && !isBeyond(
                        Math.min(c[at], Math.min(c[at + 3], c[at + 6])),
                        Math.min(c[at + 1], Math.min(c[at + 4], c[at + 7])),
                        Math.min(c[at + 2], Math.min(c[at + 5], c[at + 8])),
                        Math.max(c[at], Math.max(c[at + 3], c[at + 6])),
                        Math.max(c[at + 1], Math.max(c[at + 4], c[at + 7])),
                        Math.max(c[at + 2], Math.max(c[at + 5], c[at + 8])));
    }

    private boolean reachesPlane(int at) {
        double first = height(at);
        double second = height(at + 3);
        double third = height(at + 6);
        return Math.min(first, Math.min(second, third)) <= planeSlack
                && Math.max(first, Math.max(second, third)) >= -planeSlack;
    }

    private double height(int at) {
        return nx * (corners[at] - ax) + ny * (corners[at + 1] - ay) + nz * (corners[at + 2] - az);
    }

    private boolean isOutside(double x0, double y0, double z0, double x1, double y1, double z1) {
        if (cuts) {
            double height = nx * (0.5 * (x0 + x1) - ax) + ny * (0.5 * (y0 + y1) - ay) + nz * (0.5 * (z0 + z1) - az);
            double reach = 0.5 * (Math.abs(nx) * (x1 - x0) + Math.abs(ny) * (y1 - y0) + Math.abs(nz) * (z1 - z0));
            if (Math.abs(height) > reach + planeSlack) {
                return true;
            }
        }
        return isBeyond(x0, y0, z0, x1, y1, z1);
    }

    /** Whether its distances from the foci show that no point of a box is in the ellipsoid. */
    private boolean isBeyond(double x0, double y0, double z0, double x1, double y1, double z1) {
        double dxa = outside(ax, x0, x1);
        double dya = outside(ay, y0, y1);
        double dza = outside(az, z0, z1);
        double dxb = outside(bx, x0, x1);
        double dyb = outside(by, y0, y1);
        double dzb = outside(bz, z0, z1);
        return Math.sqrt(dxa * dxa + dya * dya + dza * dza) + Math.sqrt(dxb * dxb + dyb * dyb + dzb * dzb) > limit;
    }

    private static double outside(double value, double low, double high) {
        return Math.max(0.0, Math.max(low - value, value - high));
    }
}
