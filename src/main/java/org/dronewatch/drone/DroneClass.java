package org.dronewatch.drone;

/**
 * A class of drones with a measured distribution of the radar cross-section, which is log-normal and fluctuates from
 * look to look. The figures are those of 3GPP TR 38.901 version 19, section 7.9.2.1. The mean is taken over the
 * cross-section in m2, not over its value in decibels.
 */
public enum DroneClass {
    /** A small unmanned aircraft, such as the quadrotor of the library: 0.0524 m2 (-12.81 dBsm), spread 3.74 dB. */
    SMALL_UAV(-12.81, 3.74),
    /** A large unmanned aircraft: 0.260 m2 (-5.85 dBsm), spread 2.5 dB; its aspect dependence is left out. */
    LARGE_UAV(-5.85, 2.5);

    private final double crossSection;
    private final double spread;

    DroneClass(double decibels, double spread) {
        this.crossSection = Math.pow(10.0, 0.1 * decibels);
        this.spread = spread;
    }

    /** Mean radar cross-section, m2. */
    public double crossSection() {
        return crossSection;
    }

    /** Standard deviation of the cross-section expressed in decibels, dB. */
    public double spread() {
        return spread;
    }
}
