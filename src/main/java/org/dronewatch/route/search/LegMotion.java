package org.dronewatch.route.search;

/**
 * How a drone moves on a straight leg.
 *
 * @param heading clockwise from north, rad; of no meaning on a vertical leg
 * @param east velocity eastwards, m/s
 * @param north velocity northwards, m/s
 * @param up rate of climb, m/s
 */
public record LegMotion(double heading, double east, double north, double up) {
    /**
     * The motion on a leg.
     *
     * @param dx from its beginning to its end, eastwards, m
     * @param dy northwards, m
     * @param dz upwards, m
     * @param time that it takes, above 0, s
     */
    public static LegMotion along(double dx, double dy, double dz, double time) {
        return new LegMotion(StrictMath.atan2(dx, dy), dx / time, dy / time, dz / time);
    }
}
