package org.dronewatch.positioner;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * Where a sensor believes a drone to be, errors and all: what another sensor can be pointed by.
 *
 * @param from where the sensor is, m
 * @param direction from there to the drone
 * @param range how far away, m; empty for a sensor that tells directions only
 */
public record Sighting(Position from, Direction direction, OptionalDouble range) {

    /** The place; empty when only its direction is known. */
    public Optional<Position> place() {
        return range.isPresent()
                ? Optional.of(from.plus(direction.unit().times(range.getAsDouble())))
                : Optional.empty();
    }
}
