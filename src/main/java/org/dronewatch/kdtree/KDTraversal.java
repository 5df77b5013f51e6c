package org.dronewatch.kdtree;

import java.util.Optional;
import org.dronewatch.geometry.Hit;
import org.dronewatch.geometry.Ray;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;

/**
 * Asks a tree what a ray meets. One per thread: it holds the ray and the hit of its last question. The forms that take
 * primitives allocate nothing.
 *
 * <p>Origins are in metres in the tree's frame. A direction may have any length but zero; distances are ray parameters,
 * which are metres for a unit direction. Triangles are hit from either side.
 */
public abstract class KDTraversal {
    /**
     * How far, relatively, two cells of the tree may overlap along a ray: a few roundings of a plane's ray parameter. A
     * hit on the border of two cells is then looked for in both.
     */
    static final double OVERLAP = 8.0 * 0x1p-53;

    final KDTree tree;
    final TriangleIntersection intersection;
    final double[] origin;
    final double[] direction;
    final double[] inverse;

    KDTraversal(KDTree tree) {
        this.tree = tree;
        this.intersection = new TriangleIntersection(tree.triangles());
        this.origin = new double[3];
        this.direction = new double[3];
        this.inverse = new double[3];
    }

    /** A traversal that answers the questions of another: it works on that one's ray and hit. */
    KDTraversal(KDTraversal asked) {
        this.tree = asked.tree;
        this.intersection = asked.intersection;
        this.origin = asked.origin;
        this.direction = asked.direction;
        this.inverse = asked.inverse;
    }

    /**
     * Looks for the nearest triangle along a ray. Of several with the same corners it names that with the least number. Where
     * a ray hits an edge or a corner of several, which of them is named may depend on the traversal.
     *
     * @param tMin the smallest ray parameter that counts, 0 or more
     * @param tMax the largest that counts
     * @return whether there is one; its {@link #distance()}, {@link #triangle()}, {@link #u()} and {@link #v()} can be
     *     read until the next question
     */
    public final boolean closestHit(
            double ox, double oy, double oz, double dx, double dy, double dz, double tMin, double tMax) {
        setRay(ox, oy, oz, dx, dy, dz);
        intersection.setRay(origin, direction, tMax);
        trace(tMin, tMax, false);
        return intersection.found();
    }

    /** The nearest triangle along a ray, or empty. Allocates; kernels use the form that takes primitives. */
    public final Optional<Hit> closestHit(Ray ray) {
        Point3d o = ray.origin();
        Vector3d d = ray.direction();
        return closestHit(o.x, o.y, o.z, d.x, d.y, d.z, ray.tMin(), ray.tMax())
                ? Optional.of(new Hit(distance(), triangle(), u(), v()))
                : Optional.empty();
    }

    /**
     * Whether any triangle lies strictly between two ray parameters. A computed point lies on a surface only up to
     * rounding: between points on surfaces, leave a little room at both ends.
     */
    public final boolean isOccluded(
            double ox, double oy, double oz, double dx, double dy, double dz, double tMin, double tMax) {
        double first = Math.nextUp(tMin);
        double last = Math.nextDown(tMax);
        if (!(first <= last)) {
            return false;
        }
        setRay(ox, oy, oz, dx, dy, dz);
        intersection.setRay(origin, direction, last);
        trace(first, last, true);
        return intersection.found();
    }

    /** Ray parameter of the last closest hit. */
    public final double distance() {
        return intersection.distance();
    }

    /** Triangle number of the last closest hit. */
    public final int triangle() {
        return intersection.triangle();
    }

    /** Weight of the triangle's second corner at the last closest hit. */
    public final double u() {
        return intersection.u();
    }

    /** Weight of the triangle's third corner at the last closest hit. */
    public final double v() {
        return intersection.v();
    }

    private void setRay(double ox, double oy, double oz, double dx, double dy, double dz) {
        origin[0] = ox;
        origin[1] = oy;
        origin[2] = oz;
        direction[0] = dx;
        direction[1] = dy;
        direction[2] = dz;
        for (int axis = 0; axis < 3; axis++) {
            inverse[axis] = Ray.inverse(direction[axis]);
        }
    }

    /** Walks the tree; what is hit goes to the intersection. */
    abstract void trace(double tMin, double tMax, boolean anyHit);

    /** The smallest ray parameter inside the root's box, not below tMin; wider than exact by {@link #OVERLAP}. */
    final double rootEntry(double tMin) {
        float[] box = tree.rootBox();
        double entry = tMin;
        for (int axis = 0; axis < 3; axis++) {
            double plane = inverse[axis] >= 0.0 ? box[axis] : box[axis + 3];
            double t = (plane - origin[axis]) * inverse[axis];
            // Not a number when the ray runs inside the plane: that bounds nothing, and the comparison says so.
            if (t * (1.0 - OVERLAP) > entry) {
                entry = t * (1.0 - OVERLAP);
            }
        }
        return entry;
    }

    /** The largest ray parameter inside the root's box, not above tMax; negative when the box lies behind. */
    final double rootExit(double tMax) {
        float[] box = tree.rootBox();
        double exit = tMax;
        for (int axis = 0; axis < 3; axis++) {
            double plane = inverse[axis] >= 0.0 ? box[axis + 3] : box[axis];
            double t = (plane - origin[axis]) * inverse[axis];
            if (t * (1.0 + OVERLAP) < exit) {
                exit = t * (1.0 + OVERLAP);
            }
        }
        return exit;
    }

    /** Tests the triangles of a leaf. */
    final void testLeaf(long leaf, double tMin) {
        int[] leafPlaces = tree.leafPlaces();
        int from = KDNode.first(leaf);
        int to = from + KDNode.count(leaf);
        for (int i = from; i < to; i++) {
            intersection.test(leafPlaces[i], tMin);
        }
    }
}
