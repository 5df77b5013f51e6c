package org.dronewatch.analysis.cell;

import java.util.ArrayList;
import java.util.List;

/**
 * The heights above the ground at which routes are searched for unless others are given. They reach from close to the
 * ground, where terrain and buildings hide a drone, to its ceiling, where it may fly over the beam of a radar: a search
 * that leaves out the lowest or the highest heights may miss a route that no sensor sees.
 */
public final class RouteHeights {
    /** Close together where obstacles are, m. */
    private static final List<Double> LOW = List.of(2.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0, 90.0, 120.0, 150.0);

    /** The first of the heights above all obstacles, m: from here on, each is twice the one before. */
    private static final double OPEN_AIR = 250.0;

    /** The ceiling takes the place of a height that it exceeds by less than this factor. */
    private static final double CLOSE = 1.1;

    private RouteHeights() {}

    /**
     * The heights up to a drone's ceiling: those of 2, 5, 10, 20, 30, 45, 60, 90, 120, 150, 250, 500, 1000 m and so on
     * that the ceiling exceeds by at least 10 %, and the ceiling itself; a ceiling above 10 km counts as 10 km.
     *
     * @param ceiling the greatest height above the ground at which the drone can fly, m, 0.001 or more
     * @return 1 to 17 heights, in ascending order, m
     */
    public static List<Double> upTo(double ceiling) {
        double highest = Math.min(ceiling, FieldGrid.HIGHEST);
        List<Double> heights = new ArrayList<>(LOW);
        for (double height = OPEN_AIR; height < highest; height *= 2.0) {
            heights.add(height);
        }
        heights.removeIf(height -> CLOSE * height > highest);
        heights.add(highest);
        return List.copyOf(heights);
    }
}
