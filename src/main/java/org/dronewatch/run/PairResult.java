package org.dronewatch.run;

import java.util.OptionalDouble;

/**
 * What became of one drone before one sensor in one run.
 *
 * @param run number of the run in a sweep, from 0
 * @param sensor name of the sensor
 * @param kind its kind
 * @param drone name of the drone
 * @param firstDetected when it was first detected, s; empty for never
 * @param range how far it was then, m
 * @param maxRange the farthest at which it was ever detected, m
 */
public record PairResult(
        int run,
        String sensor,
        String kind,
        String drone,
        OptionalDouble firstDetected,
        OptionalDouble range,
        OptionalDouble maxRange) {}
