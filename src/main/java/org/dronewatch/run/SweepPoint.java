package org.dronewatch.run;

import java.util.OptionalDouble;

/**
 * One point of a sweep.
 *
 * @param parameter path of the setting that changes
 * @param value value of the setting in this run: a number in the setting's unit, or a text
 * @param sensor name of a sensor
 * @param range the greatest distance, over all drones, at which the sensor first detected one, m; empty if it detected
 *     none
 */
public record SweepPoint(String parameter, Object value, String sensor, OptionalDouble range) {}
