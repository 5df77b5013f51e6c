package org.dronewatch.picture;

import java.util.Map;
import org.dronewatch.geometry.TriangleMesh;

/** What a mesh's triangles look like: their unit normals and their colours. Immutable. */
final class Facets {
    /** Of materials that name no colour: a pale stone. */
    private static final int UNNAMED = 0xb9b4aa;

    /** Screens show the dull colours of materials darker than daylight does. */
    private static final double BRIGHTER = 1.0 / 1.35;

    private final float[] normals;
    private final int[] colourOfMaterial;
    private final TriangleMesh mesh;

    /** Facets of a mesh whose materials look as named. */
    Facets(TriangleMesh mesh, Map<String, Integer> colours) {
        this.mesh = mesh;
        this.normals = new float[3 * mesh.triangleCount()];
        for (int i = 0; i < mesh.triangleCount(); i++) {
            setNormal(i);
        }
        this.colourOfMaterial = mesh.materialNames().stream()
                .mapToInt(name -> brighter(colours.getOrDefault(name, UNNAMED)))
                .toArray();
    }

    private static int brighter(int colour) {
        int rgb = 0;
        for (int shift = 16; shift >= 0; shift -= 8) {
            double share = (colour >> shift & 255) / 255.0;
            rgb |= (int) Math.round(255.0 * Math.pow(share, BRIGHTER)) << shift;
        }
        return rgb;
    }

    private void setNormal(int triangle) {
        double ax = mesh.coordinate(triangle, 0, 0);
        double ay = mesh.coordinate(triangle, 0, 1);
        double az = mesh.coordinate(triangle, 0, 2);
        double ux = mesh.coordinate(triangle, 1, 0) - ax;
        double uy = mesh.coordinate(triangle, 1, 1) - ay;
        double uz = mesh.coordinate(triangle, 1, 2) - az;
        double vx = mesh.coordinate(triangle, 2, 0) - ax;
        double vy = mesh.coordinate(triangle, 2, 1) - ay;
        double vz = mesh.coordinate(triangle, 2, 2) - az;
        double nx = uy * vz - uz * vy;
        double ny = uz * vx - ux * vz;
        double nz = ux * vy - uy * vx;
        double scale = 1.0 / Math.max(Double.MIN_NORMAL, Math.sqrt(nx * nx + ny * ny + nz * nz));
        normals[3 * triangle] = (float) (nx * scale);
        normals[3 * triangle + 1] = (float) (ny * scale);
        normals[3 * triangle + 2] = (float) (nz * scale);
    }

    /** One coordinate of a triangle's unit normal, to the side from which its corners run counter-clockwise. */
    double normal(int triangle, int axis) {
        return normals[3 * triangle + axis];
    }

    /** The cosine of the angle between two triangles' normals. */
    double cosine(int one, int other) {
        return normal(one, 0) * normal(other, 0)
                + normal(one, 1) * normal(other, 1)
                + normal(one, 2) * normal(other, 2);
    }

    /** A triangle's colour in full light. */
    int colour(int triangle) {
        return colourOfMaterial[mesh.material(triangle)];
    }
}
