package org.dronewatch.route.exposure;

/**
 * How a drone moves on a straight leg.
 *
 * @param heading heading, clockwise from north, rad; meaningless on a vertical leg
 * @param east eastward velocity, m/s
 * @param north northward velocity, m/s
 * @param up rate of climb, m/s
 */
public record LegMotion(double heading, double east, double north, double up) {
    /**
     * The motion on a leg.
     *
     * @param dx eastward displacement over the leg, m
     * @param dy northward displacement, m
     * @param dz height gained, m
     * @param time time that the leg takes, above 0, s
     */
    public static LegMotion along(double dx, double dy, double dz, double time) {
        return new LegMotion(StrictMath.atan2(dx, dy), dx / time, dy / time, dz / time);
    }
}
