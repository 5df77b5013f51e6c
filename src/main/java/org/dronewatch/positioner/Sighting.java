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
 */
public record Sighting(Position from, Direction direction, OptionalDouble range) {

    /** The estimated position; empty when only its direction is known. */
    public Optional<Position> position() {
        return range.isPresent()
                ? Optional.of(from.plus(direction.unit().times(range.getAsDouble())))
                : Optional.empty();
    }
}
