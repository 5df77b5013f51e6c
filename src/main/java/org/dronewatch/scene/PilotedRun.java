package org.dronewatch.scene;

import nl.tudelft.simulation.dsol.SimRuntimeException;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import org.dronewatch.run.RunSession;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;

/** A run whose drones are steered: its drones, its time and its simulator. For the thread of the simulator. */
public final class PilotedRun {
    private final RunSession session;
    private final DevsSimulatorInterface<Double> simulator;

    PilotedRun(RunSession session, DevsSimulatorInterface<Double> simulator) {
        this.session = session;
        this.simulator = simulator;
    }

    /** The DSOL simulator that drives the run. */
    public DevsSimulatorInterface<Double> simulator() {
        return simulator;
    }

    /**
     * Does something later in the run, before sensors look at that time.
     *
     * @param seconds from now, 0 or more
     * @throws IllegalArgumentException when negative or not a number
     */
    public void after(double seconds, Runnable action) {
        if (!(seconds >= 0.0)) {
            throw new IllegalArgumentException("after " + seconds + " s: must be 0 or more");
        }
        try {
            simulator.scheduleEventRel(seconds, () -> act(action));
        } catch (SimRuntimeException e) {
            throw new IllegalStateException(e);
        }
    }

    /**
     * Does what a pilot does now.
     *
     * @throws InputException when it gives a command that the drone cannot follow, and does not handle that itself
     */
    void act(Runnable action) {
        try {
            action.run();
        } catch (IllegalArgumentException e) {
            throw new InputException("pilot at " + time() + " s: " + e.getMessage(), e);
        }
    }

    /** The settings of the run, with the value of a sweep. */
    public SceneSettings settings() {
        return session.info().settings();
    }

    /** Now, seconds since the start of the run. */
    public double time() {
        double now = simulator.getSimulatorTime() - simulator.getReplication().getStartTime();
        // Where a replication does not start at 0 the difference is rounded: never past a look that is still to come.
        return Math.max(session.reached(), Math.min(now, session.nextTime().orElse(now)));
    }

    /**
     * A drone as it flies now.
     *
     * @param id its name in the scene; {@code x-1} for the first drone of a swarm {@code x}
     * @throws IllegalArgumentException when there is no such drone
     */
    public DroneInFlight drone(String id) {
        return new DroneInFlight(id, session.stage().flight(id), this::time);
    }
}
