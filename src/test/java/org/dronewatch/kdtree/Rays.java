package org.dronewatch.kdtree;

import java.util.SplittableRandom;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.TriangleMesh;

/** Random rays of many kinds about a mesh: six numbers each, origin and direction. */
public final class Rays {
    private final TriangleMesh mesh;
    private final AABB box;
    private final SplittableRandom random;

    public Rays(TriangleMesh mesh, long seed) {
        this.mesh = mesh;
        this.box = mesh.triangleCount() == 0 ? new AABB(-1, -1, -1, 1, 1, 1) : thick(mesh.bounds());
        this.random = new SplittableRandom(seed);
    }

    /** The box, thickened where it is flat: hardly a random point then lies in the plane of a flat mesh. */
    private static AABB thick(AABB box) {
        double pad = 0.01 * box.diagonal();
        boolean flat = box.maxX() == box.minX() || box.maxY() == box.minY() || box.maxZ() == box.minZ();
        return flat
                ? new AABB(
                        box.minX() - pad,
                        box.minY() - pad,
                        box.minZ() - pad,
                        box.maxX() + pad,
                        box.maxY() + pad,
                        box.maxZ() + pad)
                : box;
    }

    /** So many rays: half start inside the mesh's box, a quarter outside; a quarter has zeros in its direction. */
    public double[][] any(int count) {
        double[][] rays = new double[count][];
        for (int i = 0; i < count; i++) {
            rays[i] = switch (i % 8) {
                case 0, 1, 2, 3 -> ray(inBox(1.0), onSphere());
                case 4 -> towards(outside(2.0), inBox(1.0));
                case 5 -> towards(outside(2.0), onMesh());
                case 6 -> ray(inBox(1.5), axisParallel());
                default -> ray(inBox(1.5), withOneZero());
            };
        }
        return rays;
    }

    /** A point in the mesh's box, or in one larger by a factor. */
    public double[] inBox(double factor) {
        double reach = 0.5 * factor;
        return new double[] {
            between(box.minX(), box.maxX(), reach),
            between(box.minY(), box.maxY(), reach),
            between(box.minZ(), box.maxZ(), reach)
        };
    }

    /** A point so many diagonals away from the middle of the mesh's box. */
    public double[] outside(double diagonals) {
        double[] point = onSphere();
        double radius = diagonals * box.diagonal();
        point[0] = box.center().x + radius * point[0];
        point[1] = box.center().y + radius * point[1];
        point[2] = box.center().z + radius * point[2];
        return point;
    }

    /** A point of a random triangle; any point of the box when there is none. */
    public double[] onMesh() {
        if (mesh.triangleCount() == 0) {
            return inBox(1.0);
        }
        int triangle = random.nextInt(mesh.triangleCount());
        double u = random.nextDouble();
        double v = random.nextDouble() * (1.0 - u);
        double[] point = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            point[axis] = (1.0 - u - v) * mesh.coordinate(triangle, 0, axis)
                    + u * mesh.coordinate(triangle, 1, axis)
                    + v * mesh.coordinate(triangle, 2, axis);
        }
        return point;
    }

    /** A direction of unit length, uniform. */
    public double[] onSphere() {
        double z = 2.0 * random.nextDouble() - 1.0;
        double angle = 2.0 * Math.PI * random.nextDouble();
        double radius = Math.sqrt(1.0 - z * z);
        return new double[] {radius * Math.cos(angle), radius * Math.sin(angle), z};
    }

    /** A direction along an axis; the zeros have either sign. */
    public double[] axisParallel() {
        double[] direction = {zero(), zero(), zero()};
        direction[random.nextInt(3)] = random.nextBoolean() ? 1.0 : -1.0;
        return direction;
    }

    /** A direction with one zero of either sign. */
    public double[] withOneZero() {
        double[] direction = onSphere();
        direction[random.nextInt(3)] = zero();
        return direction;
    }

    private double zero() {
        return random.nextBoolean() ? 0.0 : -0.0;
    }

    private double between(double low, double high, double reach) {
        return 0.5 * (low + high) + reach * (high - low) * (2.0 * random.nextDouble() - 1.0);
    }

    /** The ray from a point in a direction. */
    public static double[] ray(double[] origin, double[] direction) {
        return new double[] {origin[0], origin[1], origin[2], direction[0], direction[1], direction[2]};
    }

    /** The ray whose parameter is 1 at a second point, or an upright one when that is the first point. */
    public static double[] towards(double[] origin, double[] target) {
        double[] direction = {target[0] - origin[0], target[1] - origin[1], target[2] - origin[2]};
        boolean none = direction[0] == 0.0 && direction[1] == 0.0 && direction[2] == 0.0;
        return ray(origin, none ? new double[] {0, 0, 1} : direction);
    }

    /** Asks a traversal for the closest hit of a ray without end. */
    public static boolean closestHit(RayTracer traversal, double[] r) {
        return closestHit(traversal, r, 0.0, Double.POSITIVE_INFINITY);
    }

    /** Asks a traversal for the closest hit between two ray parameters. */
    public static boolean closestHit(RayTracer traversal, double[] r, double tMin, double tMax) {
        return traversal.closestHit(r[0], r[1], r[2], r[3], r[4], r[5], tMin, tMax);
    }

    /** Asks a traversal whether anything lies between two ray parameters. */
    public static boolean isOccluded(RayTracer traversal, double[] r, double tMin, double tMax) {
        return traversal.isOccluded(r[0], r[1], r[2], r[3], r[4], r[5], tMin, tMax);
    }
}
