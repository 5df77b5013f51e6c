package org.dronewatch.positioner;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * A positioner's knowledge of the contact that it follows. Positions that sensors measured are smoothed and predicted
 * by an {@link AlphaBeta} filter. If there are only directions, two of them from different positions give the contact's
 * positions, which go through a separate filter; one direction alone gives a line. A sighting without a measured
 * elevation keeps the height that other sightings gave.
 */
final class FollowedContact {
    /** A crossing whose error, as a fraction of the range, is smaller than this gives a position. */
    private static final double ACCURATE = 0.1;

    /** A range is taken to lie within this number of standard errors to either side. */
    private static final double DEVIATIONS = 2.0;

    /** Crossings that follow each other faster than this, s, would turn their errors into velocities. */
    private static final double SPACING = 0.2;

    private final int contact;
    private final double patience;
    private final RangeSearch search;
    private final Map<Position, Bearing> bearings = new LinkedHashMap<>();
    private Bearing latest;
    private Optional<AlphaBeta> measured = Optional.empty();
    private Optional<AlphaBeta> crossed = Optional.empty();
    private Optional<Crossing> crossing = Optional.empty();
    private boolean hasHeight;
    private double received;

    /** A contact after its first sighting; its positions are predicted for as long as the positioner waits for it. */
    FollowedContact(int contact, Sighting sighting, double time, double received, PositionerSettings settings) {
        this.contact = contact;
        this.patience = settings.hold() + settings.delay();
        this.search = settings.rangeSearch();
        add(sighting, time, received);
    }

    int contact() {
        return contact;
    }

    /** The time at which the positioner last received a sighting of the contact, s. */
    double received() {
        return received;
    }

    /**
     * Takes a sighting.
     *
     * @param time time of the sighting, s
     * @param now time at which the positioner received it, s
     */
    void add(Sighting sighting, double time, double now) {
        received = now;
        Sighting placed = hasHeight && !sighting.hasElevation() && measured.isPresent()
                ? sighting.atHeightOf(measured.get().at(time))
                : sighting;
        hasHeight |= sighting.hasElevation() && sighting.range().isPresent();
        Bearing bearing = bearings.get(placed.from());
        if (bearing == null) {
            bearing = new Bearing(placed, time);
            bearings.put(placed.from(), bearing);
        } else {
            bearing.add(placed, time, patience);
        }
        latest = bearing;
        if (placed.range().isPresent()) {
            crossing = Optional.empty();
            measured = Optional.of(filtered(measured, placed.position().orElseThrow(), time));
        } else {
            cross(bearing, time);
        }
    }

    private static AlphaBeta filtered(Optional<AlphaBeta> filter, Position position, double time) {
        AlphaBeta result = filter.orElseGet(() -> new AlphaBeta(position, time));
        result.add(position, time);
        return result;
    }

    /** Finds the points at which the new direction passes the recent directions from other positions. */
    private void cross(Bearing bearing, double time) {
        crossing = bearings.values().stream()
                .filter(other -> other != bearing && bearing.isDirectionOnly() && other.isDirectionOnly())
                .filter(other -> Math.abs(time - other.time()) <= Bearing.LEAD)
                .flatMap(other -> Crossing.of(bearing, other, time).stream())
                .reduce((one, other) -> other.error() < one.error() ? other : one);
        crossing.filter(found -> found.error() <= ACCURATE * found.range())
                .filter(found -> crossed.isEmpty() || time - crossed.get().time() >= SPACING)
                .ifPresent(found -> {
                    Position place = bearing.from().plus(bearing.at(time).times(found.range()));
                    boolean isFresh =
                            crossed.isPresent() && time - crossed.get().time() <= patience;
                    crossed = Optional.of(filtered(isFresh ? crossed : Optional.empty(), place, time));
                });
    }

    /**
     * The predicted position at a time, s; empty if no sensor has recently measured a position, and no two directions
     * have given one.
     */
    Optional<Position> position(double time) {
        return recent(measured, time).or(() -> recent(crossed, time)).map(filter -> filter.at(time));
    }

    private Optional<AlphaBeta> recent(Optional<AlphaBeta> filter, double time) {
        return filter.filter(known -> time - known.time() <= patience);
    }

    /** The line on which the contact is at a time, s, as seen by the sensor that saw it last. */
    BearingLine line(double time) {
        OptionalDouble size = latest.size();
        double near = 0.0;
        double far = Double.POSITIVE_INFINITY;
        if (crossing.isPresent() && time - latest.time() <= Bearing.LEAD) {
            near = crossing.get().range() - DEVIATIONS * crossing.get().error();
            far = crossing.get().range() + DEVIATIONS * crossing.get().error();
        } else if (size.isPresent()) {
            near = search.nearest(size.getAsDouble(), latest.error());
            far = search.farthest(size.getAsDouble(), latest.error());
        }
        return new BearingLine(latest.from(), latest.at(time), latest.error(), near, far);
    }
}
