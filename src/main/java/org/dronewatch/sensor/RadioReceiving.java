package org.dronewatch.sensor;

/**
 * Settings of a sensor that detects nothing but what a drone, or its pilot, transmits by radio: it never detects a
 * drone that flies autonomously or is controlled through an optical fibre. This is a capability, queried by
 * {@link SensorSettings#as}.
 */
public interface RadioReceiving {}
