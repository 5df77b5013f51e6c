package org.dronewatch.scene;

import java.util.Optional;
import java.util.function.Supplier;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import nl.tudelft.simulation.dsol.simulators.SimulatorInterface;
import org.djutils.event.Event;
import org.djutils.event.EventListener;
import org.djutils.event.reference.ReferenceType;
import org.dronewatch.run.Stage;

/**
 * The thread that runs a scene, which alone steers its drones. DSOL constructs the model on one thread and runs its
 * events on another, and a simulator that was started may later be stepped by a third; each start and each step fires
 * an event on the thread that runs what follows.
 *
 * <p>It never stops listening by itself: at the end of the last replication, another thread may already be removing the
 * simulator's listeners, which two threads cannot safely do at once. The simulator holds it by a weak reference only.
 */
final class RunThread implements EventListener {
    private static final long serialVersionUID = 1L;

    private final transient Supplier<Optional<Stage>> current;

    /**
     * Listens to nothing yet.
     *
     * @param current returns the stage of the current run; empty if there is none
     */
    RunThread(Supplier<Optional<Stage>> current) {
        this.current = current;
    }

    /**
     * The calling thread steers the drones of the current run until the simulator starts; from then on the thread that
     * runs its events does.
     */
    void begin(DevsSimulatorInterface<Double> simulator) {
        current.get().ifPresent(Stage::steerHere);
        // The same listener is not added twice.
        simulator.addListener(this, SimulatorInterface.START_EVENT, ReferenceType.WEAK);
    }

    @Override
    public void notify(Event event) {
        current.get().ifPresent(Stage::steerHere);
    }
}
