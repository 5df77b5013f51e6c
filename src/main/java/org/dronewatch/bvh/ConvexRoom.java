package org.dronewatch.bvh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronewatch.kdtree.LeafOrderTriangles;

/**
 * A closed convex room of a few triangles, such as a box. From inside, a ray hits the wall whose plane it crosses
 * first. A wall is one triangle or two in one plane. Immutable, shared by all threads.
 */
final class ConvexRoom {
    /** Numbers of a plane: a unit vector, and the component along it of the plane's points. */
    static final int PLANE = 4;

    /** The distance by which rounding may move a corner off a plane in which it lies, relative to the room's size. */
    private static final double ROUNDING = 1e-13;

    private final CornerTable table;
    private final double tolerance;
    private final List<Wall> walls = new ArrayList<>();

    private ConvexRoom(CornerTable table) {
        this.table = table;
        double size = 0.0;
        for (int corner = 0; corner < table.count(); corner++) {
            size = Math.max(size, length(table.corner(corner)));
        }
        this.tolerance = ROUNDING * size;
    }

    /** The room whose triangles these are; empty if they are not a closed convex room. */
    static Optional<ConvexRoom> of(LeafOrderTriangles triangles) {
        ConvexRoom room = new ConvexRoom(new CornerTable(triangles.corners()));
        boolean exists = triangles.count() > 0 && room.findWalls() && room.isClosed();
        return exists ? Optional.of(room) : Optional.empty();
    }

    /** The planes of all walls; their unit vectors point outward. */
    double[] planes() {
        return walls.stream().flatMapToDouble(wall -> Arrays.stream(wall.plane)).toArray();
    }

    /** Planes that divide each wall into its triangles: the second lies where their vectors point. */
    double[] dividers() {
        return walls.stream()
                .flatMapToDouble(wall -> Arrays.stream(wall.divider))
                .toArray();
    }

    /** The two triangles of each wall, in leaf order; the same one twice if it has only one. */
    int[] triangles() {
        return walls.stream()
                .flatMapToInt(wall -> IntStream.of(wall.first, wall.second))
                .toArray();
    }

    /** Number of walls. */
    int count() {
        return walls.size();
    }

    /** A wall, to which a second triangle may be added. */
    private static final class Wall {
        final int first;
        final double[] plane;
        final double[] divider = new double[PLANE];
        int second;

        Wall(int first, double[] plane) {
            this.first = first;
            this.second = first;
            this.plane = plane;
        }
    }

    /** Whether the triangles lie in walls of a convex room: all other corners are on one side of each. */
    private boolean findWalls() {
        for (int triangle = 0; triangle < table.triangles(1).length / 3; triangle++) {
            Optional<double[]> plane = outwardPlane(triangle);
            if (plane.isEmpty() || !add(triangle, plane.get())) {
                return false;
            }
        }
        return true;
    }

    private Optional<double[]> outwardPlane(int triangle) {
        double[] a = corner(triangle, 0);
        double[] normal = cross(minus(corner(triangle, 1), a), minus(corner(triangle, 2), a));
        double area = length(normal);
        if (!(area > 0.0)) {
            return Optional.empty();
        }
        double[] plane = plane(normal, 1.0 / area, a);
        double lowest = 0.0;
        double highest = 0.0;
        for (int corner = 0; corner < table.count(); corner++) {
            double height = height(plane, table.corner(corner));
            lowest = Math.min(lowest, height);
            highest = Math.max(highest, height);
        }
        if (highest <= tolerance && lowest < -tolerance) {
            return Optional.of(plane);
        }
        return lowest >= -tolerance && highest > tolerance
                ? Optional.of(plane(normal, -1.0 / area, a))
                : Optional.empty();
    }

    private boolean add(int triangle, double[] plane) {
        for (Wall wall : walls) {
            if (isIn(wall, triangle)) {
                return wall.second == wall.first && divide(wall, triangle);
            }
        }
        walls.add(new Wall(triangle, plane));
        return true;
    }

    private boolean isIn(Wall wall, int triangle) {
        for (int k = 0; k < 3; k++) {
            if (Math.abs(height(wall.plane, corner(triangle, k))) > tolerance) {
                return false;
            }
        }
        return true;
    }

    /** Adds the second triangle to a wall; returns whether it lies beside the first one, on one of its edges. */
    private boolean divide(Wall wall, int triangle) {
        for (int k = 0; k < 3; k++) {
            double[] from = corner(wall.first, k);
            double[] along = minus(corner(wall.first, (k + 1) % 3), from);
            double[] across = cross(wall.plane, along);
            double[] divider = plane(across, 1.0 / length(across), from);
            if (height(divider, corner(wall.first, (k + 2) % 3)) > 0.0) {
                divider = plane(across, -1.0 / length(across), from);
            }
            if (isBeyond(divider, triangle)) {
                System.arraycopy(divider, 0, wall.divider, 0, PLANE);
                wall.second = triangle;
                return true;
            }
        }
        return false;
    }

    private boolean isBeyond(double[] divider, int triangle) {
        for (int k = 0; k < 3; k++) {
            if (height(divider, corner(triangle, k)) < -tolerance) {
                return false;
            }
        }
        return true;
    }

    /** Whether each edge belongs to two triangles: of the surface of a convex body, only the whole is closed. */
    private boolean isClosed() {
        int[] corners = table.triangles(1);
        Map<List<Integer>, Integer> edges = new HashMap<>();
        for (int i = 0; i < corners.length; i++) {
            int from = corners[i];
            int to = corners[i / 3 * 3 + (i + 1) % 3];
            edges.merge(List.of(Math.min(from, to), Math.max(from, to)), 1, Integer::sum);
        }
        return edges.values().stream().allMatch(triangles -> triangles == 2);
    }

    private double[] corner(int triangle, int number) {
        return table.corner(table.triangles(1)[3 * triangle + number]);
    }

    private static double[] plane(double[] normal, double scale, double[] through) {
        double x = scale * normal[0];
        double y = scale * normal[1];
        double z = scale * normal[2];
        return new double[] {x, y, z, x * through[0] + y * through[1] + z * through[2]};
    }

    private static double height(double[] plane, double[] point) {
        return plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] - plane[3];
    }

    private static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {
            a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0],
        };
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
}
