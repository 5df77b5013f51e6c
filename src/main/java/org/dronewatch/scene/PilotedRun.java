package org.dronewatch.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import nl.tudelft.simulation.dsol.SimRuntimeException;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightsFile;
import org.dronewatch.flight.Legs;
import org.dronewatch.flight.SteeringClock;
import org.dronewatch.run.RunSession;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;

/** A run as its pilot sees it: its drones, its time and its simulator. For the thread that runs the scene. */
public final class PilotedRun {
    private final RunSession session;
    private final DevsSimulatorInterface<Double> simulator;
    private final Class<?> pilot;
    private final List<Double> late = new ArrayList<>();
    private boolean beginning;

    /**
     * A run.
     *
     * @param pilot class of the pilot, to which its mistakes are attributed in messages
     */
    PilotedRun(RunSession session, DevsSimulatorInterface<Double> simulator, Class<?> pilot) {
        this.session = session;
        this.simulator = simulator;
        this.pilot = pilot;
    }

    /** The DSOL simulator that drives the run. */
    public DevsSimulatorInterface<Double> simulator() {
        return simulator;
    }

    /**
     * Schedules an action later in the run, before the sensors take their looks at that time. An action due after the
     * end of the run is dropped, so an action may keep rescheduling itself; the runner warns if an action that a pilot
     * schedules at the start of the run is due after its end.
     *
     * @param seconds simulated time from now, 0 or more, s
     * @throws InputException when {@code seconds} is negative or not a number, or the action is null
     */
    public void after(double seconds, Runnable action) {
        if (!(seconds >= 0.0)) {
            throw new InputException(here() + "after " + seconds + " s: the delay must be 0 s or more");
        }
        if (action == null) {
            throw new InputException(here() + "after " + seconds + " s: action is missing");
        }
        double when = time() + seconds;
        if (beginning && when > settings().run().duration()) {
            late.add(when);
        }
        try {
            simulator.scheduleEventRel(seconds, () -> act(action));
        } catch (SimRuntimeException e) {
            throw new IllegalStateException(e);
        }
    }

    /**
     * Lets the pilot begin.
     *
     * @param steering what it does first
     * @return a warning, if it schedules an action for a time after the end of the run
     * @throws InputException as for {@link #act}
     */
    Optional<String> begin(Consumer<PilotedRun> steering) {
        beginning = true;
        act(() -> steering.accept(this));
        beginning = false;
        return late.stream()
                .min(Double::compare)
                .map(first -> "the pilot schedules " + late.size()
                        + (late.size() == 1 ? " action, at " : " actions, the first at ")
                        + first + " s, after the end of the run at "
                        + settings().run().duration() + " s: "
                        + (late.size() == 1 ? "it has" : "they have") + " no effect");
    }

    /**
     * Does what the pilot does now.
     *
     * @throws InputException when the pilot throws an exception of any other kind, or gives a command that the drone
     *     cannot follow, and does not handle that itself
     */
    private void act(Runnable action) {
        try {
            action.run();
        } catch (InputException | CancellationException e) {
            throw e;
        } catch (RuntimeException e) {
            throw new PilotFault(pilot, e).at(time());
        }
    }

    /** The settings of the run, including its value of the swept setting. */
    public SceneSettings settings() {
        return session.info().settings();
    }

    /** The present time, seconds since the start of the run. */
    public double time() {
        double now = simulator.getSimulatorTime() - simulator.getReplication().getStartTime();
        // Where a replication does not start at 0 the difference is rounded: never past a look that is still to come.
        return Math.max(session.reached(), Math.min(now, session.nextTime().orElse(now)));
    }

    /**
     * A drone in flight, at the present time.
     *
     * @param id name of the drone in the scene; {@code x-1} for the first drone of a swarm {@code x}
     * @throws InputException when there is no such drone
     */
    public DroneInFlight drone(String id) {
        try {
            return new DroneInFlight(id, session.stage().flight(id), this::time);
        } catch (IllegalArgumentException e) {
            throw new InputException(here() + e.getMessage(), e);
        }
    }

    /**
     * Writes the flights of all drones so far in the format of {@code flights.csv}, from which flights of the kind
     * {@code recorded} repeat them.
     *
     * @param file the file to be written; an existing file is replaced
     * @throws InputException when the file cannot be written
     */
    public void writeFlights(Path file) {
        double now = time();
        Map<String, FlightPath> flights = session.stage().flights();
        SteeringClock.of(flights.values()).advance(now);
        FlightsFile.write(file, session.info().run(), Legs.ofAll(flights, now));
    }

    /** The beginning of a message: when. */
    private String here() {
        return "pilot at " + time() + " s: ";
    }
}
