package org.dronewatch.positioner;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * A sensor's estimate of the position or direction of a drone, with its errors, by which a positioner can be cued.
 *
 * @param from the position of the sensor, m
 * @param direction direction from the sensor to the drone
 * @param range distance from the sensor to the drone, m; empty for a sensor that measures directions only
 * @param hasElevation whether the elevation of the direction was measured; otherwise, as for a radar with a fan beam,
 *     it is only the middle of the field of view
 * @param error standard error of the direction, or, for an image, the angle that one of its pixels subtends, rad; 0
 *     where it is not stated
 * @param size the angle subtended by the square root of the drone's area in an image, at least that of a pixel, rad;
 *     empty for a sensor without an image
 */
public record Sighting(
        Position from,
        Direction direction,
        OptionalDouble range,
        boolean hasElevation,
        double error,
        OptionalDouble size) {

    /** A sighting whose error and size are not stated. */
    public Sighting(Position from, Direction direction, OptionalDouble range, boolean hasElevation) {
        this(from, direction, range, hasElevation, 0.0, OptionalDouble.empty());
    }

    /** A sighting with a measured elevation, whose error and size are not stated. */
    public Sighting(Position from, Direction direction, OptionalDouble range) {
        this(from, direction, range, true);
    }

    /**
     * This sighting, with the elevation at which a position is seen from the sensor instead of an elevation that was
     * not measured.
     */
    Sighting atHeightOf(Position place) {
        double elevation = Direction.of(place.minus(from)).elevation();
        return new Sighting(from, new Direction(direction.azimuth(), elevation), range, hasElevation, error, size);
    }

    /**
     * The estimated position, with an assumed height if the elevation was not measured; empty when only the direction
     * is known.
     */
    public Optional<Position> position() {
        return range.isPresent()
                ? Optional.of(from.plus(direction.unit().times(range.getAsDouble())))
                : Optional.empty();
    }
}
