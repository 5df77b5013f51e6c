package org.dronewatch.analysis.field;

import java.util.OptionalDouble;

/**
 * How early a drone that flies straight in, from one bearing and at one height, is first detected.
 *
 * @param bearing bearing from which the drone comes, clockwise from north, rad
 * @param height height above the ground, m
 * @param arrival horizontal distance from the target at which the drone reaches the protected zone, m; 0 without a zone
 * @param range horizontal distance from the target at which the drone is first detected, m; empty if it is not detected
 *     before it arrives
 * @param time warning time, from the first detection of the drone to its arrival, s; empty if it is not detected before
 *     it arrives
 * @param isFromStart whether the drone is detected where its flight begins, or at the first position that the model of
 *     the site covers, so that the time is a lower bound: a flight that begins farther away may be detected earlier
 */
public record Warning(
        double bearing, double height, double arrival, OptionalDouble range, OptionalDouble time, boolean isFromStart) {

    /** Whether the drone is detected early enough: at least the given response time, s, before it arrives. */
    public boolean isInTime(double response) {
        return time.isPresent() && time.getAsDouble() >= response;
    }

    /**
     * Whether the flight begins too near to show whether the drone would be detected early enough for the given
     * response time, s.
     */
    public boolean isUndecided(double response) {
        return isFromStart && !isInTime(response);
    }

    /** Whether the drone is certainly not detected early enough for the given response time, s. */
    public boolean isLate(double response) {
        return !isFromStart && !isInTime(response);
    }
}
