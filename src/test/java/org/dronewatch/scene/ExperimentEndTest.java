package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Collection;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import nl.tudelft.simulation.dsol.experiment.Experiment;
import nl.tudelft.simulation.dsol.experiment.SingleReplication;
import nl.tudelft.simulation.dsol.simulators.DevsSimulator;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import nl.tudelft.simulation.dsol.simulators.SimulatorInterface;
import org.dronewatch.geometry.Position;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * The end of an experiment, at which its owner cleans the simulator up while the simulator's thread still tells its
 * listeners of the last replication.
 */
class ExperimentEndTest {
    private static final int EXPERIMENTS = 60;
    private static final int REPLICATIONS = 3;

    private final Collection<Throwable> uncaught = new ConcurrentLinkedQueue<>();
    private Thread.UncaughtExceptionHandler former;

    /** A floor and one sensor: done at once. */
    private static final class Brief extends Scene {
        private static final long serialVersionUID = 1L;

        Brief(DevsSimulatorInterface<Double> simulator) {
            super(simulator);
        }

        @Override
        public Path directory() {
            return FloorScene.MODELS;
        }

        @Override
        protected void build() {
            loadWorld(load("floor.obj"));
            add("dice", new DiceSettings(new Position(0, 0, 1), 1.0, 0.5));
        }
    }

    @BeforeEach
    void listen() {
        former = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, thrown) -> uncaught.add(thrown));
    }

    @AfterEach
    void restore() {
        Thread.setDefaultUncaughtExceptionHandler(former);
    }

    @Test
    void nothingFailsHoweverSoonTheSimulatorIsCleanedUp() throws InterruptedException {
        for (int i = 0; i < EXPERIMENTS; i++) {
            DevsSimulator<Double> simulator = new DevsSimulator<>("brief");
            Experiment<Double, DevsSimulatorInterface<Double>> experiment =
                    new Experiment<>("brief", simulator, new Brief(simulator), 0.0, 0.0, 0.1, REPLICATIONS);
            CountDownLatch ended = new CountDownLatch(1);
            experiment.addListener(event -> ended.countDown(), Experiment.END_EXPERIMENT_EVENT);
            experiment.start();
            assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
            simulator.cleanUp();
        }
        assertThat(uncaught).isEmpty();
    }

    /** Replications that keep the simulator's listeners do not add to them. */
    @Test
    void aSceneListensOnceHoweverOftenItRuns() {
        DevsSimulator<Double> simulator = new DevsSimulator<>("brief");
        Brief scene = new Brief(simulator);
        for (int i = 0; i < REPLICATIONS; i++) {
            simulator.initialize(scene, new SingleReplication<>("brief", 0.0, 0.0, 0.1), false);
            assertThat(simulator.numberOfListeners(SimulatorInterface.START_EVENT))
                    .isEqualTo(1);
        }
        simulator.cleanUp();
    }
}
