package org.dronewatch.fusion;

import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * What must not be reached: a ball.
 *
 * @param centre its middle, m
 * @param radius 0 or more, m
 */
public record ProtectedZone(Position centre, @In(value = Quantity.LENGTH, from = 0) double radius) {
    /** Checks the limits. */
    public ProtectedZone {
        Limits.check(ProtectedZone.class, centre, radius);
    }

    /** A point. */
    @Defaults("centre")
    public static ProtectedZone at(Position centre) {
        return new ProtectedZone(centre, 0.0);
    }

    /** How far a place is from its edge, 0 inside, m. */
    public double distance(Position place) {
        return Math.max(0.0, place.distance(centre) - radius);
    }

    /** How long something needs to its edge on the straight way, s: 1 km at 20 m/s is 50 s. */
    public double timeLeft(Position place, double speed) {
        return distance(place) / speed;
    }
}
