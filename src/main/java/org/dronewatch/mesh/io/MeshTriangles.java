package org.dronewatch.mesh.io;

import java.util.List;
import org.dronewatch.geometry.Floats;
import org.dronewatch.geometry.Ints;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.polygon.PolygonCutter;

/** The triangles of polygons, numbered as they come; those without area are left out but keep their numbers. */
final class MeshTriangles {
    private final Floats vertices;
    private final PolygonCutter cutter;
    private final Ints cut = new Ints();
    private final Ints corners = new Ints();
    private final Ints materials = new Ints();
    private final Ints sourceNumbers = new Ints();
    private int numbered;

    MeshTriangles(Floats vertices) {
        this.vertices = vertices;
        this.cutter = new PolygonCutter(vertices);
    }

    /**
     * Adds the triangles of a polygon. They take up two numbers fewer than it has corners, however many there are.
     *
     * @return whether they cover the polygon; false for one that crosses itself
     */
    boolean add(int[] polygon, int material) {
        cut.clear();
        boolean covered = cutter.cut(polygon, cut);
        for (int i = 0; i < cut.size(); i += 3) {
            if (hasArea(i)) {
                for (int k = 0; k < 3; k++) {
                    corners.add(cut.get(i + k));
                }
                materials.add(material);
                sourceNumbers.add(numbered + i / 3);
            }
        }
        numbered += polygon.length - 2;
        return covered;
    }

    private boolean hasArea(int first) {
        int a = 3 * cut.get(first);
        int b = 3 * cut.get(first + 1);
        int c = 3 * cut.get(first + 2);
        double[] cross = new double[3];
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3;
            double bk = (double) vertices.get(b + k) - vertices.get(a + k);
            double bn = (double) vertices.get(b + next) - vertices.get(a + next);
            double ck = (double) vertices.get(c + k) - vertices.get(a + k);
            double cn = (double) vertices.get(c + next) - vertices.get(a + next);
            cross[k] = bk * cn - bn * ck;
        }
        return cross[0] != 0.0 || cross[1] != 0.0 || cross[2] != 0.0;
    }

    /** How many triangles have an area. */
    int size() {
        return materials.size();
    }

    TriangleMesh toMesh(List<String> materialNames) {
        return new TriangleMesh(
                vertices.toArray(), corners.toArray(), materials.toArray(), sourceNumbers.toArray(), materialNames);
    }
}
