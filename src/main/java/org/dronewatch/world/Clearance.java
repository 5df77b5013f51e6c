package org.dronewatch.world;

import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.RayTracer;

/**
 * Moves positions that lie on a surface slightly off it. A microphone on the ground is treated as lying just above it;
 * otherwise the last leg of a path reflected by the ground would have zero length, and it would be undefined from which
 * side the sound arrives. For use by one thread.
 */
public final class Clearance {
    /**
     * The distance by which a position is moved off its surface, m: negligible for a sound wave, and above
     * {@link Visibility#MARGIN}, so that the surface still hides everything behind it.
     */
    public static final double GAP = 1e-4;

    /** A position nearer to a surface than this lies on it, m. */
    private static final double TOUCHING = 0.5 * GAP;

    /** A position that has been moved off a surface is no longer near it, whatever rounding has done. */
    private static final double ALMOST = 0.99;

    /** A position in a corner lies on up to three walls. */
    private static final int MAX_WALLS = 3;

    private static final double[][] AXES = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

    private final TriangleMesh mesh;
    private final RayTracer traversal;
    private final double[] normal = new double[3];

    /** Creates a clearance from the surfaces of a world. */
    public Clearance(World world) {
        this.mesh = world.mesh();
        this.traversal = world.newRayTracer();
    }

    /** Whether a position lies on a surface. */
    public boolean isOnSurface(Position position) {
        return near(position, TOUCHING) >= 0;
    }

    /**
     * The position itself or, if it lies on surfaces, one just in front of them: on the side from which the corners of
     * their triangles appear in counter-clockwise order.
     */
    public Position of(Position position) {
        Position clear = position;
        int triangle = near(clear, TOUCHING);
        for (int wall = 0; wall < MAX_WALLS && triangle >= 0; wall++) {
            clear = moved(clear, triangle, GAP - height(clear, triangle));
            triangle = near(clear, TOUCHING);
        }
        return clear;
    }

    /**
     * A clear position itself or, if it is near a surface, one farther from that, on the same side. Where another
     * surface is in the way, the position stays where it is.
     *
     * @param distance the least distance from surfaces, m; approximate where a surface is not parallel to an axis
     */
    public Position apart(Position clear, double distance) {
        Position apart = clear;
        double near = ALMOST * distance;
        int triangle = near(apart, near);
        for (int wall = 0; wall < MAX_WALLS && triangle >= 0; wall++) {
            double height = height(apart, triangle);
            apart = moved(apart, triangle, Math.copySign(distance, height) - height);
            triangle = near(apart, near);
        }
        Position way = apart.minus(clear);
        boolean isBlocked = apart != clear
                && traversal.closestHit(clear.x(), clear.y(), clear.z(), way.x(), way.y(), way.z(), 0.0, 1.0);
        return isBlocked ? clear : apart;
    }

    private Position moved(Position position, int triangle, double by) {
        mesh.normal(triangle, normal);
        double step = by / length();
        return position.plus(new Position(step * normal[0], step * normal[1], step * normal[2]));
    }

    /** The signed distance from a triangle's plane, m. */
    private double height(Position position, int triangle) {
        mesh.normal(triangle, normal);
        return ((position.x() - mesh.coordinate(triangle, 0, 0)) * normal[0]
                        + (position.y() - mesh.coordinate(triangle, 0, 1)) * normal[1]
                        + (position.z() - mesh.coordinate(triangle, 0, 2)) * normal[2])
                / length();
    }

    private double length() {
        return Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    }

    /** A triangle nearer than a distance along an axis; -1 for none. */
    private int near(Position position, double distance) {
        for (double[] axis : AXES) {
            if (traversal.closestHit(
                    position.x(), position.y(), position.z(), axis[0], axis[1], axis[2], 0.0, distance)) {
                return traversal.triangle();
            }
        }
        return -1;
    }
}
