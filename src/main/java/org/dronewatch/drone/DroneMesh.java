package org.dronewatch.drone;

import org.dronewatch.bvh.TracingIndex;
import org.dronewatch.geometry.TriangleMesh;

/** The mesh of a drone in model space, and what is derived from it once it is needed. Thread-safe. */
final class DroneMesh {
    private final TracingIndex index;
    private final double radius;
    private volatile SilhouetteTable silhouettes;

    DroneMesh(TracingIndex index) {
        this.index = index;
        this.radius = radius(index.tree().mesh());
    }

    private static double radius(TriangleMesh mesh) {
        double square = 0.0;
        for (int triangle = 0; triangle < mesh.triangleCount(); triangle++) {
            for (int corner = 0; corner < 3; corner++) {
                double x = mesh.coordinate(triangle, corner, 0);
                double y = mesh.coordinate(triangle, corner, 1);
                double z = mesh.coordinate(triangle, corner, 2);
                square = Math.max(square, x * x + y * y + z * z);
            }
        }
        return Math.sqrt(square);
    }

    /** Finds the triangles along rays. */
    TracingIndex index() {
        return index;
    }

    /** The greatest distance of the mesh from its origin, m. */
    double radius() {
        return radius;
    }

    /** The silhouettes of the level mesh. */
    SilhouetteTable silhouettes() {
        if (silhouettes == null) {
            synchronized (this) {
                if (silhouettes == null) {
                    silhouettes = new SilhouetteTable(index.tree().mesh());
                }
            }
        }
        return silhouettes;
    }
}
