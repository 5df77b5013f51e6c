package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.geometry.TriangleMesh;

/** Unit normals of a mesh's triangles. For use by one thread. */
public final class Normals {
    /** The normals are tabulated for up to this number of triangles: a table of this size fits the fastest cache. */
    private static final int MOST_TABULATED = 256;

    /**
     * The numbers kept for each triangle: a normal, and the reciprocal of its length; the product of the two is the
     * unit normal.
     */
    private static final int NUMBERS = 4;

    private final TriangleMesh mesh;
    private final double[] table;
    private final double[] computed = new double[3];

    /** Normals of a mesh: in a table if the mesh is small, and otherwise computed on request. */
    public Normals(TriangleMesh mesh) {
        this.mesh = mesh;
        int tabulated = mesh.triangleCount() <= MOST_TABULATED ? mesh.triangleCount() : 0;
        this.table = new double[NUMBERS * tabulated];
        for (int triangle = 0; triangle < tabulated; triangle++) {
            mesh.normal(triangle, computed);
            int row = NUMBERS * triangle;
            System.arraycopy(computed, 0, table, row, computed.length);
            table[row + 3] = inverseLength(computed[0], computed[1], computed[2]);
        }
    }

    /** Writes a triangle's unit normal on the side from which a ray arrives. */
    public void facing(int triangle, AcousticRay ray, double[] target) {
        int row = NUMBERS * triangle;
        if (row < table.length) {
            turn(table[row], table[row + 1], table[row + 2], table[row + 3], ray, target);
        } else {
            mesh.normal(triangle, computed);
            double x = computed[0];
            double y = computed[1];
            double z = computed[2];
            turn(x, y, z, inverseLength(x, y, z), ray, target);
        }
    }

    private static double inverseLength(double x, double y, double z) {
        return 1.0 / Math.sqrt(x * x + y * y + z * z);
    }

    private static void turn(double x, double y, double z, double inverseLength, AcousticRay ray, double[] target) {
        double along = x * ray.directionX + y * ray.directionY + z * ray.directionZ;
        // Without a branch, since which side a triangle shows cannot be predicted. The difference turns -0 into 0.
        double scale = Math.copySign(inverseLength, 0.0 - along);
        target[0] = x * scale;
        target[1] = y * scale;
        target[2] = z * scale;
    }
}
