package org.dronewatch.route.proof;

import org.dronewatch.drone.Drone;
import org.dronewatch.sensor.Look;

/**
 * A look that a run takes at a drone, before any random decision.
 *
 * @param number of the sensor in the order of the scene
 * @param look with the time and the pointing, and with any seed
 * @param drone as it appears to the sensor
 * @param probability that the look detects it or, where chance is drawn once per encounter, that an observer can
 */
record ScheduledLook(int number, Look look, Drone drone, double probability) {
    double time() {
        return look.time();
    }
}
