package org.dronewatch.run;

import java.util.OptionalDouble;

/**
 * The result for one sensor and one drone in one run.
 *
 * @param run number of the run in a sweep, from 0
 * @param sensor name of the sensor
 * @param kind kind of the sensor
 * @param drone name of the drone
 * @param firstDetected time at which the sensor first detected the drone, s; empty if never
 * @param range distance of the drone from the sensor at that time, m; empty if never detected
 * @param isUnknown whether the line of sight left the known ground at that time, so that something may have hidden the
 *     drone
 * @param maxRange the largest distance at which the drone was detected, m; empty if never
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
