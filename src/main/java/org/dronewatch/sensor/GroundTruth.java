package org.dronewatch.sensor;

/**
 * The drone that an observation came from: for scoring, and never read by what judges measurements.
 *
 * @param drone name of the drone; empty for a false measurement
 * @param range distance from the sensor to the drone's origin at {@code time}, m; not a number for a false measurement
 * @param time when what was measured left the drone, seconds since the start of the run: earlier than the look for sound
 */
public record GroundTruth(String drone, double range, double time) {
    private static final String NO_DRONE = "";

    /** Of what a sensor reports although there is no drone. */
    static GroundTruth ofNothing(double time) {
        return new GroundTruth(NO_DRONE, Double.NaN, time);
    }

    /** Whether there is no drone behind it. */
    boolean isNothing() {
        return drone.equals(NO_DRONE);
    }
}
