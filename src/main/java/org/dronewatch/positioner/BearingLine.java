package org.dronewatch.positioner;

import org.dronewatch.geometry.Position;

/**
 * Where a contact may be if only its direction is known: on a line from a sensor, between two ranges.
 *
 * @param from where the sensor is, m
 * @param unit vector to the contact
 * @param error of the direction, rad
 * @param near range from which it may be, m
 * @param far range up to which it may be, m; may be infinite
 */
record BearingLine(Position from, Position unit, double error, double near, double far) {}
