package org.dronewatch.sensor;

/**
 * The identity of the look in which something was observed.
 *
 * @param sensor name of the sensor in the scene
 * @param kind kind of the sensor, such as {@code camera}
 * @param index index of the look, from 0
 * @param time when the signal reached the sensor, seconds since the start of the run
 */
public record LookId(String sensor, String kind, long index, double time) {}
