package org.dronewatch.sensor;

/**
 * The drone that caused an observation: for scoring, and for the perfect association in place of a tracker. No sensor,
 * positioner or alert rule reads it.
 *
 * @param drone name of the drone; empty for a false measurement
 * @param range distance from the sensor to the drone's origin at {@code time}, m; NaN for a false measurement
 * @param time when the measured signal left the drone, seconds since the start of the run: for sound, earlier than the
 *     look
 */
public record GroundTruth(String drone, double range, double time) {
    private static final String NO_DRONE = "";

    /** The ground truth of a false alarm: no drone. */
    static GroundTruth ofNothing(double time) {
        return new GroundTruth(NO_DRONE, Double.NaN, time);
    }

    /** Whether the measurement is a false alarm, which no drone caused. */
    boolean isNothing() {
        return drone.equals(NO_DRONE);
    }
}
