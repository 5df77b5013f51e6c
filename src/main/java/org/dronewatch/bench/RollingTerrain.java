package org.dronewatch.bench;

import java.util.List;
import org.dronewatch.geometry.TriangleMesh;

/**
 * Hilly ground with any number of triangles; always the same ground for the same number. It is 1 km square, with z up.
 */
public final class RollingTerrain {
    private static final double SIZE = 1000.0;
    private static final double HEIGHT = 60.0;
    private static final int OCTAVES = 9;
    /** Turns each octave against the last, so that ridges do not line up. */
    private static final double TURN = 1.1;

    private RollingTerrain() {}

    /** A mesh of about this number of triangles, 2 or more. */
    public static TriangleMesh of(int triangles) {
        int cells = Math.max(1, (int) Math.round(Math.sqrt(0.5 * triangles)));
        float[] vertices = new float[3 * (cells + 1) * (cells + 1)];
        for (int i = 0; i <= cells; i++) {
            for (int j = 0; j <= cells; j++) {
                int at = 3 * (i * (cells + 1) + j);
                double x = SIZE * ((double) j / cells - 0.5);
                double y = SIZE * ((double) i / cells - 0.5);
                vertices[at] = (float) x;
                vertices[at + 1] = (float) y;
                vertices[at + 2] = (float) height(x, y);
            }
        }
        int[] corners = new int[6 * cells * cells];
        for (int cell = 0; cell < cells * cells; cell++) {
            int low = cell / cells * (cells + 1) + cell % cells;
            int high = low + cells + 1;
            int[] two = {low, low + 1, high + 1, low, high + 1, high};
            System.arraycopy(two, 0, corners, 6 * cell, two.length);
        }
        int[] numbers = new int[2 * cells * cells];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = i;
        }
        return new TriangleMesh(vertices, corners, new int[numbers.length], numbers, List.of("ground"));
    }

    /** Height of the ground, m. */
    static double height(double x, double y) {
        double height = 0.0;
        double wave = SIZE / 1.7;
        double amplitude = HEIGHT;
        double turn = 0.3;
        for (int octave = 0; octave < OCTAVES; octave++) {
            double along = x * Math.cos(turn) + y * Math.sin(turn);
            double across = y * Math.cos(turn) - x * Math.sin(turn);
            height += amplitude * Math.sin(2.0 * Math.PI * along / wave) * Math.cos(2.0 * Math.PI * across / wave);
            wave *= 0.47;
            amplitude *= 0.42;
            turn += TURN;
        }
        return height;
    }
}
