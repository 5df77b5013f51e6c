package org.dronewatch.geo.features;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geo.EarthPoint;

/**
 * A named feature of a map.
 *
 * @param where its location in the file, a line or a number, for messages
 * @param shape its type, such as {@code Point} or {@code Polygon}
 * @param point its coordinates; empty unless it is a point
 * @param above its height above the ground, if the file states that, m
 * @param height its height above sea level, if the file states that, m
 * @param unclear a height in the file whose datum is not stated, m
 */
public record Feature(
        String where,
        String shape,
        Optional<EarthPoint> point,
        OptionalDouble above,
        OptionalDouble height,
        OptionalDouble unclear) {}
