package org.dronewatch.scene;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Consumer;
import nl.tudelft.simulation.dsol.SimRuntimeException;
import nl.tudelft.simulation.dsol.experiment.Replication;
import nl.tudelft.simulation.dsol.model.DsolModel;
import nl.tudelft.simulation.dsol.simulators.DevsSimulator;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import nl.tudelft.simulation.dsol.simulators.ReplicationState;
import nl.tudelft.simulation.dsol.simulators.RunState;
import nl.tudelft.simulation.dsol.simulators.SimulatorInterface;
import org.dronewatch.run.RunSession;
import org.dronewatch.setting.InputException;

/**
 * A DSOL simulator that runs on the caller's thread and passes on what an event throws, unchanged. DSOL's own start()
 * runs on a worker thread and only logs failures.
 */
final class SceneSimulator extends DevsSimulator<Double> {
    private static final long serialVersionUID = 1L;
    private static final Object CONSTRUCTION = new Object();

    private transient Thread caller;
    private transient RuntimeException failure;
    private transient RunSession session;
    private transient Pilot pilot;
    private transient Consumer<String> warnings;
    private transient volatile boolean looking;

    private SceneSimulator(String id) {
        super(id);
    }

    /** A simulator; DSOL's constructor touches static state, so they are made one at a time. */
    static SceneSimulator create(String id) {
        synchronized (CONSTRUCTION) {
            return new SceneSimulator(id);
        }
    }

    /**
     * Drives a run of a scene from start to end on this thread, and leaves no thread behind.
     *
     * @param open the run, which the caller closes
     * @param steering who steers its drones
     * @param notes receives warnings about what the pilot does
     */
    void run(
            DsolModel<Double, DevsSimulatorInterface<Double>> scene,
            SceneReplication replication,
            RunSession open,
            Pilot steering,
            Consumer<String> notes) {
        caller = Thread.currentThread();
        failure = null;
        session = open;
        pilot = steering;
        warnings = notes;
        looking = false;
        try {
            initializeApart(scene, replication);
            runToEnd();
        } finally {
            cleanUp();
            session = null;
            pilot = null;
            warnings = null;
            caller = null;
        }
    }

    /** The run to drive; empty when this simulator is started like any other. */
    Optional<RunSession> session() {
        return Optional.ofNullable(session);
    }

    /** Who steers the drones of {@link #session()}. */
    Optional<Pilot> pilot() {
        return Optional.ofNullable(pilot);
    }

    /**
     * Lets the sensors look. What goes wrong meanwhile is not the pilot's mistake; what goes wrong in any other event
     * is.
     */
    void look(Runnable looks) {
        looking = true;
        looks.run();
        looking = false;
    }

    /** Warns whoever runs the scene. */
    void warn(String warning) {
        if (warnings != null) {
            warnings.accept("warning: " + warning);
        }
    }

    /** DSOL swallows interrupts while it initializes, for about a millisecond: so another thread initializes it. */
    private void initializeApart(
            DsolModel<Double, DevsSimulatorInterface<Double>> scene, SceneReplication replication) {
        try {
            // Waits through an interrupt and keeps it.
            CompletableFuture.runAsync(() -> initializeAlone(scene, replication), SceneSimulator::start)
                    .join();
        } catch (CompletionException e) {
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw e.getCause() instanceof RuntimeException known ? known : e;
        }
    }

    private void initializeAlone(
            DsolModel<Double, DevsSimulatorInterface<Double>> scene, SceneReplication replication) {
        synchronized (CONSTRUCTION) {
            initialize(scene, replication);
        }
    }

    private static void start(Runnable task) {
        new Thread(task, "dronewatch-initialization").start();
    }

    private void runToEnd() {
        runUntilTime = getReplication().getEndTime();
        runUntilIncluding = true;
        fireTimedEvent(Replication.START_REPLICATION_EVENT, null, getSimulatorTime());
        replicationState = ReplicationState.STARTED;
        runState = RunState.STARTED;
        fireTimedEvent(SimulatorInterface.START_EVENT, null, getSimulatorTime());
        run();
        runState = RunState.STOPPED;
        fireTimedEvent(SimulatorInterface.STOP_EVENT, null, getSimulatorTime());
        if (failure != null) {
            throw failure;
        }
        replicationState = ReplicationState.ENDED;
        runState = RunState.ENDED;
        fireTimedEvent(Replication.END_REPLICATION_EVENT, null, getSimulatorTime());
    }

    /** Ends the run without waking the worker thread, which would be interrupted. */
    @Override
    public void endReplication() {
        if (Thread.currentThread() == caller) {
            replicationState = ReplicationState.ENDING;
            runState = RunState.STOPPING;
            eventList.clear();
        } else {
            super.endReplication();
        }
    }

    /** Keeps the exception for the caller. */
    @Override
    protected void handleSimulationException(Exception exception) {
        if (Thread.currentThread() != caller) {
            super.handleSimulationException(exception);
            return;
        }
        Throwable cause = exception;
        while (cause instanceof SimRuntimeException && cause.getCause() != null) {
            cause = cause.getCause();
        }
        failure = failure(cause);
        runState = RunState.STOPPING;
    }

    private RuntimeException failure(Throwable cause) {
        boolean isPilots = pilot != Pilot.NONE && !looking;
        if (isPilots && !(cause instanceof InputException || cause instanceof CancellationException)) {
            return new PilotFault(pilot.getClass(), cause).at(getSimulatorTime());
        }
        return cause instanceof RuntimeException known ? known : new IllegalStateException(cause);
    }
}
