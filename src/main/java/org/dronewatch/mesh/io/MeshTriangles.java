package org.dronewatch.mesh.io;

import java.util.List;
import org.dronewatch.geometry.Floats;
import org.dronewatch.geometry.Ints;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.polygon.PolygonCutter;

/**
 * The triangles of polygons, numbered in the order in which they come; those without area are left out but keep their
 * numbers.
 */
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
            add(cut.get(i), cut.get(i + 1), cut.get(i + 2), material, numbered + i / 3);
        }
        numbered += polygon.length - 2;
        return covered;
    }

    /** Adds a triangle as it is. */
    void add(int a, int b, int c, int material) {
        add(a, b, c, material, numbered);
        numbered++;
    }

    private void add(int a, int b, int c, int material, int number) {
        if (hasArea(3 * a, 3 * b, 3 * c)) {
            corners.add(a);
            corners.add(b);
            corners.add(c);
            materials.add(material);
            sourceNumbers.add(number);
        }
    }

    /** Whether the vectors from the first corner to the others have a vector product. */
    private boolean hasArea(int a, int b, int c) {
        double ax = vertices.get(a);
        double ay = vertices.get(a + 1);
        double az = vertices.get(a + 2);
        double bx = vertices.get(b) - ax;
        double by = vertices.get(b + 1) - ay;
        double bz = vertices.get(b + 2) - az;
        double cx = vertices.get(c) - ax;
        double cy = vertices.get(c + 1) - ay;
        double cz = vertices.get(c + 2) - az;
        return by * cz - bz * cy != 0.0 || bz * cx - bx * cz != 0.0 || bx * cy - by * cx != 0.0;
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
