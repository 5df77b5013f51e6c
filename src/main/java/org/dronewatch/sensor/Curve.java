package org.dronewatch.sensor;

import java.util.List;

/**
 * A curve of a sensor for one drone, as data for a plot.
 *
 * @param name part of a file name: letters, digits and dashes
 * @param title title of the plot, including the result
 * @param xTitle quantity and unit of the horizontal axis; an axis in {@code [Hz]} is logarithmic
 * @param yTitle quantity and unit of the vertical axis
 * @param x horizontal coordinates
 * @param y vertical coordinates, as many as {@code x}
 */
public record Curve(String name, String title, String xTitle, String yTitle, List<Double> x, List<Double> y) {

    /** Copies the lists: later changes by the caller have no effect. */
    public Curve {
        x = List.copyOf(x);
        y = List.copyOf(y);
        if (x.size() != y.size()) {
            throw new IllegalArgumentException(
                    "x and y of curve '" + name + "' differ in length: " + x.size() + " and " + y.size());
        }
    }
}
