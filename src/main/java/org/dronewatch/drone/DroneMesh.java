package org.dronewatch.drone;

import org.dronewatch.bvh.TracingIndex;
import org.dronewatch.drone.silhouette.SilhouetteTable;

/** The mesh of a drone in model space, with data derived from it when they are first needed. Thread-safe. */
final class DroneMesh {
    private final TracingIndex index;
    private final double radius;
    private volatile SilhouetteTable silhouettes;

    DroneMesh(TracingIndex index) {
        this.index = index;
        this.radius = index.tree().mesh().radius();
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
