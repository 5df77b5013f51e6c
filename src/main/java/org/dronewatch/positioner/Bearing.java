package org.dronewatch.positioner;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * The direction in which one sensor sees a contact, smoothed and predicted by an {@link AlphaBeta} filter of its unit
 * vector. A prediction reaches at most a second beyond the last sighting, since the error of a rate grows with time.
 */
final class Bearing {
    /** The greatest time by which a direction is extrapolated, s. */
    static final double LEAD = 1.0;

    /** Vectors shorter than this have no direction: the last sighting was opposite to the one before. */
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
     * @param patience longest time without a sighting after which the direction is still continued, s; after a longer
     *     time, it starts afresh
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

    /** The position of the sensor, m. */
    Position from() {
        return from;
    }

    /** The time at which the sensor last saw the contact, s. */
    double time() {
        return filter.time();
    }

    /** Whether the sensor measures a direction, with azimuth and elevation, but no range. */
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
