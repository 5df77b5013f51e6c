package org.dronewatch.run;

import java.util.OptionalDouble;

/**
 * The result for one sensor and one drone in one run.
 *
 * @param run number of the run in a sweep, from 0
 * @param sensor name of the sensor
 * @param kind its kind
 * @param drone name of the drone
 * @param firstDetected when it was first detected, s; empty if never
 * @param range distance of the drone from the sensor at that time, m
 * @param isUnknown whether the line of sight to it left the known ground at that time, so that something may have
 *     hidden it
 * @param maxRange the largest distance at which it was detected, m
 */
public record PairResult(
        int run,
        String sensor,
        String kind,
        String drone,
        OptionalDouble firstDetected,
        OptionalDouble range,
        boolean isUnknown,
        OptionalDouble maxRange) {}
