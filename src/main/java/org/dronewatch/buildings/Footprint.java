package org.dronewatch.buildings;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.maplibre.earcut4j.Earcut;

/**
 * The outline of a building on the plane of the world frame, x east and y north, m.
 *
 * @param outer the outline, counter-clockwise
 * @param courts courtyards, clockwise
 */
record Footprint(double[] outer, List<double[]> courts) {
    /** Triangles must cover the outline except for this fraction of its area. */
    private static final double PRECISION = 1e-6;

    /** An outline and its courtyards, in any direction. */
    static Footprint of(double[] outer, List<double[]> courts) {
        return new Footprint(
                Rings.wound(outer, true),
                courts.stream().map(court -> Rings.wound(court, false)).toList());
    }

    /** The area without courtyards, m2. */
    double area() {
        double area = Rings.signedArea(outer);
        for (double[] court : courts) {
            area += Rings.signedArea(court);
        }
        return area;
    }

    boolean contains(double x, double y) {
        return Rings.contains(outer, x, y) && courts.stream().noneMatch(court -> Rings.contains(court, x, y));
    }

    /** The outline and the courtyards. */
    List<double[]> rings() {
        List<double[]> rings = new ArrayList<>();
        rings.add(outer);
        rings.addAll(courts);
        return rings;
    }

    /**
     * Triangles between the corners.
     *
     * @param corners the numbers of the three corners of each triangle, counter-clockwise; the corners of all
     *     {@link #rings} are numbered in turn
     * @param area area that the triangles cover together, m2
     * @param isWhole whether they cover the whole outline; false if the outline crosses itself
     */
    record Cut(int[] corners, double area, boolean isWhole) {}

    /** Cuts the area between outline and courtyards into triangles. */
    Cut cut() {
        List<double[]> rings = rings();
        double[] points =
                new double[rings.stream().mapToInt(ring -> ring.length).sum()];
        int[] holes = new int[courts.size()];
        int at = 0;
        for (int ring = 0; ring < rings.size(); ring++) {
            if (ring > 0) {
                holes[ring - 1] = at / 2;
            }
            double[] corners = rings.get(ring);
            for (int i = 0; i < corners.length; i += 2) {
                // Relative to the first corner, so that nothing is lost far from the origin.
                points[at++] = corners[i] - outer[0];
                points[at++] = corners[i + 1] - outer[1];
            }
        }
        List<Integer> ears = Earcut.earcut(points, holes, 2);
        int[] triangles = new int[ears.size()];
        double covered = 0.0;
        for (int i = 0; i < triangles.length; i += 3) {
            int a = ears.get(i);
            int b = ears.get(i + 1);
            int c = ears.get(i + 2);
            double twice = (points[2 * b] - points[2 * a]) * (points[2 * c + 1] - points[2 * a + 1])
                    - (points[2 * b + 1] - points[2 * a + 1]) * (points[2 * c] - points[2 * a]);
            covered += 0.5 * Math.abs(twice);
            triangles[i] = a;
            triangles[i + 1] = twice > 0.0 ? b : c;
            triangles[i + 2] = twice > 0.0 ? c : b;
        }
        return new Cut(triangles, covered, Math.abs(covered - area()) <= PRECISION * area());
    }

    /** A point inside, x and y: the middle of the largest triangle. */
    double[] inside() {
        int[] corners = cut().corners();
        double[] all = rings().stream().flatMapToDouble(Arrays::stream).toArray();
        double[] middle = {outer[0], outer[1]};
        double greatest = 0.0;
        for (int i = 0; i < corners.length; i += 3) {
            double ax = all[2 * corners[i]];
            double ay = all[2 * corners[i] + 1];
            double bx = all[2 * corners[i + 1]];
            double by = all[2 * corners[i + 1] + 1];
            double cx = all[2 * corners[i + 2]];
            double cy = all[2 * corners[i + 2] + 1];
            double area = Math.abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax));
            if (area > greatest) {
                greatest = area;
                middle[0] = (ax + bx + cx) / 3.0;
                middle[1] = (ay + by + cy) / 3.0;
            }
        }
        return middle;
    }
}
