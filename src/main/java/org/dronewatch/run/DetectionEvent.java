package org.dronewatch.run;

import org.dronewatch.sensor.Observation;

/**
 * A sensor gains or loses detection of a drone.
 *
 * @param run number of the run in a sweep, from 0
 * @param gained true if the drone is detected from now on, false if it no longer is
 * @param observation the observation at which this changed
 */
public record DetectionEvent(int run, boolean gained, Observation observation) {}
