package org.dronewatch.mesh.polygon;

import org.dronewatch.geometry.Floats;

/**
 * A polygon as seen along its mean normal, from the side from which its corners run counter-clockwise. Coordinates are
 * relative to its first corner, so that they lose nothing far from the origin.
 */
final class FlatPolygon {
    /** The largest relative error of a coordinate that was rounded to a float. */
    private static final double FLOAT_ROUNDING = 0x1p-24;

    /** The relative rounding error of sums of products. */
    private static final double ROUNDING = 1e-12;

    /** Errors of the area below this fraction of it are negligible. */
    static final double NEGLIGIBLE = 1e-6;

    private final double[] coordinates;
    private final double doubleArea;
    private final double perimeter;
    private final double coordinateError;
    private final double widest;

    /**
     * Projects a polygon.
     *
     * @param vertices x, y, z of each vertex in turn
     * @param polygon vertex indices of its corners in turn
     */
    FlatPolygon(Floats vertices, int[] polygon) {
        double[] corners = relative(vertices, polygon);
        double[] normal = normal(corners);
        double length = Math.sqrt(dot(normal, normal));
        this.coordinateError = FLOAT_ROUNDING * largest(vertices, polygon);
        this.coordinates = project(corners, normal, length);
        this.doubleArea = length;
        this.perimeter = perimeter(corners);
        this.widest = widest(corners);
    }

    private static double[] relative(Floats vertices, int[] polygon) {
        double[] corners = new double[3 * polygon.length];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = (double) vertices.get(3 * polygon[i / 3] + i % 3) - vertices.get(3 * polygon[0] + i % 3);
        }
        return corners;
    }

    private static double largest(Floats vertices, int[] polygon) {
        double largest = 0.0;
        for (int vertex : polygon) {
            for (int axis = 0; axis < 3; axis++) {
                largest = Math.max(largest, Math.abs(vertices.get(3 * vertex + axis)));
            }
        }
        return largest;
    }

    /** Newell's normal: the mean one of a polygon that is not plane, as long as twice its area. */
    private static double[] normal(double[] corners) {
        double[] normal = new double[3];
        int size = corners.length;
        for (int i = 0; i < size; i += 3) {
            int next = (i + 3) % size;
            for (int axis = 0; axis < 3; axis++) {
                int u = (axis + 1) % 3;
                int v = (axis + 2) % 3;
                normal[axis] += corners[i + u] * corners[next + v] - corners[i + v] * corners[next + u];
            }
        }
        return normal;
    }

    private static double perimeter(double[] corners) {
        double perimeter = 0.0;
        for (int i = 0; i < corners.length; i++) {
            perimeter += Math.abs(corners[(i + 3) % corners.length] - corners[i]);
        }
        return perimeter;
    }

    /** Twice the area of the largest triangle of a fan from the first corner. */
    private static double widest(double[] corners) {
        double largest = 0.0;
        for (int i = 3; i + 3 < corners.length; i += 3) {
            double[] normal = cross(
                    new double[] {corners[i], corners[i + 1], corners[i + 2]},
                    new double[] {corners[i + 3], corners[i + 4], corners[i + 5]});
            largest = Math.max(largest, dot(normal, normal));
        }
        return Math.sqrt(largest);
    }

    private static double[] project(double[] corners, double[] normal, double length) {
        double[] flat = new double[corners.length / 3 * 2];
        if (length == 0.0) {
            return flat;
        }
        double[] up = {normal[0] / length, normal[1] / length, normal[2] / length};
        double[] right = across(up);
        double[] ahead = cross(up, right);
        for (int i = 0; i < corners.length / 3; i++) {
            for (int axis = 0; axis < 3; axis++) {
                flat[2 * i] += corners[3 * i + axis] * right[axis];
                flat[2 * i + 1] += corners[3 * i + axis] * ahead[axis];
            }
        }
        return flat;
    }

    /** A unit vector perpendicular to a unit vector: exactly an axis, if one is perpendicular to it. */
    private static double[] across(double[] up) {
        int axis = 0;
        for (int k = 1; k < 3; k++) {
            if (Math.abs(up[k]) < Math.abs(up[axis])) {
                axis = k;
            }
        }
        double[] right = {-up[axis] * up[0], -up[axis] * up[1], -up[axis] * up[2]};
        right[axis] += 1.0;
        double length = Math.sqrt(dot(right, right));
        return new double[] {right[0] / length, right[1] / length, right[2] / length};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    int size() {
        return coordinates.length / 2;
    }

    /** x and y of each corner in turn. */
    double[] coordinates() {
        return coordinates.clone();
    }

    double x(int corner) {
        return coordinates[2 * corner];
    }

    double y(int corner) {
        return coordinates[2 * corner + 1];
    }

    /** Twice its area: where it winds clockwise, or crosses itself, less than it covers. */
    double doubleArea() {
        return doubleArea;
    }

    /** Twice the area of a triangle of its corners, negative for a clockwise one. */
    double doubleArea(int a, int b, int c) {
        return (x(b) - x(a)) * (y(c) - y(a)) - (y(b) - y(a)) * (x(c) - x(a));
    }

    /** How far the rounding to floats may have moved a corner along an axis, m. */
    double coordinateError() {
        return coordinateError;
    }

    /** Whether it has no plane: its corners lie in a line, or the windings of its parts cancel. */
    boolean isWithoutPlane() {
        return doubleArea <= ROUNDING * perimeter * perimeter;
    }

    /** Whether the rounding of its corners may be all that gives it an area. */
    boolean isThin() {
        return doubleArea <= coordinateError * perimeter && widest <= coordinateError * perimeter;
    }

    /**
     * Whether a fan from its first corner covers it: no triangle is turned over by more than the rounding of its
     * corners can cause, and those that are turned over have a negligible area.
     */
    boolean isSeenFromItsFirstCorner() {
        double turned = 0.0;
        for (int i = 1; i + 1 < size(); i++) {
            double area = doubleArea(0, i, i + 1);
            double reach = Math.abs(x(i)) + Math.abs(y(i)) + Math.abs(x(i + 1)) + Math.abs(y(i + 1));
            if (area < -coordinateError * reach) {
                return false;
            }
            turned -= Math.min(0.0, area);
        }
        return turned <= NEGLIGIBLE * doubleArea;
    }
}
