package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.Thorough;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.Recorded;
import org.dronewatch.flight.Steered;
import org.dronewatch.flight.SteeredFlight;
import org.dronewatch.flight.Swarm;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.RunReport;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.Observation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A drone that a DSOL model steers is observed as it flew; recorded and replayed it is observed as before. */
class SteeringTest {
    @TempDir
    private Path directory;

    /** Runs into a directory. */
    private List<Observation> run(Scene scene, int threads, String name) {
        List<Observation> all = new ArrayList<>();
        SceneRunner runner = new SceneRunner(scene)
                .directory(directory)
                .threads(threads)
                .onFrame(frame -> all.addAll(frame.observations()));
        try (RunReport report = new RunReport(scene, directory.resolve(name), true)) {
            SceneResult result = runner.listener(report).run();
            report.inputs(runner.inputs());
            report.finish(result);
        }
        return all;
    }

    /** A runner for what is flown, whatever the microphones hear meanwhile. */
    private static SceneRunner deaf(Scene scene) {
        return new SceneRunner(scene).set("sensors.ear.enabled", "false").set("sensors.far-ear.enabled", "false");
    }

    private byte[] bytes(String file) throws IOException {
        return Files.readAllBytes(directory.resolve(file));
    }

    @Thorough
    @Test
    void recordedAndReplayedItIsObservedAsBefore() throws IOException {
        List<Observation> steered = run(new Pursuit(), 1, "one");
        run(new Pursuit(), 4, "four");
        List<Observation> again = run(new Pursuit(Recorded.of("one/flights.csv")), 1, "replayed");
        assertThat(again).as("in all digits, not only in those of the tables").isEqualTo(steered);
        run(new Pursuit(new Recorded("four/flights.csv", Optional.of("hunter"), 0)), 4, "replayed-four");

        String observed = Files.readString(directory.resolve("one/observations.csv"));
        for (String sensor : List.of("camera", "ear", "far-ear", "radar")) {
            assertThat(observed.lines().filter(row -> row.contains("," + sensor + ",") && row.contains(",hunter,")))
                    .as(sensor)
                    .isNotEmpty();
        }
        assertThat(observed.lines().filter(row -> row.contains(",camera,camera,hunter,") && row.contains(",true,")))
                .as("the camera sees the hunter")
                .isNotEmpty();
        for (String name : List.of("four", "replayed", "replayed-four")) {
            for (String file : List.of("observations.csv", "detections.csv", "flights.csv")) {
                assertThat(bytes(name + "/" + file)).as(name + "/" + file).isEqualTo(bytes("one/" + file));
            }
        }
        assertThat(Files.readString(directory.resolve("replayed/provenance.json")))
                .as("what it was run from")
                .contains("one/flights.csv");
    }

    /** One that leans into its turns by itself. */
    @Test
    void aReplayedDroneLeansAsTheSteeredOneDid() {
        SceneRunner steering = deaf(new Pursuit()).set("drones.hunter.lean", "true");
        List<Observation> steered = new ArrayList<>();
        List<Double> rolls = new ArrayList<>();
        Scene written = new Pursuit();
        try (RunReport report = new RunReport(written, directory.resolve("leaning"), false)) {
            report.finish(steering.listener(report)
                    .onFrame(frame -> steered.addAll(frame.observations()))
                    .listener(new SceneListener() {
                        private Stage stage;

                        @Override
                        public void runStarted(RunInfo run, Stage itsStage) {
                            stage = itsStage;
                        }

                        @Override
                        public void observed(Frame frame) {
                            rolls.add(stage.flight("hunter")
                                    .at(frame.time())
                                    .attitude()
                                    .roll());
                        }
                    })
                    .run());
        }
        List<Observation> replayed = observations(deaf(new Pursuit(Recorded.of("leaning/flights.csv")))
                .set("drones.hunter.lean", "true")
                .directory(directory));
        assertThat(replayed).isEqualTo(steered).isNotEmpty();
        assertThat(rolls).as("it banks").anyMatch(roll -> Math.abs(roll) > 0.1);
    }

    private static List<Observation> observations(SceneRunner runner) {
        List<Observation> all = new ArrayList<>();
        runner.onFrame(frame -> all.addAll(frame.observations())).run();
        return all;
    }

    /** Where the hunter is at 6 s, by the pursuit integrated here step by step. */
    @Test
    void theHunterFliesAsItIsSteered() {
        List<Position> flown = new ArrayList<>();
        deaf(new Pursuit())
                .onFrame(frame -> frame.drones().stream()
                        .filter(drone -> drone.id().equals("hunter"))
                        .forEach(drone -> flown.add(drone.origin())))
                .run();
        Position hunter = Pursuit.START;
        for (int i = 0; i < 60; i++) {
            double angle = 15.0 / 40.0 * 0.1 * i;
            Position prey = new Position(40 * Math.sin(angle), 40 * Math.cos(angle), 175);
            hunter = hunter.plus(prey.minus(hunter).unit().times(Pursuit.SPEED * 0.1));
        }
        assertThat(flown.get(flown.size() - 1).distance(hunter)).isLessThan(1e-9);
    }

    @Test
    void aSoundIsHeardFromWhereTheHunterWas() {
        List<Observation> heard = new ArrayList<>();
        Stage[] stage = new Stage[1];
        new SceneRunner(new Pursuit())
                .listener(new SceneListener() {
                    @Override
                    public void runStarted(RunInfo run, Stage itsStage) {
                        stage[0] = itsStage;
                    }

                    @Override
                    public void observed(Frame frame) {
                        frame.observations().stream()
                                .filter(one -> one.sensor().equals("ear")
                                        && one.drone().equals("hunter"))
                                .forEach(heard::add);
                    }
                })
                .run();
        assertThat(heard).isNotEmpty().allSatisfy(one -> {
            Position then = stage[0].flight("hunter").at(one.time()).position();
            assertThat(one.range()).isCloseTo(then.distance(Pursuit.EAR), within(1e-9));
            assertThat(one.arrival() - one.time()).isGreaterThan(0.05);
        });
        assertThat(stage[0].known()).isEqualTo(Pursuit.DURATION);
        assertThat(((SteeredFlight) stage[0].flight("hunter")).legs()).hasSize(61);
    }

    @Test
    void theFutureOfASteeredDroneIsNotKnownDuringARun() {
        List<Double> refused = new ArrayList<>();
        Stage[] stage = new Stage[1];
        deaf(new Pursuit())
                .until(1.0)
                .listener(new SceneListener() {
                    @Override
                    public void runStarted(RunInfo run, Stage itsStage) {
                        stage[0] = itsStage;
                    }

                    @Override
                    public void observed(Frame frame) {
                        stage[0].dronesAt(frame.time());
                        assertThatIllegalStateException().isThrownBy(() -> stage[0].dronesAt(frame.time() + 0.05));
                        refused.add(frame.time());
                    }
                })
                .run();
        assertThat(refused).isNotEmpty();
    }

    /** A listener turns the hunter away whenever the radar has seen it, which is after the look. */
    @Test
    void anAnswerToAnObservationIsReplayedToo() {
        List<Observation> steered = new ArrayList<>();
        Pursuit scene = new Pursuit();
        try (RunReport report = new RunReport(scene, directory.resolve("answered"), false)) {
            report.finish(new SceneRunner(scene)
                    .set("sensors.ear.enabled", "false")
                    .set("sensors.far-ear.propagation", "level-model")
                    .pilot(() -> run -> run.drone("hunter").fly(new Position(Pursuit.SPEED, 0, 0)))
                    .listener(report)
                    .onFrame(frame -> {
                        steered.addAll(frame.observations());
                        long seen = frame.observations().stream()
                                .filter(one -> one.drone().equals("hunter") && one.isDetected())
                                .count();
                        if (seen > 0) {
                            scene.drone("hunter").fly(new Position(0, Pursuit.SPEED * (seen - 2.0) / 3.0, 1));
                        }
                    })
                    .run());
        }
        List<Observation> replayed = observations(new SceneRunner(new Pursuit(Recorded.of("answered/flights.csv")))
                .set("sensors.ear.enabled", "false")
                .set("sensors.far-ear.propagation", "level-model")
                .directory(directory));
        assertThat(replayed).isEqualTo(steered).isNotEmpty();
    }

    /** A command is an event of normal priority: it comes before the look at the same time, in every look. */
    @Test
    void aCommandCountsInTheLookAtItsTime() {
        List<Double> speeds = new ArrayList<>();
        deaf(new Pursuit())
                .set("sensors.radar.enabled", "false")
                .set("sensors.camera.rate", "2 Hz")
                .pilot(() -> run -> {
                    for (int i = 12; i >= 0; i--) {
                        double speed = i;
                        run.after(0.5 * i, () -> run.drone("hunter").fly(new Position(24, 0, 0)));
                        run.after(0.5 * i, () -> run.drone("hunter").fly(new Position(0, 0, speed)));
                    }
                })
                .onFrame(frame -> speeds.add(frame.drones().get(1).velocity().z))
                .run();
        assertThat(speeds).hasSize(13);
        for (int i = 0; i < speeds.size(); i++) {
            assertThat(speeds.get(i)).isEqualTo(i);
        }
    }

    @Test
    void everyRunOfASweepIsSteeredAnew() {
        List<Position> ends = new ArrayList<>();
        deaf(new Pursuit() {
                    private static final long serialVersionUID = 1L;

                    @Override
                    protected void build() {
                        super.build();
                        sweep("sensors.camera.width", 320, 640, 960);
                    }
                })
                .onFrame(frame -> {
                    if (frame.time() == Pursuit.DURATION) {
                        ends.add(frame.drones().get(1).origin());
                    }
                })
                .run();
        assertThat(ends).hasSize(3).containsOnly(ends.get(0));
    }

    @Test
    void theDronesOfASwarmAreSteeredOneByOne() {
        double half = 0.5 * Math.PI;
        List<Position> ends = new ArrayList<>();
        deaf(new Pursuit(new Steered(Pursuit.START, half)) {
                    private static final long serialVersionUID = 1L;

                    @Override
                    protected void build() {
                        super.build();
                        add(
                                "pack",
                                DroneSettings.of(loadPackaged("quadrotor.obj"), new Steered(Pursuit.START, half))
                                        .withSwarm(Swarm.of(2)));
                    }
                })
                .pilot(() -> run -> {
                    run.drone("pack-1").fly(new Position(0, 0, 1));
                    run.drone("pack-2").fly(new Position(0, 0, -1));
                })
                .onFrame(frame -> {
                    if (frame.time() == Pursuit.DURATION) {
                        ends.add(frame.drones().get(2).origin());
                        ends.add(frame.drones().get(3).origin());
                    }
                })
                .run();
        assertThat(ends.get(0)).isEqualTo(Pursuit.START.plus(new Position(0, 0, 6)));
        // With the nose to the east, ten metres to the right are ten to the south.
        assertThat(ends.get(1).distance(Pursuit.START.plus(new Position(0, -10, -6))))
                .isLessThan(1e-9);
    }
}
