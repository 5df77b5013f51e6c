package org.dronewatch.positioner;

import java.util.Optional;
import org.dronewatch.geometry.Position;

/**
 * What a positioner knows of the contact that it follows. Positions are smoothed and predicted by an alpha-beta filter:
 * the position is corrected by {@code alpha} times the difference between a sighting and its prediction, the velocity
 * by {@code beta} times that difference over the time between, with {@code beta = alpha^2 / (2 - alpha)} (Benedict and
 * Bordner 1962). Directions without a range are taken as they are.
 */
final class Track {
    private static final double ALPHA = 0.5;
    private static final double BETA = ALPHA * ALPHA / (2.0 - ALPHA);
    private static final Position REST = new Position(0, 0, 0);

    private final int contact;
    private Optional<Position> place = Optional.empty();
    private Position velocity = REST;
    private double placed;
    private Direction direction;
    private double told;

    Track(int contact, Sighting sighting, double time, double told) {
        this.contact = contact;
        add(sighting, time, told);
    }

    int contact() {
        return contact;
    }

    /** When the positioner last received a sighting of it, s. */
    double told() {
        return told;
    }

    /**
     * Takes a sighting.
     *
     * @param time when it was, s
     * @param now when the positioner received it, s
     */
    void add(Sighting sighting, double time, double now) {
        told = now;
        direction = sighting.direction();
        sighting.place().ifPresent(found -> add(found, time));
    }

    private void add(Position found, double time) {
        double since = time - placed;
        if (place.isPresent() && since > 0.0) {
            Position expected = place.get().plus(velocity.times(since));
            Position difference = found.minus(expected);
            place = Optional.of(expected.plus(difference.times(ALPHA)));
            velocity = velocity.plus(difference.times(BETA / since));
        } else {
            place = Optional.of(found);
        }
        placed = time;
    }

    /**
     * Where to look from a place at a time.
     *
     * @param patience how old the last position may be, s: after that the last direction is better
     */
    Direction from(Position mount, double time, double patience) {
        return place.filter(last -> time - placed <= patience)
                .map(last -> last.plus(velocity.times(time - placed)).minus(mount))
                .filter(way -> way.length() > 0.0)
                .map(Direction::of)
                .orElse(direction);
    }
}
