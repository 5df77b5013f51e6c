package org.dronewatch.sensor.positioner;

import java.util.Optional;

/**
 * Where a mount that turns points at one moment.
 *
 * @param direction of the sensor's axis
 * @param fov the sensor's field of view now, rad
 * @param target name of the drone that it follows, or empty while it searches
 */
public record Pointing(Direction direction, double fov, Optional<String> target) {}
