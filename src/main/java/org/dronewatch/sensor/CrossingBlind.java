package org.dronewatch.sensor;

/**
 * Settings of a sensor that rejects objects that neither approach nor recede, and so may miss a drone that flies across
 * its line of sight. This is a capability, queried by {@link SensorSettings#as}.
 */
public interface CrossingBlind {
    /**
     * The fraction of a drone's signal that remains after rejection by radial speed, 0 to 1. All else being equal, the
     * greater this fraction, the more likely a drone is to be detected.
     *
     * @param radialSpeed the rate at which the drone's distance changes, positive or negative, m/s
     */
    double response(double radialSpeed);
}
