package org.dronewatch.report;

import java.awt.Color;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTraversal;
import org.dronewatch.world.World;

/** The ground as seen from straight above, lit from the north-west. */
final class ReliefShade {
    private static final Color NOTHING = new Color(0xeeeeee);
    private static final double[] LIGHT = {-0.48, 0.48, 0.734};

    private final World world;
    private final TriangleMesh mesh;
    private final KDTraversal traversal;
    private final double above;

    ReliefShade(World world) {
        this.world = world;
        this.mesh = world.mesh();
        this.traversal = world.newTraversal();
        this.above = world.bounds().maxZ() + 1.0;
    }

    /** The colour at a place: pale where the surface faces the light, lighter the higher it is. */
    Color shade(double x, double y) {
        if (!traversal.closestHit(x, y, above, 0.0, 0.0, -1.0, 0.0, Double.POSITIVE_INFINITY)) {
            return NOTHING;
        }
        double[] normal = normal(traversal.triangle());
        double facing = normal[0] * LIGHT[0] + normal[1] * LIGHT[1] + normal[2] * LIGHT[2];
        double height = above - traversal.distance();
        double rise = (height - world.bounds().minZ())
                / Math.max(1e-9, world.bounds().maxZ() - world.bounds().minZ());
        double light = Math.max(0.0, Math.min(1.0, 0.25 + 0.55 * Math.max(0.0, facing) + 0.2 * rise));
        return new Color((int) (236 * light), (int) (232 * light), (int) (222 * light));
    }

    private double[] normal(int triangle) {
        double[] a = corner(triangle, 0);
        double[] b = corner(triangle, 1);
        double[] c = corner(triangle, 2);
        double ux = b[0] - a[0];
        double uy = b[1] - a[1];
        double uz = b[2] - a[2];
        double vx = c[0] - a[0];
        double vy = c[1] - a[1];
        double vz = c[2] - a[2];
        double nx = uy * vz - uz * vy;
        double ny = uz * vx - ux * vz;
        double nz = ux * vy - uy * vx;
        double length = Math.copySign(Math.max(Double.MIN_NORMAL, Math.sqrt(nx * nx + ny * ny + nz * nz)), nz);
        return new double[] {nx / length, ny / length, nz / length};
    }

    private double[] corner(int triangle, int corner) {
        int vertex = mesh.vertexIndex(triangle, corner);
        return new double[] {
            mesh.vertexCoordinate(vertex, 0), mesh.vertexCoordinate(vertex, 1), mesh.vertexCoordinate(vertex, 2)
        };
    }
}
