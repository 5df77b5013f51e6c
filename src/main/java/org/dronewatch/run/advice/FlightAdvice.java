package org.dronewatch.run.advice;

import java.util.function.Consumer;
import org.dronewatch.drone.FlightLimits;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.world.Ground;

/**
 * Warns of a flight that exceeds the performance stated for its drone: a line for each limit, with the point at which
 * the flight exceeds it most.
 *
 * @param id name of the drone
 * @param limits performance limits of the drone
 * @param ground the highest surfaces of the world
 * @param duration duration of the run, s
 */
public record FlightAdvice(String id, FlightLimits limits, Ground ground, double duration) {
    /** The greatest interval between the times at which a flight is examined, s. */
    private static final double STEP = 0.1;
    /** The greatest number of times that are examined: more would delay the start of long runs. */
    private static final int MOST_TIMES = 20_000;

    /** Gives one line for each limit that the flight exceeds. */
    public void giveTo(FlightPath path, Consumer<String> target) {
        FlightExcesses excesses = new FlightExcesses(limits);
        int steps = (int) Math.min(MOST_TIMES, Math.max(1.0, Math.ceil(duration / STEP)));
        for (int i = 0; i <= steps; i++) {
            double time = duration * i / steps;
            excesses.examine(time, path.at(time), path.acceleration(time), ground);
        }
        excesses.lines().forEach(line -> target.accept("drone '" + id + "' " + line));
    }
}
