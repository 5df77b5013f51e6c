package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import nl.tudelft.simulation.dsol.experiment.Replication;
import nl.tudelft.simulation.dsol.experiment.SingleReplication;
import nl.tudelft.simulation.dsol.simulators.DevsRealTimeAnimator;
import nl.tudelft.simulation.dsol.simulators.DevsSimulator;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.RunSession;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Stage;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenes.CameraRange;
import org.dronewatch.sensor.Observation;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A run is a function of settings and seed, whoever drives it. */
class RunSessionTest {
    private static ModelCache models() {
        return new ModelCache(Path.of(""), note -> {});
    }

    /** Everything that a listener is told, in words. */
    private static final class Told implements SceneListener {
        private final List<String> lines = new ArrayList<>();
        private final List<Observation> observations = new ArrayList<>();
        private Stage stage;

        @Override
        public void runStarted(RunInfo run, Stage itsStage) {
            lines.add("started " + run.run() + " of " + run.runs());
            stage = itsStage;
        }

        @Override
        public void observed(Frame frame) {
            lines.add(frame.time() + " " + frame.observations() + " " + frame.pointings());
            observations.addAll(frame.observations());
        }

        @Override
        public void detectionChanged(DetectionEvent event) {
            lines.add(event.toString());
        }

        @Override
        public void runEnded(RunResult result) {
            lines.add("ended " + result);
        }
    }

    private static RunResult driven(SceneSettings settings, long seed, SceneListener listener) {
        return driven(settings, seed, listener, models());
    }

    private static RunResult driven(SceneSettings settings, long seed, SceneListener listener, ModelCache models) {
        try (RunSession session = new RunSession(settings, seed, models)) {
            session.listen(listener);
            while (session.nextTime().isPresent()) {
                double next = session.nextTime().getAsDouble();
                assertThat(session.advance().time()).isEqualTo(next);
            }
            return session.result();
        }
    }

    @Test
    void aSessionTheRunnerAndASimulatorOfTheUsersGiveTheSame() throws InterruptedException {
        Told byRunner = new Told();
        SceneResult ran = new SceneRunner(new HillScene()).listener(byRunner).run();

        Told alone = new Told();
        RunResult result = driven(new HillScene().describe(), HillScene.SEED, alone);
        assertThat(alone.lines).isEqualTo(byRunner.lines);
        assertThat(result).isEqualTo(ran.runs().get(0));
        assertThat(RunSession.run(new HillScene().describe(), HillScene.SEED, models()))
                .isEqualTo(result);

        List<Observation> underDsol = new ArrayList<>();
        run(new DevsSimulator<>("plain"), underDsol);
        assertThat(underDsol).isEqualTo(byRunner.observations).isNotEmpty();
    }

    private static void run(DevsSimulator<Double> simulator, List<Observation> target) throws InterruptedException {
        HillScene scene = new HillScene(simulator);
        scene.addListener(event -> target.add((Observation) event.getContent()), Scene.OBSERVATION);
        try {
            CountDownLatch ended = new CountDownLatch(1);
            simulator.initialize(scene, new SingleReplication<>("run", 0.0, 0.0, HillScene.DURATION));
            simulator.addListener(event -> ended.countDown(), Replication.END_REPLICATION_EVENT);
            simulator.start();
            assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
        } finally {
            simulator.cleanUp();
        }
    }

    /** DSOL asks how much simulated time a millisecond on the wall is: a scene counts seconds. */
    @Test
    void dsolsRealTimeAnimatorKeepsTheTimeOnTheWall() throws InterruptedException {
        double factor = 4.0;
        DevsRealTimeAnimator.TimeDouble animator = new DevsRealTimeAnimator.TimeDouble("paced", 0.001);
        animator.setAnimation(false);
        animator.setSpeedFactor(factor, false);
        List<Observation> paced = new ArrayList<>();
        long start = System.nanoTime();
        run(animator, paced);

        assertThat(1e-9 * (System.nanoTime() - start)).isGreaterThan(0.9 * HillScene.DURATION / factor);
        List<Observation> plain = new ArrayList<>();
        run(new DevsSimulator<>("plain"), plain);
        assertThat(paced).isEqualTo(plain).isNotEmpty();
    }

    @Test
    void eachRunOfASweepIsAFunctionOfItsSettings() {
        SceneRunner runner = new SceneRunner(new CameraRange()).set("run.duration", "1");
        SceneResult swept = runner.run();
        List<SceneSettings> settings = runner.settingsOfRuns();

        assertThat(swept.runs()).hasSize(5);
        for (int k = 4; k >= 0; k--) {
            SceneSettings one = settings.get(k);
            RunResult alone = RunSession.run(one, one.run().seed(), models());
            RunResult among = swept.runs().get(k);
            assertThat(alone.settings()).isEqualTo(among.settings());
            assertThat(alone.events())
                    .extracting(DetectionEvent::observation)
                    .isEqualTo(among.events().stream()
                            .map(DetectionEvent::observation)
                            .toList());
            assertThat(alone.simulated()).isEqualTo(among.simulated());
            assertThat(alone.firstDetectionRange("camera")).isEqualTo(among.firstDetectionRange("camera"));
        }
    }

    @Test
    void theSeedGivenCountsNotThatOfTheSettings() {
        SceneSettings settings = new HillScene().describe();
        Told other = new Told();
        driven(settings, 7, other);
        Told same = new Told();
        driven(new SceneRunner(new HillScene()).seed(7).settings(), 7, same);
        Told own = new Told();
        driven(settings, HillScene.SEED, own);

        assertThat(other.observations).isEqualTo(same.observations).isNotEqualTo(own.observations);
    }

    @Test
    void aRunMayBeEndedAtAnyLook() {
        SceneSettings settings = new HillScene().describe();
        RunResult whole = RunSession.run(settings, HillScene.SEED, models());
        Told told = new Told();
        try (RunSession session = new RunSession(settings, HillScene.SEED, models())) {
            session.listen(told);
            while (session.nextTime().orElseThrow() <= 1.0) {
                session.advance();
            }
            RunResult begun = session.result();

            assertThat(begun.simulated()).isEqualTo(1.0);
            assertThat(begun.events())
                    .isEqualTo(whole.events().stream()
                            .filter(event -> event.observation().time() <= 1.0)
                            .toList());
            assertThat(session.nextTime()).isEmpty();
            assertThat(session.result()).isSameAs(begun);
            assertThatIllegalStateException().isThrownBy(session::advance).withMessageContaining("no more looks");
        }
        assertThat(told.lines.stream().filter(line -> line.startsWith("ended"))).hasSize(1);
    }

    @Test
    void aRunThatIsClosedEarlyHasNoResult() {
        RunSession session = new RunSession(new HillScene().describe(), HillScene.SEED, models());
        Told told = new Told();
        session.listen(told);
        session.advance();
        session.close();

        assertThat(session.nextTime()).isEmpty();
        assertThatIllegalStateException().isThrownBy(session::result).withMessageContaining("closed");
        assertThat(told.lines).noneMatch(line -> line.startsWith("ended"));
        assertThat(told.stage.dronesAt(0.0)).as("the site can still be asked").hasSize(2);
    }

    /** Each of three runs, once, in its order. */
    @Test
    void listenersHearOfARunOnceItsStageIsThere() {
        Scene scene = new HillScene() {
            @Override
            protected void build() {
                super.build();
                sweep("sensors.wide.fov", 0.4, 0.8, 1.2);
            }
        };
        List<Integer> started = new ArrayList<>();
        List<Stage> stages = new ArrayList<>();
        new SceneRunner(scene)
                .listener(new SceneListener() {
                    @Override
                    public void runStarted(RunInfo run, Stage stage) {
                        started.add(run.run());
                        stages.add(stage);
                        assertThat(run.runs()).isEqualTo(3);
                        assertThat(stage.world().mesh().triangleCount()).isPositive();
                    }
                })
                .run();
        assertThat(started).containsExactly(0, 1, 2);
        assertThat(stages).doesNotHaveDuplicates();
    }

    /** Of three runs, the second has a world that cannot be made: its model is wrong. */
    @Test
    void noListenerHearsOfARunWhoseWorldCannotBeMade(@TempDir Path directory) throws IOException {
        Files.writeString(directory.resolve("whole.obj"), "v -9 0 -9\nv 9 0 -9\nv 9 0 9\nf 3 2 1\n");
        Files.writeString(directory.resolve("broken.obj"), "v -9 0 -9\nv 9 0 -9\nf 3 2 1\n");
        List<SceneSettings> settings = List.of(inAWorldOf("whole.obj"), inAWorldOf("broken.obj"));
        ModelCache models = new ModelCache(directory, note -> {});
        Told told = new Told();
        driven(settings.get(0), 1, told, models);
        assertThat(told.lines).isNotEmpty();
        List<String> before = List.copyOf(told.lines);

        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> driven(settings.get(1), 1, told, models))
                .withMessageContaining("broken.obj:3");
        assertThat(told.lines).isEqualTo(before);

        Told byRunner = new Told();
        Scene scene = new Scene() {
            @Override
            public Path directory() {
                return directory;
            }

            @Override
            protected void build() {
                loadWorld(load("broken.obj"));
                add("drone", DroneSettings.of(loadPackaged("quadrotor.obj"), Hover.at(new Position(0, 20, 5))));
                add("dice", new DiceSettings(new Position(0, 0, 5), 1.0, 0.5));
                setRun(RunSettings.DEFAULT.withDuration(1.0));
                sweep("sensors.dice.luck", 0.2, 0.4);
            }
        };
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SceneRunner(scene).listener(byRunner).run())
                .withMessageContaining("broken.obj:3");
        assertThat(byRunner.lines).isEmpty();
    }

    private static SceneSettings inAWorldOf(String model) {
        return new SceneRunner(new HillScene())
                .set("world.models.0.file", model)
                .set("run.duration", "1")
                .settings();
    }
}
