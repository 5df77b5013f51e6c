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
 * @param isEstimated whether the probability is estimated from random rays: even at 0, the look may detect the drone
 * @param counts whether the drone is on the route; before, it waits where the route begins
 */
record ScheduledLook(int number, Look look, Drone drone, double probability, boolean isEstimated, boolean counts) {
    /** Whether the look may detect the drone at all. */
    boolean mayDetect() {
        return probability > 0.0 || isEstimated;
    }

    double time() {
        return look.time();
    }
}
