package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import nl.tudelft.simulation.dsol.SimRuntimeException;
import nl.tudelft.simulation.dsol.experiment.Replication;
import nl.tudelft.simulation.dsol.experiment.SingleReplication;
import nl.tudelft.simulation.dsol.model.AbstractDsolModel;
import nl.tudelft.simulation.dsol.simulators.DevsSimulator;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Observation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A user's DSOL model holds a scene, runs under the user's simulator, and steers its drones. */
class SteeredUnderDsolTest {
    private static final double DURATION = 4.0;

    @TempDir
    private Path directory;

    /** Flies a square with corners that are not numbers of binary fractions, by events of normal priority. */
    private static final class Model extends AbstractDsolModel<Double, DevsSimulatorInterface<Double>> {
        private static final long serialVersionUID = 1L;
        private static final double SIDE = 0.7;

        private final transient Scene scene;
        private final transient List<FlightState> ends = new ArrayList<>();
        private int corners;

        Model(Scene scene, DevsSimulatorInterface<Double> simulator) {
            super(simulator);
            this.scene = scene;
        }

        @Override
        public void constructModel() {
            scene.constructModel();
            corners = 0;
            turn();
            try {
                getSimulator().scheduleEventRel(DURATION, this::end);
            } catch (SimRuntimeException e) {
                throw new IllegalStateException(e);
            }
        }

        private void turn() {
            double heading = 0.5 * Math.PI * corners;
            scene.drone("hunter").fly(new Position(10 * Math.sin(heading), 10 * Math.cos(heading), 0));
            corners++;
            if (corners <= 4) {
                try {
                    getSimulator().scheduleEventRel(SIDE, this::turn);
                } catch (SimRuntimeException e) {
                    throw new IllegalStateException(e);
                }
            }
        }

        private void end() {
            ends.add(scene.drone("hunter").state());
            assertThat(scene.drone("hunter").state(SIDE).position().distance(new Position(0, 7, 160)))
                    .isLessThan(1e-9);
        }
    }

    private SceneFile scene(DevsSimulatorInterface<Double> simulator) throws IOException {
        Path file = directory.resolve("steered.yaml");
        Files.writeString(
                file,
                """
                world:
                  models: [packaged:hill.obj]
                drones:
                  hunter:
                    model: packaged:quadrotor.obj
                    flight: {kind: steered, start: [0, 0, 160]}
                    speed: 10 m/s
                sensors:
                  camera: {kind: camera, position: [0, -40, 160], rate: 10 Hz, aim: {lookAt: [0, 0, 160]}}
                """);
        return new SceneFile(file, simulator);
    }

    /** Runs two replications, the second of which starts late. */
    @Test
    void eachReplicationIsSteeredAnew() throws IOException, InterruptedException {
        DevsSimulator<Double> simulator = new DevsSimulator<>("own");
        SceneFile scene = scene(simulator);
        Model model = new Model(scene, simulator);
        List<Double> ranges = new ArrayList<>();
        scene.addListener(event -> ranges.add(((Observation) event.getContent()).range()), Scene.OBSERVATION);
        try {
            for (double start : new double[] {0.0, 7.3}) {
                CountDownLatch ended = new CountDownLatch(1);
                simulator.initialize(model, new SingleReplication<>("from " + start, start, 0.0, DURATION));
                simulator.addListener(event -> ended.countDown(), Replication.END_REPLICATION_EVENT);
                simulator.start();
                assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
            }
        } finally {
            simulator.cleanUp();
        }
        // After the square it flies on to the north for what is left of four seconds.
        Position end = new Position(0, 10 * (DURATION - 4 * Model.SIDE), 160);
        assertThat(model.ends)
                .hasSize(2)
                .allSatisfy(state -> assertThat(state.position().distance(end)).isLessThan(1e-9));
        assertThat(ranges).hasSize(82);
        for (int i = 0; i <= 40; i++) {
            Position expected = square(0.1 * i);
            assertThat(ranges.get(i)).isCloseTo(expected.distance(new Position(0, -40, 160)), within(1e-9));
            assertThat(ranges.get(41 + i)).isCloseTo(ranges.get(i), within(1e-9));
        }
    }

    /** First this thread runs the events, then the simulator's own: each steers in its turn. */
    @Test
    void aSimulatorIsSteppedByHandAndThenStarted() throws IOException, InterruptedException {
        DevsSimulator<Double> simulator = new DevsSimulator<>("stepped");
        SceneFile scene = scene(simulator);
        Model model = new Model(scene, simulator);
        try {
            CountDownLatch ended = new CountDownLatch(1);
            simulator.initialize(model, new SingleReplication<>("stepped", 0.0, 0.0, DURATION));
            simulator.addListener(event -> ended.countDown(), Replication.END_REPLICATION_EVENT);
            while (simulator.getSimulatorTime() < 1.0) {
                simulator.step();
            }
            assertThat(model.corners).as("a corner by hand").isEqualTo(2);
            scene.drone("hunter").fly(new Position(10, 0, 0));
            simulator.start();
            assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
        } finally {
            simulator.cleanUp();
        }
        assertThat(model.corners).isEqualTo(5);
        assertThat(model.ends).singleElement().satisfies(state -> assertThat(
                        state.position().distance(new Position(0, 10 * (DURATION - 4 * Model.SIDE), 160)))
                .isLessThan(1e-9));
    }

    /** Where the square leads. */
    private static Position square(double time) {
        double side = 10 * Model.SIDE;
        double flown = 10 * time;
        if (flown <= side) {
            return new Position(0, flown, 160);
        }
        if (flown <= 2 * side) {
            return new Position(flown - side, side, 160);
        }
        if (flown <= 3 * side) {
            return new Position(side, 3 * side - flown, 160);
        }
        return flown <= 4 * side ? new Position(4 * side - flown, 0, 160) : new Position(0, flown - 4 * side, 160);
    }
}
