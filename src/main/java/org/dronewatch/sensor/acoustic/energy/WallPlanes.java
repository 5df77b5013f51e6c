package org.dronewatch.sensor.acoustic.energy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.geometry.TriangleMesh;

/**
 * The planes of a mesh: one for each triangle, and the largest walls, each of them all triangles in one plane. Specular
 * reflections of higher order are sought between the largest walls only. Immutable.
 */
final class WallPlanes {
    /** Enough for the walls of a few buildings; second-order reflections in smaller planes are found by the rays. */
    static final int LARGEST = 24;

    /** The number of a triangle that is in none of the largest walls. */
    static final int NONE = -1;

    private static final int NUMBERS = 4;
    private static final double NORMAL_GRID = 1e-5;

    /** Relative to the size of the mesh: corners are floats. */
    private static final double PLACE_GRID = 1e-5;

    private final double[] planes;
    private final int[] wallOf;
    private final List<Wall> walls = new ArrayList<>();

    WallPlanes(TriangleMesh mesh, BandSurfaces surfaces) {
        int count = mesh.triangleCount();
        this.planes = new double[NUMBERS * count];
        this.wallOf = new int[count];
        Arrays.fill(wallOf, NONE);
        Map<List<Long>, Wall> found = new HashMap<>();
        double size = size(mesh);
        for (int triangle = 0; triangle < count; triangle++) {
            double area = setPlane(mesh, triangle);
            if (surfaces.mirrors(mesh.material(triangle))) {
                found.computeIfAbsent(key(triangle, size), key -> new Wall()).add(mesh, triangle, area);
            }
        }
        found.values().stream()
                .sorted(Comparator.comparingDouble((Wall wall) -> -wall.area).thenComparingInt(wall -> wall.triangle))
                .limit(LARGEST)
                .forEach(this::keep);
    }

    private void keep(Wall wall) {
        for (int triangle : wall.triangles) {
            wallOf[triangle] = walls.size();
        }
        wall.triangles.clear();
        walls.add(wall);
    }

    private static double size(TriangleMesh mesh) {
        double size = 1.0;
        for (int vertex = 0; vertex < mesh.vertexCount(); vertex++) {
            for (int axis = 0; axis < 3; axis++) {
                size = Math.max(size, Math.abs(mesh.vertexCoordinate(vertex, axis)));
            }
        }
        return size;
    }

    /** Computes a triangle's plane; gives its area. */
    private double setPlane(TriangleMesh mesh, int triangle) {
        double[] normal = new double[3];
        mesh.normal(triangle, normal);
        double nx = normal[0];
        double ny = normal[1];
        double nz = normal[2];
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        // One sign for both sides of a wall, so that triangles of either winding have the same plane.
        double largest = Math.abs(nx) > Math.abs(ny) ? nx : ny;
        double sign = Math.abs(largest) > Math.abs(nz) ? largest : nz;
        double scale = (sign < 0.0 ? -1.0 : 1.0) / length;
        int at = NUMBERS * triangle;
        planes[at] = nx * scale;
        planes[at + 1] = ny * scale;
        planes[at + 2] = nz * scale;
        planes[at + 3] = planes[at] * mesh.coordinate(triangle, 0, 0)
                + planes[at + 1] * mesh.coordinate(triangle, 0, 1)
                + planes[at + 2] * mesh.coordinate(triangle, 0, 2);
        return 0.5 * length;
    }

    private List<Long> key(int triangle, double size) {
        int at = NUMBERS * triangle;
        return List.of(
                Math.round(planes[at] / NORMAL_GRID),
                Math.round(planes[at + 1] / NORMAL_GRID),
                Math.round(planes[at + 2] / NORMAL_GRID),
                Math.round(planes[at + 3] / (PLACE_GRID * size)));
    }

    double normalX(int triangle) {
        return planes[NUMBERS * triangle];
    }

    double normalY(int triangle) {
        return planes[NUMBERS * triangle + 1];
    }

    double normalZ(int triangle) {
        return planes[NUMBERS * triangle + 2];
    }

    /** Signed distance of a point from a triangle's plane, m. */
    double height(int triangle, double x, double y, double z) {
        int at = NUMBERS * triangle;
        return planes[at] * x + planes[at + 1] * y + planes[at + 2] * z - planes[at + 3];
    }

    /** The number of the large wall that a triangle belongs to, or {@link #NONE}. */
    int wallOf(int triangle) {
        return wallOf[triangle];
    }

    int wallCount() {
        return walls.size();
    }

    /** A triangle of a large wall: its plane is the wall's. */
    int triangleOf(int wall) {
        return walls.get(wall).triangle;
    }

    /** Whether a point of a large wall's plane lies in the box around the wall. */
    boolean mayContain(int wall, double x, double y, double z) {
        return walls.get(wall).boxContains(x, y, z);
    }

    /** All triangles in one plane. */
    private static final class Wall {
        private static final double MARGIN = 1e-3;

        private final List<Integer> triangles = new ArrayList<>();
        private final double[] low = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE};
        private final double[] high = {-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
        private int triangle;
        private double area;
        private double largest;

        void add(TriangleMesh mesh, int added, double itsArea) {
            // The largest triangle has the most exact plane.
            if (triangles.isEmpty() || itsArea > largest) {
                triangle = added;
                largest = itsArea;
            }
            triangles.add(added);
            area += itsArea;
            for (int axis = 0; axis < 3; axis++) {
                for (int corner = 0; corner < 3; corner++) {
                    double at = mesh.coordinate(added, corner, axis);
                    low[axis] = Math.min(low[axis], at - MARGIN);
                    high[axis] = Math.max(high[axis], at + MARGIN);
                }
            }
        }

        boolean boxContains(double x, double y, double z) {
            return x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1] && z >= low[2] && z <= high[2];
        }
    }
}
