package org.dronewatch.kdtree;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.TriangleMesh;

/**
 * A mesh and rays as text, one item per line, so that lines can be taken away one by one: {@code t} and nine
 * coordinates, {@code r} and an origin and a direction.
 */
final class TriangleText {
    private static final double LEAST_SQUARENESS = 1e-7;

    private final List<float[]> triangles = new ArrayList<>();
    private final List<double[]> rays = new ArrayList<>();

    void triangle(float... coordinates) {
        if (coordinates.length != 9) {
            throw new IllegalArgumentException(coordinates.length + " coordinates");
        }
        triangles.add(coordinates);
    }

    void ray(double... originAndDirection) {
        rays.add(originAndDirection);
    }

    List<float[]> triangles() {
        return triangles;
    }

    List<double[]> rays() {
        return rays;
    }

    /** The mesh of the triangles that have an area; the others are left out, as when a file is read. */
    TriangleMesh mesh() {
        List<float[]> kept = triangles.stream()
                .filter(triangle -> squareness(triangle) > 0.0)
                .toList();
        float[] vertices = new float[9 * kept.size()];
        int[] corners = new int[3 * kept.size()];
        for (int i = 0; i < vertices.length; i++) {
            vertices[i] = kept.get(i / 9)[i % 9];
        }
        for (int i = 0; i < corners.length; i++) {
            corners[i] = i;
        }
        return TriangleMesh.of(vertices, corners);
    }

    /** Whether no triangle is so thin, or so small, that doubles do not hold its area. */
    boolean hasShape() {
        return triangles.stream().mapToDouble(TriangleText::squareness).allMatch(s -> s == 0.0 || s > LEAST_SQUARENESS);
    }

    /** The area divided by the square of the longest side. */
    private static double squareness(float[] t) {
        double[] normal = new double[3];
        double longest = 0;
        for (int k = 0; k < 3; k++) {
            int l = (k + 1) % 3;
            int m = (k + 2) % 3;
            normal[k] = ((double) t[3 + l] - t[l]) * ((double) t[6 + m] - t[m])
                    - ((double) t[3 + m] - t[m]) * ((double) t[6 + l] - t[l]);
            longest = Math.max(longest, Math.abs((double) t[3 + k] - t[k]));
            longest = Math.max(longest, Math.abs((double) t[6 + k] - t[k]));
        }
        double area = Math.hypot(normal[0], Math.hypot(normal[1], normal[2]));
        return area > 0.0 ? area / longest / longest : 0.0;
    }

    String write() {
        StringBuilder text = new StringBuilder();
        for (float[] triangle : triangles) {
            text.append('t');
            for (float coordinate : triangle) {
                text.append(' ').append(coordinate);
            }
            text.append('\n');
        }
        for (double[] ray : rays) {
            text.append('r');
            for (double number : ray) {
                text.append(' ').append(number);
            }
            text.append('\n');
        }
        return text.toString();
    }

    static TriangleText read(String text) {
        TriangleText read = new TriangleText();
        text.lines().forEach(line -> {
            String[] words = line.split(" ");
            if (words[0].equals("t")) {
                float[] triangle = new float[9];
                for (int i = 0; i < 9; i++) {
                    triangle[i] = Float.parseFloat(words[i + 1]);
                }
                read.triangle(triangle);
            } else if (words[0].equals("r")) {
                double[] ray = new double[6];
                for (int i = 0; i < 6; i++) {
                    ray[i] = Double.parseDouble(words[i + 1]);
                }
                read.ray(ray);
            }
        });
        return read;
    }
}
