package org.dronewatch.flight;

import java.util.Collection;
import java.util.List;

/**
 * The clock of a run's steered flights: the time that the run has reached. The code that runs a scene has the clock;
 * commands go to a {@link SteeredFlight}, whose known past is extended only by the clock. Flights of other kinds are
 * ignored.
 */
public final class SteeringClock {
    private final List<SteeredFlight> flights;

    private SteeringClock(List<SteeredFlight> flights) {
        this.flights = flights;
    }

    /** A clock for the steered flights among those given. */
    public static SteeringClock of(Collection<? extends FlightPath> flights) {
        return new SteeringClock(flights.stream()
                .flatMap(path -> SteeredFlight.in(path).stream())
                .toList());
    }

    /** Makes the calling thread the one that runs the scene: only it may steer. */
    public void steerHere() {
        flights.forEach(SteeredFlight::steerHere);
    }

    /**
     * Advances to a time, s: the flights are then known before that time, and also at that time unless a command still
     * changes them.
     */
    public void advance(double time) {
        flights.forEach(flight -> flight.advance(time));
    }

    /**
     * Records that sensors take a look at a given time, s: up to and including that time, the flights can no longer
     * change.
     */
    public void look(double time) {
        flights.forEach(flight -> flight.look(time));
    }

    /** The time up to which all flights are known, s: infinity if none is steered. */
    public double known() {
        return flights.stream().mapToDouble(SteeredFlight::known).min().orElse(Double.POSITIVE_INFINITY);
    }

    /** Ends the run: no more commands are accepted. */
    public void end() {
        flights.forEach(SteeredFlight::end);
    }
}
