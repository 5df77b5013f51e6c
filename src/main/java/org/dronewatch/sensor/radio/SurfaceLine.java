package org.dronewatch.sensor.radio;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Ground;

/**
 * The surface that reflects along a path: the straight line that best fits the heights of a site on both sides of a
 * place on it. For use by one thread.
 */
final class SurfaceLine {
    /** Heights in a Fresnel zone. */
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
     * @param from where the path begins
     * @param to where it ends
     * @param width of the path on a map, above 0, m
     * @param at the place, measured on the map from where the path begins, m
     * @param reach how far the line is to fit on either side, m
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

    /** Its height at a distance from where the path begins, m. */
    double height(double distance) {
        return base + slope * distance;
    }

    /** How much it rises per metre. */
    double slope() {
        return slope;
    }

    /** Standard deviation of the heights from it, m. */
    double uneven() {
        return uneven;
    }
}
