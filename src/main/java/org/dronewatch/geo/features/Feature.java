package org.dronewatch.geo.features;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geo.EarthPoint;

/**
 * What a map calls by a name.
 *
 * @param where its line or number in the file, for messages
 * @param shape what it is, such as {@code Point} or {@code Polygon}
 * @param point where it is; empty unless it is a point
 * @param above its height above the ground, if the file states that, m
 * @param height its height above sea level, if the file states that, m
 * @param unclear a height in the file that may count from anything, m
 */
public record Feature(
        String where,
        String shape,
        Optional<EarthPoint> point,
        OptionalDouble above,
        OptionalDouble height,
        OptionalDouble unclear) {}
