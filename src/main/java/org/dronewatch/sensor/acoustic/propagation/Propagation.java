package org.dronewatch.sensor.acoustic.propagation;

/** How sound is followed from a drone to a sensor. */
public sealed interface Propagation permits LevelModel, EnergyModel {}
