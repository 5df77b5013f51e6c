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
 * @param error standard error of the direction, or, for an image, the angle of one of its pixels, rad; 0 where it is
 *     not stated
 * @param size the angle subtended by the root of the area that an image shows of the drone, at least that of a pixel,
 *     rad; empty for a sensor without an image
 */
public record Sighting(
        Position from,
        Direction direction,
        OptionalDouble range,
        boolean hasElevation,
        double error,
        OptionalDouble size) {

    /** A sighting of an unstated error and size. */
    public Sighting(Position from, Direction direction, OptionalDouble range, boolean hasElevation) {
        this(from, direction, range, hasElevation, 0.0, OptionalDouble.empty());
    }

    /** A sighting with a measured elevation, of an unstated error and size. */
    public Sighting(Position from, Direction direction, OptionalDouble range) {
        this(from, direction, range, true);
    }

    /**
     * This sighting with the elevation at which a place is seen from the sensor, in place of one that was not measured.
     */
    Sighting atHeightOf(Position place) {
        double elevation = Direction.of(place.minus(from)).elevation();
        return new Sighting(from, new Direction(direction.azimuth(), elevation), range, hasElevation, error, size);
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
