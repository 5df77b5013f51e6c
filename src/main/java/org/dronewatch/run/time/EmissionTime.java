package org.dronewatch.run.time;

import java.util.OptionalDouble;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.geometry.Position;

/** The time at which a drone emitted the signal that reaches a sensor now, for signals that take time to arrive. */
public final class EmissionTime {
    /** Enough bisections to reduce a day to a nanosecond. */
    private static final int HALVINGS = 48;

    private EmissionTime() {}

    /**
     * The time of emission, which solves {@code speed * (time - emission) = distance at emission}. For a drone faster
     * than the signal there may be several solutions, of which one is returned.
     *
     * @param time when the signal arrives, s
     * @param speed speed of the signal, m/s
     * @return seconds since the start of the run; empty if no signal emitted since the start has arrived yet
     */
    public static OptionalDouble of(FlightPath path, Position sensor, double speed, double time) {
        if (isYetToCome(path, sensor, speed, time, 0.0)) {
            return OptionalDouble.empty();
        }
        double arrived = 0.0;
        double onItsWay = time;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = 0.5 * (arrived + onItsWay);
            if (isYetToCome(path, sensor, speed, time, middle)) {
                onItsWay = middle;
            } else {
                arrived = middle;
            }
        }
        return OptionalDouble.of(arrived);
    }

    private static boolean isYetToCome(FlightPath path, Position sensor, double speed, double time, double emission) {
        return path.at(emission).position().distance(sensor) > speed * (time - emission);
    }
}
