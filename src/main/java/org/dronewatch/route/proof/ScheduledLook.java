package org.dronewatch.route.proof;

import org.dronewatch.drone.Drone;
import org.dronewatch.sensor.Look;

/**
 * A look that a run takes at a drone, before any random decision.
 *
 * @param number number of the sensor in the order of the scene
 * @param look the look, with its time and pointing, and with any seed
 * @param drone the drone as it appears to the sensor
 * @param estimate the probability that the look detects the drone or, where chance is drawn once per encounter, that an
 *     observer can
 * @param counts whether the drone is on the route; before, it waits where the route begins
 */
record ScheduledLook(int number, Look look, Drone drone, RayEstimate estimate, boolean counts) {
    /** The probability that the look detects the drone, or that an observer can, 0 to 1. */
    double probability() {
        return estimate.probability();
    }

    /** Whether the look may detect the drone at all; with other rays it may, even if none has so far. */
    boolean mayDetect() {
        return probability() > 0.0 || estimate.isRandom();
    }

    double time() {
        return look.time();
    }

    /** This look with another estimate. */
    ScheduledLook with(RayEstimate other) {
        return new ScheduledLook(number, look, drone, other, counts);
    }
}
