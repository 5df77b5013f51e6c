package org.dronewatch.sensor;

/**
 * Settings of a sensor that measures the direction of what it detects, and states it in its observations: only such a
 * sensor can cue others. A capability: {@link SensorSettings#as}.
 */
public interface DirectionFinding {}
