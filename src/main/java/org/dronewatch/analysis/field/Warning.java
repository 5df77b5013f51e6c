package org.dronewatch.analysis.field;

import java.util.OptionalDouble;

/**
 * How early a drone that flies in straight, from one bearing and at one height, is first detected.
 *
 * @param bearing from which it comes, clockwise from north, rad
 * @param height above the ground, m
 * @param arrival its horizontal distance from where it flies to when it reaches the protected zone, m; 0 without a zone
 * @param range the same distance when it is first detected, m; empty if it is not detected before it arrives
 * @param time from then until it arrives, s; empty likewise
 */
public record Warning(double bearing, double height, double arrival, OptionalDouble range, OptionalDouble time) {

    /** Whether it is detected at least a time, s, before it arrives. */
    public boolean isInTime(double response) {
        return time.isPresent() && time.getAsDouble() >= response;
    }
}
