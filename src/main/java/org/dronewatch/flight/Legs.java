package org.dronewatch.flight;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geometry.Position;

/** Divides flights into legs, for recording. */
public final class Legs {
    /** A leg continues while the flight is within this distance of it, m. */
    private static final double CLOSE = 1e-6;

    /** As {@link #CLOSE}, but for angles, rad, and for the time since the motors were stopped, s. */
    private static final double ALIKE = 1e-9;

    /**
     * The step between samples, s: with ten samples per second and an acceleration of 2.5 m/s2, a flight is recorded to
     * within 3 mm.
     */
    private static final double STEP = 0.1;

    /**
     * The greatest number of samples of all drones in one run; longer steps keep a long run with many drones to some 15
     * MB.
     */
    private static final int MOST_SAMPLES = 100_000;

    private Legs() {}

    /**
     * The legs of all flights of a run, as {@link #of} returns them: sampled ten times a second, or less often in a
     * long run with many drones.
     *
     * @param flights the flights, by id of the drone
     * @param until end of the run, seconds since its start
     * @return the legs by id of the drone, in the same order
     */
    public static Map<String, List<Leg>> ofAll(Map<String, FlightPath> flights, double until) {
        double step = Math.max(STEP, until * flights.size() / MOST_SAMPLES);
        Map<String, List<Leg>> legs = new LinkedHashMap<>();
        flights.forEach((id, path) -> legs.put(id, of(path, until, step)));
        return legs;
    }

    /**
     * The legs of a flight. If the flight consists of legs, those legs are returned; their attitudes do not include the
     * tilt of an accelerating drone. Any other flight is sampled at equal time steps: samples on a straight line at
     * constant speed are joined into one leg, which is exact except for rounding. In a bend, or with an acceleration a,
     * the flight is divided at each step, and the position between two samples is off by at most {@code a step^2 / 8}.
     * The last leg begins at the end of the known flight, so that the legs also state that end.
     *
     * @param path the flight
     * @param until end of the known flight, seconds since the start of the run
     * @param step interval between two samples, above 0, s
     */
    public static List<Leg> of(FlightPath path, double until, double step) {
        Optional<FlownPath> flown = FlownPath.in(path);
        if (flown.isPresent()) {
            List<Leg> legs = new ArrayList<>();
            flown.get().legs().stream().filter(leg -> leg.time() <= until).forEach(legs::add);
            return ended(legs, until, legs.get(legs.size() - 1).at(until));
        }
        return ended(sampled(path, until, step), until, path.at(until));
    }

    private static List<Leg> ended(List<Leg> legs, double until, FlightState end) {
        if (legs.get(legs.size() - 1).time() < until) {
            legs.add(new Leg(until, end));
        }
        return legs;
    }

    private static List<Leg> sampled(FlightPath path, double until, double step) {
        List<Leg> legs = new ArrayList<>();
        FlightState here = path.at(0.0);
        for (int i = 0; i * step < until || i == 0; i++) {
            double time = i * step;
            FlightState next = path.at(Math.min(until, time + step));
            Leg leg = leg(time, here, next, Math.min(until, time + step));
            if (legs.isEmpty() || !goesOn(legs.get(legs.size() - 1), leg, next, Math.min(until, time + step))) {
                legs.add(leg);
            }
            here = next;
        }
        return legs;
    }

    /**
     * The leg from one sample to the next: it has the flight's own velocity if that leads from one to the other, and
     * otherwise the mean velocity between them.
     */
    private static Leg leg(double time, FlightState here, FlightState next, double nextTime) {
        Leg own = new Leg(time, here);
        if (nextTime <= time || isClose(own.at(nextTime), next)) {
            return own;
        }
        Position velocity = next.position().minus(here.position()).times(1.0 / (nextTime - time));
        return new Leg(time, new FlightState(here.position(), velocity, here.attitude(), here.gliding()));
    }

    private static boolean isClose(FlightState one, FlightState other) {
        return one.position().distance(other.position()) <= CLOSE;
    }

    /** Whether a leg, continued, also covers the next one. */
    private static boolean goesOn(Leg before, Leg next, FlightState end, double endTime) {
        FlightState expected = before.at(next.time());
        FlightState state = next.start();
        return isClose(expected, state)
                && isClose(before.at(endTime), end)
                && Math.abs(expected.attitude().yaw() - state.attitude().yaw()) <= ALIKE
                && Math.abs(expected.attitude().pitch() - state.attitude().pitch()) <= ALIKE
                && Math.abs(expected.attitude().roll() - state.attitude().roll()) <= ALIKE
                && expected.isPowered() == state.isPowered()
                && Math.abs(expected.gliding().orElse(0.0) - state.gliding().orElse(0.0)) <= CLOSE
                && expected.velocity().distance(state.velocity()) <= CLOSE;
    }
}
