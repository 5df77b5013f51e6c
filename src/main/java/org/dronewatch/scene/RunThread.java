package org.dronewatch.scene;

import nl.tudelft.simulation.dsol.experiment.Replication;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import nl.tudelft.simulation.dsol.simulators.SimulatorInterface;
import org.djutils.event.Event;
import org.djutils.event.EventListener;
import org.dronewatch.run.Stage;

/**
 * The thread that runs a scene, which alone steers its drones. DSOL constructs the model on one thread and runs its
 * events on another, and a simulator that was started may later be stepped by a third; each start and each step fires
 * an event on the thread that runs what follows.
 */
final class RunThread implements EventListener {
    private final Stage stage;
    private final DevsSimulatorInterface<Double> simulator;

    private RunThread(Stage stage, DevsSimulatorInterface<Double> simulator) {
        this.stage = stage;
        this.simulator = simulator;
    }

    /**
     * The calling thread steers the drones of a run until the simulator starts; from then on the thread that runs its
     * events does.
     */
    static void follow(Stage stage, DevsSimulatorInterface<Double> simulator) {
        stage.steerHere();
        RunThread follower = new RunThread(stage, simulator);
        simulator.addListener(follower, SimulatorInterface.START_EVENT);
        simulator.addListener(follower, Replication.END_REPLICATION_EVENT);
    }

    @Override
    public void notify(Event event) {
        if (event.getType().equals(SimulatorInterface.START_EVENT)) {
            stage.steerHere();
        } else {
            simulator.removeListener(this, SimulatorInterface.START_EVENT);
            simulator.removeListener(this, Replication.END_REPLICATION_EVENT);
        }
    }
}
