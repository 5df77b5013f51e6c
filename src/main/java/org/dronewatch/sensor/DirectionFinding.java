package org.dronewatch.sensor;

/**
 * Settings of a sensor that measures the direction of what it detects, and reports it with its observations: only such
 * a sensor can cue others. This is a capability, queried by {@link SensorSettings#as}.
 */
public interface DirectionFinding {}
