package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.geometry.TriangleMesh;

/** Normals of triangles. */
public final class Normals {
    private Normals() {}

    /** Writes the unit normal of a triangle on the side that a ray comes from. */
    public static void facing(TriangleMesh mesh, int triangle, AcousticRay ray, double[] target) {
        double ax = mesh.coordinate(triangle, 0, 0);
        double ay = mesh.coordinate(triangle, 0, 1);
        double az = mesh.coordinate(triangle, 0, 2);
        double bx = mesh.coordinate(triangle, 1, 0) - ax;
        double by = mesh.coordinate(triangle, 1, 1) - ay;
        double bz = mesh.coordinate(triangle, 1, 2) - az;
        double cx = mesh.coordinate(triangle, 2, 0) - ax;
        double cy = mesh.coordinate(triangle, 2, 1) - ay;
        double cz = mesh.coordinate(triangle, 2, 2) - az;
        double nx = by * cz - bz * cy;
        double ny = bz * cx - bx * cz;
        double nz = bx * cy - by * cx;
        double along = nx * ray.directionX + ny * ray.directionY + nz * ray.directionZ;
        double scale = (along > 0.0 ? -1.0 : 1.0) / Math.sqrt(nx * nx + ny * ny + nz * nz);
        target[0] = nx * scale;
        target[1] = ny * scale;
        target[2] = nz * scale;
    }
}
