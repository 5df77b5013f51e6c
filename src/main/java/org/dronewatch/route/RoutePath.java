package org.dronewatch.route;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.Position;

/**
 * A path of straight legs.
 *
 * @param points from the first to the last, at least one, m
 * @param modes for each leg, the number of the mode in which it is flown
 */
public record RoutePath(List<Position> points, List<Integer> modes) {
    /**
     * Copies the lists.
     *
     * @throws IllegalArgumentException unless there is one mode for each leg
     */
    public RoutePath {
        points = List.copyOf(points);
        modes = List.copyOf(modes);
        if (points.isEmpty() || modes.size() != points.size() - 1) {
            throw new IllegalArgumentException(
                    points.size() + " points with " + modes.size() + " modes: must be one mode for each leg");
        }
    }

    /** The length, m. */
    public double length() {
        double length = 0.0;
        for (int i = 0; i < modes.size(); i++) {
            length += points.get(i).distance(points.get(i + 1));
        }
        return length;
    }

    /** This path, continued by another that begins where it ends. */
    RoutePath then(RoutePath other) {
        List<Position> all = new ArrayList<>(points);
        all.addAll(other.points.subList(1, other.points.size()));
        List<Integer> both = new ArrayList<>(modes);
        both.addAll(other.modes);
        return new RoutePath(all, both);
    }
}
