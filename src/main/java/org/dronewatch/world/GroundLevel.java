package org.dronewatch.world;

import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.EllipsoidQuery;
import org.dronewatch.mesh.io.ModelRole;

/**
 * Heights above the ground of a world, not above the roofs, canopies and floors that stand on it. On a vertical line,
 * the ground is the highest surface of terrain. In a world whose models do not state which of them is terrain, it is
 * the lowest upward-facing surface below the position, so that neither a roof nor the underside of a slab of ground
 * counts. Where there is no such surface, the ground is the lowest surface of any kind below the position, and where
 * there is none, it is at z = 0. For use by one thread.
 */
public final class GroundLevel {
    /** A position lies on a surface that is at most this far above it, m: the surface counts as below it. */
    private static final double CONTACT = 1e-3;

    /** A triangle whose normal rises by less than this fraction of its horizontal length is a wall. */
    private static final double UPRIGHT = 1e-6;

    /** Points of the plan this fraction outside of a triangle are on its edge. */
    private static final double ROUNDING = 1e-9;

    private final World world;
    private final TriangleMesh mesh;
    private final boolean statesTerrain;
    private final EllipsoidQuery query;
    private final double[] normal = new double[3];

    /** Heights above the ground of a world. */
    public GroundLevel(World world) {
        this.world = world;
        this.mesh = world.mesh();
        this.statesTerrain = world.statesTerrain();
        this.query = new EllipsoidQuery(world.tree());
    }

    /** The height of a position above the ground, m; 0 below the ground. */
    public double height(Position place) {
        // All surfaces at once: a search along a ray gives one of those that coincide, such as a house's floor and the
        // ground on which it stands.
        Position bottom = new Position(place.x(), place.y(), world.bounds().minZ());
        Position top = new Position(place.x(), place.y(), world.bounds().maxZ());
        query.find(bottom, top, top.z() - bottom.z() + CONTACT);
        double terrain = Double.NEGATIVE_INFINITY;
        double facingUp = Double.POSITIVE_INFINITY;
        double lowest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < query.count(); i++) {
            int triangle = query.triangle(i);
            double z = z(triangle, place.x(), place.y());
            if (statesTerrain
                    && !Double.isNaN(z)
                    && world.obstacle(triangle).model().role() == ModelRole.TERRAIN) {
                terrain = Math.max(terrain, z);
            }
            if (z <= place.z() + CONTACT) {
                lowest = Math.min(lowest, z);
                facingUp = normal[2] > 0.0 ? Math.min(facingUp, z) : facingUp;
            }
        }
        return Math.max(0.0, place.z() - ground(terrain, facingUp, lowest));
    }

    private double ground(double terrain, double facingUp, double lowest) {
        if (terrain > Double.NEGATIVE_INFINITY) {
            return terrain;
        }
        // A house where the terrain has a hole stands on its lowest surface.
        double below = !statesTerrain && facingUp < Double.POSITIVE_INFINITY ? facingUp : lowest;
        return below < Double.POSITIVE_INFINITY ? below : 0.0;
    }

    /** The height at which a vertical meets a triangle, m; NaN beside the triangle and for walls. Keeps the normal. */
    private double z(int triangle, double x, double y) {
        mesh.normal(triangle, normal);
        if (!(Math.abs(normal[2]) > UPRIGHT * Math.hypot(normal[0], normal[1]))) {
            return Double.NaN;
        }
        for (int corner = 0; corner < 3; corner++) {
            double fromX = mesh.coordinate(triangle, corner, 0);
            double fromY = mesh.coordinate(triangle, corner, 1);
            double sideX = mesh.coordinate(triangle, (corner + 1) % 3, 0) - fromX;
            double sideY = mesh.coordinate(triangle, (corner + 1) % 3, 1) - fromY;
            double inside = (sideX * (y - fromY) - sideY * (x - fromX)) * Math.signum(normal[2]);
            double size = Math.abs(sideX * (y - fromY)) + Math.abs(sideY * (x - fromX));
            if (!(inside >= -ROUNDING * size)) {
                return Double.NaN;
            }
        }
        double x0 = mesh.coordinate(triangle, 0, 0);
        double y0 = mesh.coordinate(triangle, 0, 1);
        return mesh.coordinate(triangle, 0, 2) - (normal[0] * (x - x0) + normal[1] * (y - y0)) / normal[2];
    }
}
