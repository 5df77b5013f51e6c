package org.dronewatch.route.search;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.flight.RouteLeg;
import org.dronewatch.geometry.Position;

/**
 * A path of straight legs.
 *
 * @param points points from the first to the last, at least one, m
 * @param modes for each leg, the number of the mode in which it is flown
 */
public record RoutePath(List<Position> points, List<Integer> modes) {
    /** Decimal places of the coordinates of a flight in m: as many as in {@code route.json}. */
    private static final int LENGTH_DECIMALS = 6;

    /** Decimal places of the speeds of a flight in m/s: the duration of an hour's leg is exact to a microsecond. */
    private static final int SPEED_DECIMALS = 9;

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
                    points.size() + " points with " + modes.size() + " modes: there must be one mode for each leg");
        }
    }

    /** The length of the path, m. */
    public double length() {
        double length = 0.0;
        for (int i = 0; i < modes.size(); i++) {
            length += points.get(i).distance(points.get(i + 1));
        }
        return length;
    }

    /**
     * The flight along this path, each leg in the time that the search assumes. Coordinates are rounded to a
     * micrometre, speeds to a nanometre per second, so that scene files state them without the rounding errors of the
     * search.
     *
     * @param of the modes of the search, in the order of their numbers
     * @return the flight; empty for a path that is shorter than the shortest possible leg
     */
    public Optional<RouteFlight> flight(List<RouteMode> of) {
        List<RouteLeg> legs = new ArrayList<>();
        Position first = rounded(points.get(0));
        Position at = first;
        for (int i = 0; i < modes.size(); i++) {
            Position to = rounded(points.get(i + 1));
            double length = at.distance(to);
            if (length >= FlightPathSettings.SHORTEST) {
                RouteMode mode = of.get(modes.get(i));
                double speed = mode.greatestSpeed(Math.hypot(to.x() - at.x(), to.y() - at.y()), to.z() - at.z());
                legs.add(new RouteLeg(to, Optional.of(rounded(speed, SPEED_DECIMALS)), !mode.isGlide()));
                at = to;
            }
        }
        return legs.isEmpty() ? Optional.empty() : Optional.of(RouteFlight.of(first, legs));
    }

    private static Position rounded(Position at) {
        return new Position(
                rounded(at.x(), LENGTH_DECIMALS), rounded(at.y(), LENGTH_DECIMALS), rounded(at.z(), LENGTH_DECIMALS));
    }

    private static double rounded(double value, int decimals) {
        return BigDecimal.valueOf(value)
                .setScale(decimals, RoundingMode.HALF_EVEN)
                .doubleValue();
    }

    /** This path, continued by another that begins where it ends. */
    RoutePath then(RoutePath other) {
        List<Position> all = new ArrayList<>(points);
        all.addAll(other.points.subList(1, other.points.size()));
        List<Integer> both = new ArrayList<>(modes);
        both.addAll(other.modes);
        return new RoutePath(all, both);
    }

    /** This path up to a fraction of a leg, without the leg if the fraction is 0. */
    RoutePath until(int leg, double share) {
        List<Position> some = new ArrayList<>(points.subList(0, leg + 1));
        if (share > 0.0) {
            Position from = points.get(leg);
            Position to = points.get(leg + 1);
            some.add(share < 1.0 ? from.plus(to.minus(from).times(share)) : to);
        }
        return new RoutePath(some, modes.subList(0, some.size() - 1));
    }

    /** The rest of this path after a first part of it. */
    RoutePath after(RoutePath part) {
        int legs = part.modes.size();
        Position end = part.points.get(legs);
        boolean isCorner = end.equals(points.get(legs));
        List<Position> some = new ArrayList<>(List.of(end));
        some.addAll(points.subList(isCorner ? legs + 1 : legs, points.size()));
        return new RoutePath(some, modes.subList(isCorner ? legs : legs - 1, modes.size()));
    }
}
