package org.dronewatch.flight.mission;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.geometry.Position;

/**
 * Finds the waypoints of a flight, with the waits at them: they are sampled positions, chosen so that the flight is
 * nowhere farther than a tolerance from the straight lines between them (Douglas and Peucker, Algorithms for the
 * reduction of the number of points required to represent a digitized line, The Canadian Cartographer 10, 1973).
 */
final class PlanSampling {
    /** The time between two samples, s. */
    private static final double STEP = 0.1;

    /** The greatest number of samples: a longer flight is sampled less often. */
    private static final int MOST_SAMPLES = 200_000;

    /** A drone slower than this counts as waiting, m/s. */
    private static final double STILL = 0.02;

    /** The shortest wait that counts, s: a drone is also slow for a moment at a corner. */
    private static final double SHORTEST_WAIT = 1.0;

    /** The finest tolerance, m. */
    private static final double FINEST = 0.5;

    /** The greatest number of waypoints: more are hard to work with in a ground station. */
    private static final int MOST_WAYPOINTS = 1000;

    private final Position[] places;
    private final double step;

    /**
     * A waypoint.
     *
     * @param at position of the waypoint, m
     * @param speed the greatest speed on the leg to it, m/s
     * @param hold time for which the drone waits there, s
     */
    record Waypoint(Position at, double speed, double hold) {}

    /**
     * Waypoints.
     *
     * @param tolerance the greatest distance of a sample from the lines between them, m
     */
    record Waypoints(List<Waypoint> all, double tolerance) {}

    /**
     * Samples a flight.
     *
     * @param until end of the flight, s
     */
    PlanSampling(FlightPath path, double until) {
        int count = (int) Math.min(MOST_SAMPLES, Math.ceil(until / STEP)) + 1;
        this.step = until / (count - 1);
        this.places = new Position[count];
        for (int i = 0; i < count; i++) {
            places[i] = path.at(Math.min(until, i * step)).position();
        }
    }

    Waypoints waypoints() {
        double tolerance = FINEST;
        List<Waypoint> all = waypoints(tolerance);
        while (all.size() > MOST_WAYPOINTS) {
            tolerance *= 2.0;
            all = waypoints(tolerance);
        }
        return new Waypoints(all, tolerance);
    }

    private List<Waypoint> waypoints(double tolerance) {
        boolean[] kept = new boolean[places.length];
        List<Waypoint> all = new ArrayList<>();
        int from = 0;
        int last = 0;
        for (int i = 0; i < places.length; i = last + 1) {
            last = endOfWait(i);
            boolean waits = (last - i) * step >= SHORTEST_WAIT;
            if (!waits) {
                last = i;
            }
            if (waits || last == places.length - 1) {
                keep(kept, from, i, tolerance);
                append(all, kept, from, i);
                Waypoint end = all.isEmpty() ? new Waypoint(places[0], 0.0, 0.0) : all.remove(all.size() - 1);
                // The drone stays at the end of the flight in any case.
                double hold = last == places.length - 1 ? 0.0 : (last - i) * step;
                all.add(new Waypoint(end.at, end.speed, hold));
                from = last;
            }
        }
        return all;
    }

    /** The last sample at which the drone is still at its position at the given one. */
    private int endOfWait(int first) {
        int last = first;
        while (last + 1 < places.length && places[last + 1].distance(places[last]) <= STILL * step) {
            last++;
        }
        return last;
    }

    /** Marks the first and the last of some samples, and those between them that are needed. */
    private void keep(boolean[] kept, int first, int last, double tolerance) {
        kept[first] = true;
        kept[last] = true;
        Deque<int[]> waiting = new ArrayDeque<>();
        waiting.push(new int[] {first, last});
        while (!waiting.isEmpty()) {
            int[] range = waiting.pop();
            int furthest = -1;
            double most = tolerance;
            for (int i = range[0] + 1; i < range[1]; i++) {
                double off = distance(places[i], places[range[0]], places[range[1]]);
                if (off > most) {
                    most = off;
                    furthest = i;
                }
            }
            if (furthest >= 0) {
                kept[furthest] = true;
                waiting.push(new int[] {range[0], furthest});
                waiting.push(new int[] {furthest, range[1]});
            }
        }
    }

    /** The distance of a point from a segment, m. */
    private static double distance(Position point, Position from, Position to) {
        Position segment = to.minus(from);
        double square = segment.dot(segment);
        double share = square == 0.0
                ? 0.0
                : Math.max(0.0, Math.min(1.0, point.minus(from).dot(segment) / square));
        return point.distance(from.plus(segment.times(share)));
    }

    private void append(List<Waypoint> all, boolean[] kept, int first, int last) {
        if (all.isEmpty()) {
            all.add(new Waypoint(places[first], 0.0, 0.0));
        }
        double fastest = 0.0;
        for (int i = first + 1; i <= last; i++) {
            fastest = Math.max(fastest, places[i].distance(places[i - 1]) / step);
            if (kept[i]) {
                all.add(new Waypoint(places[i], fastest, 0.0));
                fastest = 0.0;
            }
        }
    }
}
