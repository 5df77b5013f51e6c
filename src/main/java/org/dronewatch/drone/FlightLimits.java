package org.dronewatch.drone;

import org.dronewatch.flight.Airframe;

/**
 * The limits of a drone's flight, within which a route must stay.
 *
 * @param climb largest rate of climb under power, m/s
 * @param sink largest rate of descent under power, m/s
 * @param turnRate largest rate at which its course turns at cruise speed, rad/s
 * @param hover whether it can stay in one place
 * @param leastSpeed minimum speed under power if it cannot hover, m/s; meaningless if it can
 * @param ceiling greatest height above the surface below it, m
 * @param endurance longest flight under power, s
 * @param glideRatio horizontal distance covered with the motors off per metre of height lost; 0 if it cannot glide
 * @param glideSpeed speed along the path while it glides, m/s
 */
public record FlightLimits(
        double climb,
        double sink,
        double turnRate,
        boolean hover,
        double leastSpeed,
        double ceiling,
        double endurance,
        double glideRatio,
        double glideSpeed) {
    /** Bank angle of a coordinated turn: PX4 limits that of fixed-wing drones to 50 degrees (FW_R_LIM). */
    private static final double WING_BANK = Math.toRadians(50.0);
    /** Tilt of a multirotor: PX4 limits it to 45 degrees (MPC_TILTMAX_AIR). */
    private static final double ROTOR_TILT = Math.toRadians(45.0);
    /** DJI's consumer drones climb to 500 m above the point of take-off; assumed for other airframes. */
    private static final double CEILING = 500.0;

    /**
     * The least speed of a drone that cannot hover, as a fraction of its cruise speed: PX4's FW_AIRSPD_MIN and
     * FW_AIRSPD_TRIM.
     */
    private static final double LEAST_SPEED = 10.0 / 15.0;

    private static final double HALF_AN_HOUR = 1800.0;
    private static final double AN_HOUR = 3600.0;
    /** The glide ratio of a good small fixed-wing drone. Assumed. */
    private static final double WING_GLIDE = 10.0;

    /**
     * The typical limits of a type of airframe. Rates of climb and descent are the defaults of PX4: 3 and 1.5 m/s for
     * multirotors (MPC_Z_VEL_MAX_UP, MPC_Z_VEL_MAX_DN), 5 and 5 m/s for the others (FW_T_CLMB_MAX, FW_T_SINK_MAX). The
     * rate of turn is {@code g tan(bank) / speed}, where g is the acceleration of gravity and the bank angle is 45
     * degrees for multirotors and 50 degrees for the others. Drones that cannot hover fly at no less than two thirds of
     * their cruise speed, as with the defaults of PX4: 10 m/s at least, 15 m/s in cruise (FW_AIRSPD_MIN,
     * FW_AIRSPD_TRIM). The ceiling is 500 m. The endurance of 30 minutes (multirotor) or an hour, the glide ratio of 10
     * and a glide at cruise speed are assumed; multirotors do not glide.
     *
     * @param airframe the type of airframe
     * @param speed cruise speed, above 0, m/s
     */
    public static FlightLimits typical(Airframe airframe, double speed) {
        double least = LEAST_SPEED * speed;
        double wingTurn = Airframe.GRAVITY * Math.tan(WING_BANK) / speed;
        return switch (airframe) {
            case MULTIROTOR ->
                new FlightLimits(
                        3.0,
                        1.5,
                        Airframe.GRAVITY * Math.tan(ROTOR_TILT) / speed,
                        true,
                        least,
                        CEILING,
                        HALF_AN_HOUR,
                        0.0,
                        speed);
            case FIXED_WING -> new FlightLimits(5.0, 5.0, wingTurn, false, least, CEILING, AN_HOUR, WING_GLIDE, speed);
            case HYBRID -> new FlightLimits(5.0, 5.0, wingTurn, true, least, CEILING, AN_HOUR, WING_GLIDE, speed);
        };
    }

    /**
     * These limits without a limit on the rate of turn, for flights whose corners stand for rounded turns, such as
     * those along routes.
     */
    public FlightLimits turningInstantly() {
        return new FlightLimits(
                climb, sink, Double.POSITIVE_INFINITY, hover, leastSpeed, ceiling, endurance, glideRatio, glideSpeed);
    }
}
