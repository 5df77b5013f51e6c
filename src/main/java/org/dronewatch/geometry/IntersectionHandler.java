package org.dronewatch.geometry;

import java.util.Optional;
import java.util.OptionalDouble;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;

/**
 * Intersections of a ray with a triangle, a box or a sphere: a readable reference, for one shape at a time. The
 * traversals of trees have a faster triangle test, which is tested against this one.
 */
public final class IntersectionHandler {

    private IntersectionHandler() {}

    /**
     * The hit of a ray on a triangle, from either side, after Möller and Trumbore, "Fast, minimum storage ray/triangle
     * intersection" (1997). The determinant is compared with zero only: an absolute tolerance would miss small
     * triangles, and culling would miss triangles that face away.
     *
     * @return the hit; empty if the ray misses, is parallel to the triangle, or meets it outside the ray's range
     */
    public static Optional<Hit> rayTriangle(Ray ray, Triangle triangle) {
        Vector3d edgeB = triangle.b().minus(triangle.a()).toVector3d();
        Vector3d edgeC = triangle.c().minus(triangle.a()).toVector3d();
        Vector3d direction = ray.direction();

        // The determinant is the volume spanned by the direction and the edges: zero when they lie in one plane.
        Vector3d p = cross(direction, edgeC);
        double determinant = edgeB.dot(p);
        if (determinant == 0.0) {
            return Optional.empty();
        }
        double scale = 1.0 / determinant;

        // Barycentric weights of b and c; outside 0..1 the ray passes beside the triangle.
        Vector3d fromA = new Vector3d(ray.origin());
        fromA.sub(triangle.a().toPoint3d());
        double u = scale * fromA.dot(p);
        if (!(u >= 0.0 && u <= 1.0)) {
            return Optional.empty();
        }
        Vector3d q = cross(fromA, edgeB);
        double v = scale * direction.dot(q);
        if (!(v >= 0.0 && u + v <= 1.0)) {
            return Optional.empty();
        }

        double t = scale * edgeC.dot(q);
        return t >= ray.tMin() && t <= ray.tMax() ? Optional.of(new Hit(t, triangle.id(), u, v)) : Optional.empty();
    }

    /**
     * The part of a ray inside a box, by the slab method (Kay and Kajiya 1986; Williams et al. 2005). A ray within a
     * face of the box counts as inside.
     *
     * @param interval receives the ray parameters of entry and exit in its first two elements; a ray that starts inside
     *     the box enters it at its tMin
     * @return whether the ray meets the box within the ray's range; if not, the interval is unchanged
     */
    public static boolean rayBox(Ray ray, AABB box, double[] interval) {
        Point3d o = ray.origin();
        Vector3d inverse = ray.inverseDirection();
        double near = ray.tMin();
        double far = ray.tMax();
        double[] origins = {o.x, o.y, o.z};
        double[] inverses = {inverse.x, inverse.y, inverse.z};
        double[] minima = {box.minX(), box.minY(), box.minZ()};
        double[] maxima = {box.maxX(), box.maxY(), box.maxZ()};
        for (int axis = 0; axis < 3; axis++) {
            double t0 = (minima[axis] - origins[axis]) * inverses[axis];
            double t1 = (maxima[axis] - origins[axis]) * inverses[axis];
            // 0 times infinity: the ray runs inside this plane, which bounds nothing.
            if (Double.isNaN(t0)) {
                t0 = Double.NEGATIVE_INFINITY;
            }
            if (Double.isNaN(t1)) {
                t1 = Double.POSITIVE_INFINITY;
            }
            near = Math.max(near, Math.min(t0, t1));
            far = Math.min(far, Math.max(t0, t1));
        }
        if (!(near <= far)) {
            return false;
        }
        interval[0] = near;
        interval[1] = far;
        return true;
    }

    /**
     * The first ray parameter within the ray's range at which the ray is inside a sphere: tMin when the ray starts
     * inside.
     *
     * @param radius radius in metres, above 0
     * @return the ray parameter; empty if the ray does not meet the sphere within its range
     * @throws IllegalArgumentException when the radius is not above 0
     */
    public static OptionalDouble raySphere(Ray ray, Point3d center, double radius) {
        if (!(radius > 0.0)) {
            throw new IllegalArgumentException("sphere radius " + radius + " m must be above 0");
        }
        Vector3d direction = ray.direction();
        Vector3d toCenter = new Vector3d(center);
        toCenter.sub(ray.origin());
        double a = direction.lengthSquared();
        double middle = toCenter.dot(direction) / a;

        // Distance of the centre from the line, from the foot point: the usual discriminant cancels for far spheres.
        Vector3d offset = new Vector3d(direction);
        offset.scaleAdd(-middle, toCenter);
        double halfSquared = (radius * radius - offset.lengthSquared()) / a;
        if (!(halfSquared >= 0.0)) {
            return OptionalDouble.empty();
        }
        double half = Math.sqrt(halfSquared);
        double entry = Math.max(middle - half, ray.tMin());
        double exit = Math.min(middle + half, ray.tMax());
        return entry <= exit ? OptionalDouble.of(entry) : OptionalDouble.empty();
    }

    /**
     * The distance along a ray at which it is first inside a sphere, as {@link #raySphere(Ray, Point3d, double)}, but
     * without allocating; for inner loops.
     *
     * @param ox x of the ray's origin, m
     * @param oy y of the origin, m
     * @param oz z of the origin, m
     * @param dx x of the ray's direction, which must be of unit length
     * @param dy y of the direction
     * @param dz z of the direction
     * @param centerX x of the sphere's centre, m
     * @param centerY y of the centre, m
     * @param centerZ z of the centre, m
     * @param radius radius in metres, above 0
     * @return the distance to the sphere, m; 0 when the ray starts inside it; infinity for a miss
     */
    public static double raySphere(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            double centerX,
            double centerY,
            double centerZ,
            double radius) {
        double x = centerX - ox;
        double y = centerY - oy;
        double z = centerZ - oz;
        double middle = x * dx + y * dy + z * dz;
        double besideX = x - middle * dx;
        double besideY = y - middle * dy;
        double besideZ = z - middle * dz;
        double halfSquared = radius * radius - besideX * besideX - besideY * besideY - besideZ * besideZ;
        if (!(halfSquared >= 0.0)) {
            return Double.POSITIVE_INFINITY;
        }
        double half = Math.sqrt(halfSquared);
        return middle + half >= 0.0 ? Math.max(middle - half, 0.0) : Double.POSITIVE_INFINITY;
    }

    private static Vector3d cross(Vector3d first, Vector3d second) {
        Vector3d result = new Vector3d();
        result.cross(first, second);
        return result;
    }
}
