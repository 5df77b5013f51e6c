package org.dronewatch.sensor.radio;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Ground;

/**
 * The reflecting surface along a path: the straight line that best fits the heights of a site on both sides of a
 * position on the path. For use by one thread.
 */
final class SurfaceLine {
    /** Number of heights sampled in a Fresnel zone. */
    private static final int SAMPLES = 9;

    private final Ground ground;
    private final double[] heights = new double[SAMPLES];
    private final double[] places = new double[SAMPLES];
    private double base;
    private double slope;
    private double uneven;

    SurfaceLine(Ground ground) {
        this.ground = ground;
    }

    /**
     * Fits the line.
     *
     * @param from the beginning of the path
     * @param to the end of the path
     * @param width horizontal length of the path, above 0, m
     * @param at horizontal distance of the position from the beginning of the path, m
     * @param reach distance on either side over which the line is to fit, m
     * @return whether there is ground everywhere
     */
    boolean fit(Position from, Position to, double width, double at, double reach) {
        double sum = 0.0;
        double sumX = 0.0;
        for (int i = 0; i < SAMPLES; i++) {
            places[i] = at + reach * (2.0 * i / (SAMPLES - 1) - 1.0);
            double share = places[i] / width;
            OptionalDouble height =
                    ground.height(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()));
            if (height.isEmpty()) {
                return false;
            }
            heights[i] = height.getAsDouble();
            sum += heights[i];
            sumX += places[i];
        }
        fit(sum / SAMPLES, sumX / SAMPLES);
        return true;
    }

    private void fit(double mean, double middle) {
        double square = 0.0;
        double product = 0.0;
        for (int i = 0; i < SAMPLES; i++) {
            square += (places[i] - middle) * (places[i] - middle);
            product += (places[i] - middle) * (heights[i] - mean);
        }
        slope = square > 0.0 ? product / square : 0.0;
        base = mean - slope * middle;
        double squares = 0.0;
        for (int i = 0; i < SAMPLES; i++) {
            double off = heights[i] - base - slope * places[i];
            squares += off * off;
        }
        uneven = Math.sqrt(squares / SAMPLES);
    }

    /** The height of the line at a distance from the beginning of the path, m. */
    double height(double distance) {
        return base + slope * distance;
    }

    /** The slope of the line: its rise per metre. */
    double slope() {
        return slope;
    }

    /** Standard deviation of the heights about the line, m. */
    double uneven() {
        return uneven;
    }
}
