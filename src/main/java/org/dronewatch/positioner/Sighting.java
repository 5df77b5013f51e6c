package org.dronewatch.positioner;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * A sensor's estimate of where a drone is, with its errors: what another sensor can be cued by.
 *
 * @param from where the sensor is, m
 * @param direction from there to the drone
 * @param range its distance, m; empty for a sensor that measures directions only
 * @param hasElevation whether the elevation of the direction was measured; otherwise, as for a radar with a fan beam,
 *     it is only the middle of where the sensor looks
 */
public record Sighting(Position from, Direction direction, OptionalDouble range, boolean hasElevation) {

    /** A sighting with a measured elevation. */
    public Sighting(Position from, Direction direction, OptionalDouble range) {
        this(from, direction, range, true);
    }

    /**
     * This sighting with the elevation at which a place is seen from the sensor, in place of one that was not measured.
     */
    Sighting atHeightOf(Position place) {
        double elevation = Direction.of(place.minus(from)).elevation();
        return new Sighting(from, new Direction(direction.azimuth(), elevation), range, hasElevation);
    }

    /**
     * The estimated position, whose height is assumed without a measured elevation; empty when only its direction is
     * known.
     */
    public Optional<Position> position() {
        return range.isPresent()
                ? Optional.of(from.plus(direction.unit().times(range.getAsDouble())))
                : Optional.empty();
    }
}
