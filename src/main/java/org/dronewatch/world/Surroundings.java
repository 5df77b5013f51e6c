package org.dronewatch.world;

import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.RayTracer;

/** Probes the surfaces around a point, with one ray towards each corner, edge and face of a cube. */
final class Surroundings {
    /**
     * Fewer rays with a hit from behind mean little: far from a model, a ray along an axis or a diagonal may hit just a
     * corner or an edge, from behind. From under the corner of a flat ground, four rays hit it.
     */
    private static final int FEWEST = 4;

    private final TriangleMesh mesh;
    private final RayTracer traversal;
    private final double[] normal = new double[3];

    Surroundings(World world) {
        this.mesh = world.mesh();
        this.traversal = world.newRayTracer();
    }

    /**
     * Whether most surfaces around a position, and several of them, show their backs: then it is inside a wall or under
     * the ground, in a mesh whose triangles are wound counter-clockwise seen from where sound and light are.
     */
    boolean showTheirBacks(Position position) {
        int fronts = 0;
        int backs = 0;
        for (int x = -1; x <= 1; x++) {
            for (int y = -1; y <= 1; y++) {
                for (int z = -1; z <= 1; z++) {
                    boolean any = (x != 0 || y != 0 || z != 0)
                            && traversal.closestHit(
                                    position.x(), position.y(), position.z(), x, y, z, 0.0, Double.POSITIVE_INFINITY);
                    if (any && isBack(traversal.triangle(), x, y, z)) {
                        backs++;
                    } else if (any) {
                        fronts++;
                    }
                }
            }
        }
        return backs >= FEWEST && backs > fronts;
    }

    private boolean isBack(int triangle, int x, int y, int z) {
        mesh.normal(triangle, normal);
        return x * normal[0] + y * normal[1] + z * normal[2] > 0.0;
    }
}
