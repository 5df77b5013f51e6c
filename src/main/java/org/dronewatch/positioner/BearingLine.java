package org.dronewatch.positioner;

import org.dronewatch.geometry.Position;

/**
 * The line on which a contact may be if only its direction is known: from a sensor, between two ranges.
 *
 * @param from position of the sensor, m
 * @param unit unit vector from the sensor to the contact
 * @param error error of the direction, rad
 * @param near least range at which the contact may be, m
 * @param far greatest range at which the contact may be, m; may be infinite
 */
record BearingLine(Position from, Position unit, double error, double near, double far) {}
