package org.dronewatch.sensor.acoustic.imagesource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.geometry.TriangleMesh;

/** Assigns triangles to planes, one after another. */
final class WallGrouping {
    /** Planes whose unit normals differ by more than this in any coordinate are not compared. */
    private static final double NORMAL_CELL = 1e-2;

    /**
     * The normal of a plane is the one that points to this side, whatever the winding of its triangles; any other
     * direction would do as well.
     */
    private static final double[] SIDE = {0.6, 0.48, 0.64};

    /** Normals whose component along this direction is smaller than this may have been assigned to either side. */
    private static final double EITHER_SIDE = 0.05;

    private final TriangleMesh mesh;
    private final double tolerance;
    private final double[] normal = new double[3];
    private final List<double[]> found = new ArrayList<>();
    private final List<Integer> largest = new ArrayList<>();
    private final Map<Integer, List<Integer>> byNormal = new HashMap<>();

    /**
     * A grouping without any triangles yet.
     *
     * @param tolerance maximum distance of a corner from the plane of its triangle, m
     */
    WallGrouping(TriangleMesh mesh, double tolerance) {
        this.mesh = mesh;
        this.tolerance = tolerance;
    }

    float area(int triangle) {
        mesh.normal(triangle, normal);
        return (float) (0.5 * length());
    }

    private double length() {
        return Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    }

    /** Assigns a triangle to a known plane, or to a new one, and returns the number of that plane. */
    int add(int triangle) {
        mesh.normal(triangle, normal);
        double length = length();
        for (int axis = 0; axis < 3; axis++) {
            normal[axis] /= length;
        }
        double side = normal[0] * SIDE[0] + normal[1] * SIDE[1] + normal[2] * SIDE[2];
        double sign = side < 0.0 ? -1.0 : 1.0;
        for (int axis = 0; axis < 3; axis++) {
            normal[axis] *= sign;
        }
        int wall = find(triangle, 1.0);
        if (wall == WallPlanes.NONE && Math.abs(side) < EITHER_SIDE) {
            wall = find(triangle, -1.0);
        }
        return wall == WallPlanes.NONE ? open(triangle) : wall;
    }

    private int open(int triangle) {
        double offset = normal[0] * mesh.coordinate(triangle, 0, 0)
                + normal[1] * mesh.coordinate(triangle, 0, 1)
                + normal[2] * mesh.coordinate(triangle, 0, 2);
        found.add(new double[] {normal[0], normal[1], normal[2], offset});
        largest.add(triangle);
        int cell = key(cell(normal[0]), cell(normal[1]), cell(normal[2]));
        byNormal.computeIfAbsent(cell, key -> new ArrayList<>()).add(found.size() - 1);
        return found.size() - 1;
    }

    private int find(int triangle, double sign) {
        int x = cell(sign * normal[0]);
        int y = cell(sign * normal[1]);
        int z = cell(sign * normal[2]);
        for (int i = -1; i <= 1; i++) {
            for (int j = -1; j <= 1; j++) {
                for (int k = -1; k <= 1; k++) {
                    int cell = key(x + i, y + j, z + k);
                    for (int wall : byNormal.getOrDefault(cell, List.of())) {
                        if (contains(found.get(wall), triangle)) {
                            return wall;
                        }
                    }
                }
            }
        }
        return WallPlanes.NONE;
    }

    private boolean contains(double[] plane, int triangle) {
        for (int corner = 0; corner < 3; corner++) {
            double height = plane[0] * mesh.coordinate(triangle, corner, 0)
                    + plane[1] * mesh.coordinate(triangle, corner, 1)
                    + plane[2] * mesh.coordinate(triangle, corner, 2)
                    - plane[3];
            if (Math.abs(height) > tolerance) {
                return false;
            }
        }
        return true;
    }

    private static int cell(double coordinate) {
        return (int) Math.round(coordinate / NORMAL_CELL);
    }

    /** Cells are numbered from -100 to 100 along each axis. */
    private static int key(int x, int y, int z) {
        return x << 2 * Byte.SIZE ^ (y & 0xFF) << Byte.SIZE ^ z & 0xFF;
    }

    double[] planes() {
        return found.stream().flatMapToDouble(Arrays::stream).toArray();
    }

    int[] triangles() {
        return largest.stream().mapToInt(Integer::intValue).toArray();
    }
}
