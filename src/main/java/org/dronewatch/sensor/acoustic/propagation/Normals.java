package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.geometry.TriangleMesh;

/** Normals of triangles. */
public final class Normals {
    private Normals() {}

    /** Writes the unit normal of a triangle on the side from which a ray arrives. */
    public static void facing(TriangleMesh mesh, int triangle, AcousticRay ray, double[] target) {
        mesh.normal(triangle, target);
        double nx = target[0];
        double ny = target[1];
        double nz = target[2];
        double along = nx * ray.directionX + ny * ray.directionY + nz * ray.directionZ;
        double scale = (along > 0.0 ? -1.0 : 1.0) / Math.sqrt(nx * nx + ny * ny + nz * nz);
        target[0] = nx * scale;
        target[1] = ny * scale;
        target[2] = nz * scale;
    }
}
