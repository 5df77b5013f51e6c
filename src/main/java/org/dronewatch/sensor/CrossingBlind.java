package org.dronewatch.sensor;

/**
 * Settings of a sensor that rejects what neither approaches nor recedes, and so may miss a drone that flies across its
 * line of sight. A capability: {@link SensorSettings#as}.
 */
public interface CrossingBlind {}
