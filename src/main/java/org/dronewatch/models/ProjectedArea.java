package org.dronewatch.models;

import java.util.Arrays;
import java.util.List;

/**
 * Area that a mesh covers when seen from far away along an axis. The outline is cut into thin strips; in each strip the
 * exact spans of all triangles along its middle line are merged, so that overlapping parts count once.
 */
public final class ProjectedArea {
    /** A direction of view along one of the model's axes. */
    public enum View {
        /** Along z: from the nose. */
        FRONT,
        /** Along x: from the side. */
        SIDE,
        /** Along y: from above. */
        TOP
    }

    private static final int STRIPS = 20_000;

    private ProjectedArea() {}

    /** Area in square metres; the same from the opposite direction. */
    public static double area(Mesh mesh, View view) {
        List<Point> vertices = mesh.vertices();
        double[] u = vertices.stream()
                .mapToDouble(p -> view == View.SIDE ? p.z() : p.x())
                .toArray();
        double[] v = vertices.stream()
                .mapToDouble(p -> view == View.TOP ? p.z() : p.y())
                .toArray();
        double low = Arrays.stream(v).min().orElse(0);
        double height = (Arrays.stream(v).max().orElse(0) - low) / STRIPS;
        int[] triangles = mesh.triangles();
        double[][] spans = new double[STRIPS][];
        int[] counts = new int[STRIPS];
        for (int i = 0; i < triangles.length; i += 3) {
            double[] a = {u[triangles[i]], u[triangles[i + 1]], u[triangles[i + 2]]};
            double[] b = {v[triangles[i]], v[triangles[i + 1]], v[triangles[i + 2]]};
            double bottom = Math.min(b[0], Math.min(b[1], b[2]));
            double top = Math.max(b[0], Math.max(b[1], b[2]));
            int first = Math.max((int) Math.ceil((bottom - low) / height - 0.5), 0);
            for (int strip = first; strip < STRIPS && low + (strip + 0.5) * height <= top; strip++) {
                addSpan(spans, counts, strip, a, b, low + (strip + 0.5) * height);
            }
        }
        double covered = 0;
        for (int strip = 0; strip < STRIPS; strip++) {
            covered += joined(spans[strip], counts[strip]);
        }
        return covered * height;
    }

    /** Where the line at height {@code line} crosses the triangle's edges. */
    private static void addSpan(double[][] spans, int[] counts, int strip, double[] a, double[] b, double line) {
        double from = Double.POSITIVE_INFINITY;
        double to = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3;
            if (b[k] <= line != b[next] <= line) {
                double x = a[k] + (a[next] - a[k]) * (line - b[k]) / (b[next] - b[k]);
                from = Math.min(from, x);
                to = Math.max(to, x);
            }
        }
        if (from < to) {
            int n = counts[strip];
            if (spans[strip] == null) {
                spans[strip] = new double[16];
            } else if (2 * n == spans[strip].length) {
                spans[strip] = Arrays.copyOf(spans[strip], 4 * n);
            }
            spans[strip][2 * n] = from;
            spans[strip][2 * n + 1] = to;
            counts[strip]++;
        }
    }

    /** Length of the union of the given number of spans. */
    private static double joined(double[] spans, int count) {
        double[][] sorted = new double[count][];
        for (int i = 0; i < count; i++) {
            sorted[i] = new double[] {spans[2 * i], spans[2 * i + 1]};
        }
        Arrays.sort(sorted, (p, q) -> Double.compare(p[0], q[0]));
        double length = 0;
        double reach = Double.NEGATIVE_INFINITY;
        for (double[] span : sorted) {
            length += Math.max(0, span[1] - Math.max(span[0], reach));
            reach = Math.max(reach, span[1]);
        }
        return length;
    }
}
