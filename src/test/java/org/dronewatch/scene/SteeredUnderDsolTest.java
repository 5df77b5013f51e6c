package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
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
import org.dronewatch.Thorough;
import org.dronewatch.flight.Attitude;
import org.dronewatch.flight.FlightState;
import org.dronewatch.flight.FlightsFile;
import org.dronewatch.flight.FlownPath;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Observation;
import org.dronewatch.setting.InputException;
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

    /** A user's model: its hunter flies towards a prey that circles, ten times a second, by events of its own. */
    private static final class Chase extends AbstractDsolModel<Double, DevsSimulatorInterface<Double>> {
        private static final long serialVersionUID = 1L;

        private final transient SceneFile scene;
        private final transient Path flights;
        private final boolean steers;

        Chase(SceneFile scene, DevsSimulatorInterface<Double> simulator, Path flights, boolean steers) {
            super(simulator);
            this.scene = scene;
            this.flights = flights;
            this.steers = steers;
        }

        @Override
        public void constructModel() {
            scene.constructModel();
            try {
                if (steers) {
                    steer();
                }
                getSimulator().scheduleEventRel(DURATION, () -> scene.writeFlights(flights));
            } catch (SimRuntimeException e) {
                throw new IllegalStateException(e);
            }
        }

        private void steer() {
            DroneInFlight hunter = scene.drone("hunter");
            Position path =
                    scene.drone("prey").state().position().minus(hunter.state().position());
            hunter.fly(path.unit().times(25.0), new Attitude(Math.atan2(path.x(), path.y()), 0.1, -0.2));
            try {
                getSimulator().scheduleEventRel(0.1, this::steer);
            } catch (SimRuntimeException e) {
                throw new IllegalStateException(e);
            }
        }
    }

    /** What is observed when the hunter flies as it is told, under a simulator of the user's own. */
    private List<Observation> chased(String flight, String flights, boolean steers)
            throws IOException, InterruptedException {
        Path file = directory.resolve("chase.yaml");
        Files.writeString(
                file,
                """
                world:
                  models: [packaged:hill.obj]
                  backgroundNoise: 5
                drones:
                  prey:
                    model: packaged:quadrotor.obj
                    flight: {kind: orbit, centre: [0, 0, 175], radius: 40}
                    speed: 15 m/s
                  hunter: {model: packaged:quadrotor.obj, flight: %s, speed: 25 m/s}
                sensors:
                  camera: {kind: camera, position: [-40, -40, 160], rate: 7 Hz, aim: {lookAt: [-60, 40, 172]}}
                  ear: {kind: acoustic, position: [40, 0, 150], rate: 4 Hz, propagation: {kind: energy-model, rays: 100}}
                  far-ear: {kind: acoustic, position: [-300, 200, 160], rate: 1 Hz, propagation: {kind: energy-model, rays: 100}}
                  radar: {use: blighter-a400, rate: 1 Hz, position: [100, 100, 165], aim: {azimuth: 315 deg}}
                """
                        .formatted(flight));
        DevsSimulator<Double> simulator = new DevsSimulator<>("chase");
        SceneFile scene = new SceneFile(file, simulator);
        List<Observation> seen = new ArrayList<>();
        scene.addListener(event -> seen.add((Observation) event.getContent()), Scene.OBSERVATION);
        try {
            CountDownLatch ended = new CountDownLatch(1);
            Chase model = new Chase(scene, simulator, directory.resolve(flights), steers);
            simulator.initialize(model, new SingleReplication<>("chase", 0.0, 0.0, DURATION));
            simulator.addListener(event -> ended.countDown(), Replication.END_REPLICATION_EVENT);
            simulator.start();
            assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
        } finally {
            simulator.cleanUp();
        }
        return seen;
    }

    /**
     * A chase that a user's model steers is recorded at its end, and replayed without it: every observation is the same
     * in all digits, those of microphones among them, which hear the hunter where it was.
     */
    @Thorough
    @Test
    void whatAUsersModelSteersIsRecordedAndReplayed() throws IOException, InterruptedException {
        List<Observation> steered = chased("{kind: steered, start: [-120, 60, 170]}", "flights.csv", true);
        List<Observation> replayed = chased("{kind: recorded, file: flights.csv}", "again.csv", false);

        assertThat(replayed).isEqualTo(steered);
        for (String sensor : List.of("camera", "ear", "far-ear", "radar")) {
            assertThat(steered.stream()
                            .filter(one ->
                                    one.sensor().equals(sensor) && one.drone().equals("hunter")))
                    .as(sensor)
                    .hasSizeGreaterThan(1);
        }
        assertThat(steered.stream()
                        .filter(one ->
                                one.sensor().equals("camera") && one.drone().equals("hunter") && one.value() > 0.0))
                .as("the camera sees the hunter")
                .isNotEmpty();

        List<String> rows = Files.readAllLines(directory.resolve("flights.csv"));
        assertThat(rows.stream().filter(row -> row.startsWith("0,hunter,")))
                .as("a leg for each command, and the end")
                .hasSize(41);
        assertThat(Files.readString(directory.resolve("again.csv")))
                .isEqualTo(Files.readString(directory.resolve("flights.csv")));
        FlownPath hunter = FlightsFile.read(directory.resolve("flights.csv"), "flights.csv")
                .flight(0, "hunter");
        assertThat(steered.stream()
                        .filter(one ->
                                one.sensor().endsWith("ear") && one.drone().equals("hunter")))
                .allSatisfy(one -> {
                    Position ear = one.sensor().equals("ear") ? new Position(40, 0, 150) : new Position(-300, 200, 160);
                    double range = hunter.at(one.time()).position().distance(ear);
                    assertThat(one.range()).isCloseTo(range, within(1e-9));
                    // Sound in air of 20 degrees: 343.2 m/s (ISO 9613-1).
                    assertThat(one.arrival() - one.time()).isCloseTo(range / 343.2, within(1e-3));
                });
    }

    @Test
    void flightsAreWrittenOnlyWhileARunGoesOnAndWhereAFileCanBe() throws IOException, InterruptedException {
        SceneFile idle = scene(new DevsSimulator<>("idle"));
        assertThatIllegalStateException()
                .isThrownBy(() -> idle.writeFlights(directory.resolve("flights.csv")))
                .withMessage("no flights to write: the scene is not running");

        DevsSimulator<Double> simulator = new DevsSimulator<>("nowhere");
        SceneFile scene = scene(simulator);
        try {
            simulator.initialize(scene, new SingleReplication<>("nowhere", 0.0, 0.0, DURATION));
            Path nowhere = directory.resolve("none").resolve("flights.csv");
            assertThatThrownBy(() -> scene.writeFlights(nowhere))
                    .isInstanceOf(InputException.class)
                    .hasMessageStartingWith(nowhere + ": cannot be written: ");
            scene.writeFlights(directory.resolve("start.csv"));
            assertThat(Files.readAllLines(directory.resolve("start.csv")))
                    .as("at the start there is one leg")
                    .hasSize(2)
                    .last()
                    .asString()
                    .startsWith("0,hunter,0.0,0.0,0.0,160.0,");
        } finally {
            simulator.cleanUp();
        }
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
