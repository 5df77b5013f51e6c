package org.dronewatch.positioner;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * The direction in which one sensor sees a contact, smoothed and predicted by an {@link AlphaBeta} filter of its unit
 * vector. A prediction goes a second at most beyond the last sighting: the error of a rate grows with time.
 */
final class Bearing {
    /** How long a direction is extrapolated, s. */
    static final double LEAD = 1.0;

    /** Shorter vectors have no direction: the last sighting was opposite to the one before. */
    private static final double SHORTEST = 1e-6;

    private final Position from;
    private AlphaBeta filter;
    private Sighting last;

    Bearing(Sighting first, double time) {
        this.from = first.from();
        this.filter = new AlphaBeta(first.direction().unit(), time);
        this.last = first;
    }

    /**
     * Takes a sighting by the same sensor.
     *
     * @param patience after a longer silence, s, the direction starts afresh
     */
    void add(Sighting sighting, double time, double patience) {
        if (time - filter.time() > patience) {
            filter = new AlphaBeta(sighting.direction().unit(), time);
        } else {
            filter.add(sighting.direction().unit(), time);
        }
        last = sighting;
    }

    /** The unit vector at a time, s. */
    Position at(double time) {
        Position vector = filter.at(Math.min(time, filter.time() + LEAD));
        return vector.length() > SHORTEST ? vector.unit() : last.direction().unit();
    }

    /** Where the sensor is, m. */
    Position from() {
        return from;
    }

    /** When it last saw the contact, s. */
    double time() {
        return filter.time();
    }

    /** Whether it measures a direction, azimuth and elevation, but no range. */
    boolean isDirectionOnly() {
        return last.range().isEmpty() && last.hasElevation();
    }

    /** Error of the direction, rad. */
    double error() {
        return last.error();
    }

    /** The angle that the contact subtends, rad. */
    OptionalDouble size() {
        return last.size();
    }
}
