package org.dronewatch.positioner;

import java.util.Optional;
import org.dronewatch.geometry.Position;

/**
 * What a positioner knows of the contact that it follows. Positions are smoothed and predicted by an alpha-beta filter:
 * the position is corrected by {@code alpha} times the difference between a sighting and its prediction, the velocity
 * by {@code beta} times that difference over the time between, with {@code beta = alpha^2 / (2 - alpha)} (Benedict and
 * Bordner 1962). Directions without a range are taken as they are. A sighting without a measured elevation keeps the
 * height that other sightings gave.
 */
final class FollowedContact {
    private static final double ALPHA = 0.5;
    private static final double BETA = ALPHA * ALPHA / (2.0 - ALPHA);
    private static final Position REST = new Position(0, 0, 0);

    private final int contact;
    private Optional<Position> position = Optional.empty();
    private Position velocity = REST;
    private boolean hasHeight;
    private double positionTime;
    private Direction direction;
    private double received;

    FollowedContact(int contact, Sighting sighting, double time, double received) {
        this.contact = contact;
        add(sighting, time, received);
    }

    int contact() {
        return contact;
    }

    /** When the positioner last received a sighting of it, s. */
    double received() {
        return received;
    }

    /**
     * Takes a sighting.
     *
     * @param time when it was, s
     * @param now when the positioner received it, s
     */
    void add(Sighting sighting, double time, double now) {
        received = now;
        Sighting placed = hasHeight && !sighting.hasElevation() && position.isPresent()
                ? sighting.atHeightOf(position.get().plus(velocity.times(time - positionTime)))
                : sighting;
        hasHeight |= sighting.hasElevation() && sighting.range().isPresent();
        direction = placed.direction();
        placed.position().ifPresent(found -> add(found, time));
    }

    private void add(Position found, double time) {
        double since = time - positionTime;
        if (position.isPresent() && since > 0.0) {
            Position expected = position.get().plus(velocity.times(since));
            Position difference = found.minus(expected);
            position = Optional.of(expected.plus(difference.times(ALPHA)));
            velocity = velocity.plus(difference.times(BETA / since));
        } else {
            position = Optional.of(found);
        }
        positionTime = time;
    }

    /**
     * The direction in which to look at a time.
     *
     * @param patience how old the last position may be, s: after that the last direction is better
     */
    Direction from(Position from, double time, double patience) {
        return position.filter(last -> time - positionTime <= patience)
                .map(last -> last.plus(velocity.times(time - positionTime)).minus(from))
                .filter(offset -> offset.length() > 0.0)
                .map(Direction::of)
                .orElse(direction);
    }
}
