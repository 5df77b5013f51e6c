package org.dronewatch.sensor;

/**
 * Settings of a sensor that measures the direction of each drone that it detects, and reports the direction with its
 * observations: only such a sensor can cue others. This is a capability, queried by {@link SensorSettings#as}.
 */
public interface DirectionFinding {}
