package org.dronewatch.models;

import java.util.List;

/**
 * An axis-aligned box, metres.
 *
 * @param min corner with the least coordinates
 * @param max corner with the greatest coordinates
 */
public record Extent(Point min, Point max) {

    /** Smallest box around some points. */
    public static Extent of(List<Point> points) {
        if (points.isEmpty()) {
            throw new IllegalArgumentException("an extent needs at least one point");
        }
        double[] low = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE};
        double[] high = {-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
        for (Point p : points) {
            double[] xyz = {p.x(), p.y(), p.z()};
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], xyz[axis]);
                high[axis] = Math.max(high[axis], xyz[axis]);
            }
        }
        return new Extent(new Point(low[0], low[1], low[2]), new Point(high[0], high[1], high[2]));
    }

    /** Edge lengths along x, y and z, metres. */
    public Point size() {
        return max.minus(min);
    }
}
