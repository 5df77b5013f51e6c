package org.dronewatch.analysis.cell;

import java.util.List;
import org.dronewatch.world.GroundPoint;

/**
 * The smallest square, aligned with the axes, around points in plan view.
 *
 * @param east east coordinate of its centre, m
 * @param north north coordinate of its centre, m
 * @param side length of its side, m
 */
record PlanBounds(double east, double north, double side) {

    static PlanBounds of(List<GroundPoint> points) {
        double west = points.stream().mapToDouble(GroundPoint::x).min().orElseThrow();
        double east = points.stream().mapToDouble(GroundPoint::x).max().orElseThrow();
        double south = points.stream().mapToDouble(GroundPoint::y).min().orElseThrow();
        double north = points.stream().mapToDouble(GroundPoint::y).max().orElseThrow();
        return new PlanBounds(0.5 * (west + east), 0.5 * (south + north), Math.max(east - west, north - south));
    }
}
