package org.dronewatch.fusion;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A protected zone: a sphere that drones must not reach.
 *
 * @param centre its centre, m
 * @param radius its radius, above 0 and at most 100,000 m
 */
public record ProtectedZone(Position centre, @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) double radius) {
    /** Checks the limits. */
    public ProtectedZone {
        Limits.check(ProtectedZone.class, centre, radius);
    }

    /** A sphere of radius 10 m. */
    @Defaults("centre")
    public static ProtectedZone at(Position centre) {
        return new ProtectedZone(centre, 10.0);
    }

    /** The distance from a point to the zone's surface, m; 0 inside. */
    public double distance(Position position) {
        return Math.max(0.0, position.distance(centre) - radius);
    }

    /**
     * The position along a straight segment at which the zone's surface is first reached.
     *
     * @param from start of the segment, m
     * @param to end of the segment, m
     * @return fraction of the segment before that position, 0 when the segment begins inside; empty when it stays
     *     outside
     */
    public OptionalDouble entry(Position from, Position to) {
        if (distance(from) == 0.0) {
            return OptionalDouble.of(0.0);
        }
        Position segment = to.minus(from);
        Position toCentre = centre.minus(from);
        double a = segment.dot(segment);
        double b = segment.dot(toCentre);
        double left = b * b - a * (toCentre.dot(toCentre) - radius * radius);
        if (!(a > 0.0 && left >= 0.0)) {
            return OptionalDouble.empty();
        }
        double share = (b - Math.sqrt(left)) / a;
        return share >= 0.0 && share <= 1.0 ? OptionalDouble.of(share) : OptionalDouble.empty();
    }

    /**
     * The flight time in a straight line from a position to the zone's surface, s; 0 inside. For 1 km at 20 m/s, it is
     * 50 s.
     *
     * @param position start of the flight, m
     * @param speed speed of the drone, above 0, m/s
     */
    public double timeLeft(Position position, double speed) {
        return distance(position) / speed;
    }
}
