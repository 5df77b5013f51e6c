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
        return touched(position) >= 0;
    }

    /**
     * The position itself or, if it lies on surfaces, one just in front of them: on the side from which the corners of
     * their triangles appear in counter-clockwise order.
     */
    public Position of(Position position) {
        Position clear = position;
        for (int wall = 0; wall < MAX_WALLS; wall++) {
            int triangle = touched(clear);
            if (triangle < 0) {
                return clear;
            }
            mesh.normal(triangle, normal);
            double length = Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
            double before = ((clear.x() - mesh.coordinate(triangle, 0, 0)) * normal[0]
                            + (clear.y() - mesh.coordinate(triangle, 0, 1)) * normal[1]
                            + (clear.z() - mesh.coordinate(triangle, 0, 2)) * normal[2])
                    / length;
            double step = (GAP - before) / length;
            clear = clear.plus(new Position(step * normal[0], step * normal[1], step * normal[2]));
        }
        return clear;
    }

    /** A triangle nearer than half the gap along an axis; -1 for none. */
    private int touched(Position position) {
        for (double[] axis : AXES) {
            if (traversal.closestHit(
                    position.x(), position.y(), position.z(), axis[0], axis[1], axis[2], 0.0, 0.5 * GAP)) {
                return traversal.triangle();
            }
        }
        return -1;
    }
}
