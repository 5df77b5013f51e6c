package org.dronewatch.analysis.cell;

import java.util.OptionalDouble;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.FlightLimits;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;

/**
 * A steady glide with the motors off.
 *
 * @param speed speed along the path, above 0, m/s
 * @param ratio glide ratio: horizontal distance per metre of height lost, above 0
 * @param since how long the motors have been off, s
 */
public record GlideDescent(double speed, double ratio, double since) {
    /** The motors have been off for this many cooling times: 5 % of the heat is left. */
    private static final double COLD = 3.0;

    /**
     * The best glide of a drone whose motors have been off for three times its cooling time.
     *
     * @throws IllegalArgumentException if the drone cannot glide
     */
    public static GlideDescent of(DroneSettings drone) {
        FlightLimits limits = drone.flightLimits();
        if (!(limits.glideRatio() > 0.0)) {
            throw new IllegalArgumentException("glide ratio 0: the drone cannot glide");
        }
        return new GlideDescent(
                limits.glideSpeed(), limits.glideRatio(), COLD * drone.heat().coolingTime());
    }

    /** The state at a position, m, on a heading, clockwise from north, rad. */
    FlightState at(Position position, double heading) {
        double sink = speed / Math.sqrt(1.0 + ratio * ratio);
        double level = sink * ratio;
        Position velocity = new Position(level * StrictMath.sin(heading), level * StrictMath.cos(heading), -sink);
        return new FlightState(position, velocity, heading, OptionalDouble.of(since));
    }
}
