package org.dronewatch.geo.features;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geo.EarthPoint;

/**
 * A named feature of a map.
 *
 * @param where location of the feature in the file, a line or a number, for messages
 * @param shape type of the feature's geometry, such as {@code Point} or {@code Polygon}
 * @param point coordinates of the feature; empty unless it is a point
 * @param above height of the feature above the ground, if the file states that, m
 * @param height height of the feature above sea level, if the file states that, m
 * @param unclear a height in the file whose datum is not stated, m
 */
public record Feature(
        String where,
        String shape,
        Optional<EarthPoint> point,
        OptionalDouble above,
        OptionalDouble height,
        OptionalDouble unclear) {}
