package org.dronewatch.sensor.radar;

import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.Outline;

/** The limits of position and radial speed within which a radar looks for a drone. */
final class FieldOfRegard {
    private final RadarSettings settings;
    private final Outline.Sector outline;
    private final double slowest;
    private final double fastest;

    FieldOfRegard(RadarSettings settings) {
        this.settings = settings;
        this.outline = settings.outline();
        this.slowest = settings.slowest();
        this.fastest = settings.fastest();
    }

    /** Whether a drone is within the limits of angle and range. */
    boolean contains(Position vector) {
        return outline.contains(vector);
    }

    /** Radial speed of a drone, m/s: negative if it approaches. */
    double radialSpeed(Drone drone) {
        Position vector = drone.origin().minus(settings.position());
        return vector.dot(Position.of(drone.velocity())) / Math.max(vector.length(), Double.MIN_NORMAL);
    }

    /** Why the radar does not look for a drone; empty when it does. */
    Optional<Explanation> miss(Drone drone) {
        Position vector = drone.origin().minus(settings.position());
        if (!outline.reaches(vector)) {
            return Optional.of(outline.beyond(vector));
        }
        if (!outline.contains(vector)) {
            return Optional.of(Explanation.of(Cause.OUT_OF_VIEW));
        }
        double radial = radialSpeed(drone);
        if (hasSpeed(radial)) {
            return Optional.empty();
        }
        boolean slow = Math.abs(radial) < slowest;
        return Optional.of(
                slow ? Explanation.beyond(Cause.TOO_SLOW, slowest) : Explanation.beyond(Cause.TOO_FAST, fastest));
    }

    /**
     * Whether a drone approaches or recedes fast enough to be separated from the ground, but not too fast; with a
     * notch, no drone is too slow here, since the notch rejects slow drones itself.
     */
    boolean hasSpeed(double radial) {
        return Math.abs(radial) >= slowest && Math.abs(radial) <= fastest;
    }
}
