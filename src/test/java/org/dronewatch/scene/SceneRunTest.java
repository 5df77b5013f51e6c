package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import nl.tudelft.simulation.dsol.experiment.Experiment;
import nl.tudelft.simulation.dsol.experiment.Replication;
import nl.tudelft.simulation.dsol.experiment.SingleReplication;
import nl.tudelft.simulation.dsol.simulators.DevsSimulator;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import org.djutils.event.EventListener;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.SweepPoint;
import org.dronewatch.run.time.Pace;
import org.dronewatch.scenes.CameraRange;
import org.dronewatch.sensor.ActingSettings;
import org.dronewatch.sensor.Observation;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SceneRunTest {
    @TempDir
    private Path directory;

    private static List<Observation> observations(SceneRunner runner) {
        List<Observation> all = new ArrayList<>();
        runner.onFrame(frame -> all.addAll(frame.observations())).run();
        return all;
    }

    private static List<Observation> plainRun() {
        return observations(new SceneRunner(new HillScene()).threads(1));
    }

    @Test
    void eachSensorLooksAtItsOwnRate() {
        List<Observation> all = plainRun();

        assertThat(timesOf(all, "wide")).hasSize(41).contains(0.1, 0.3, 0.7, 4.0);
        assertThat(timesOf(all, "narrow")).hasSize(17).contains(0.0, 0.25, 0.5, 4.0);
        assertThat(timesOf(all, "dice")).hasSize(21).contains(0.2, 0.6);
        assertThat(all).extracting(Observation::time).isSorted();
    }

    private static List<Double> timesOf(List<Observation> all, String sensor) {
        return all.stream()
                .filter(o -> o.sensor().equals(sensor) && o.drone().equals("comer"))
                .map(Observation::time)
                .toList();
    }

    @Test
    void aRunThatEndsEarlyIsTheBeginningOfTheWholeRun() {
        List<Observation> whole = plainRun();

        for (double until : new double[] {0.0, 0.25, 1.0, 3.05, HillScene.DURATION, 100.0}) {
            List<Observation> begun =
                    observations(new SceneRunner(new HillScene()).threads(2).until(until));
            assertThat(begun)
                    .as("until %s s", until)
                    .isNotEmpty()
                    .isEqualTo(whole.stream().filter(o -> o.time() <= until).toList());
        }
        SceneResult result = new SceneRunner(new HillScene()).until(1.0).run();
        assertThat(result.complete()).isFalse();
        assertThat(result.simulated()).isEqualTo(1.0);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new SceneRunner(new HillScene()).until(-1.0))
                .withMessageContaining("-1.0");
    }

    /** Each run against its own duration: the scene's lasts for neither of them. */
    @Test
    void aSweepOfTheDurationIsCompleteWhenTheLongestRunIs() throws IOException {
        Path file = Files.writeString(
                directory.resolve("durations.yaml"),
                """
                world: {models: [packaged:hill.obj]}
                run: {duration: 5}
                sweep: {parameter: run.duration, values: [0.5, 2]}
                """);
        for (double until : new double[] {0.4, 0.5, 1.9, 2.0, 5.0, Double.POSITIVE_INFINITY}) {
            assertThat(new SceneRunner(new SceneFile(file)).until(until).run().complete())
                    .as("until %s s", until)
                    .isEqualTo(until >= 2.0);
        }
        assertThat(new SceneRunner(new SceneFile(file)).only(0).until(0.5).run().complete())
                .isTrue();
    }

    @Test
    void oneRunOfASweepAloneIsAsAmongTheOthers() {
        SceneRunner all = new SceneRunner(new CameraRange()).set("run.duration", "1");
        SceneRunner fourth =
                new SceneRunner(new CameraRange()).set("run.duration", "1").only(3);

        assertThat(fourth.run().runs()).isEqualTo(all.run().runs().subList(3, 4));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new SceneRunner(new CameraRange()).only(5).run())
                .withMessageContaining("run 5 must be 0 to 4");
    }

    @Test
    void theCameraSeesBothDrones() {
        SceneResult result = new HillScene().run();

        assertThat(result.complete()).isTrue();
        assertThat(result.simulated()).isEqualTo(HillScene.DURATION);
        assertThat(result.firstDetectionRange("wide", "comer")).isPresent();
        assertThat(result.firstDetectionRange("narrow", "crosser").orElseThrow())
                .isCloseTo(20.0, within(2.0));
    }

    @Test
    void theSameSeedGivesTheSameObservationsForAnyNumberOfThreads() {
        List<Observation> expected = plainRun();

        for (int threads : new int[] {1, 2, 5}) {
            assertThat(observations(new SceneRunner(new HillScene()).threads(threads)))
                    .isEqualTo(expected);
        }
    }

    @Test
    void anotherSeedAnotherSensorAndAnotherSampleDrawOtherNumbers() {
        List<Double> draws = new ArrayList<>();
        for (long seed : new long[] {HillScene.SEED, 43}) {
            observations(new SceneRunner(new HillScene()).seed(seed)).stream()
                    .filter(o -> o.kind().equals("dice"))
                    .forEach(o -> draws.add(o.value()));
        }
        assertThat(draws).hasSize(2 * 2 * 2 * 21).doesNotHaveDuplicates();
    }

    @Test
    void aRunInRealTimeGivesTheSameAndTakesItsTime() {
        long start = System.nanoTime();
        List<Observation> paced = observations(new SceneRunner(new HillScene()).pace(Pace.realTime(8.0)));

        assertThat(1e-9 * (System.nanoTime() - start)).isGreaterThan(HillScene.DURATION / 8.0);
        assertThat(paced).isEqualTo(plainRun());
    }

    @Test
    void aPlainDsolSimulatorGivesTheSame() throws InterruptedException {
        DevsSimulator<Double> simulator = new DevsSimulator<>("plain");
        HillScene scene = new HillScene(simulator);
        List<Observation> all = new ArrayList<>();
        scene.addListener(event -> all.add((Observation) event.getContent()), Scene.OBSERVATION);
        try {
            simulator.initialize(scene, new SingleReplication<>("plain", 0.0, 0.0, HillScene.DURATION));
            awaitEnd(simulator, 1, simulator::start);
        } finally {
            simulator.cleanUp();
        }
        assertThat(all).isEqualTo(plainRun());
    }

    @Test
    void theReplicationsOfADsolExperimentHaveSeedsOfTheirOwn() throws InterruptedException {
        List<Observation> first = experiment();

        assertThat(experiment()).isEqualTo(first);
        List<Double> draws = first.stream()
                .filter(o -> o.kind().equals("dice"))
                .map(Observation::value)
                .toList();
        assertThat(draws).hasSize(3 * 2 * 2 * 21).doesNotHaveDuplicates();
        List<Double> seen = first.stream()
                .filter(o -> o.sensor().equals("wide"))
                .map(Observation::value)
                .toList();
        assertThat(seen.subList(82, 164)).isEqualTo(seen.subList(0, 82));
    }

    private static List<Observation> experiment() throws InterruptedException {
        DevsSimulator<Double> simulator = new DevsSimulator<>("experiment");
        HillScene scene = new HillScene(simulator);
        List<Observation> all = new ArrayList<>();
        scene.addListener(event -> all.add((Observation) event.getContent()), Scene.OBSERVATION);
        Experiment<Double, DevsSimulatorInterface<Double>> experiment =
                new Experiment<>("experiment", simulator, scene, 0.0, 0.0, HillScene.DURATION, 3);
        try {
            CountDownLatch ended = new CountDownLatch(1);
            experiment.addListener(event -> ended.countDown(), Experiment.END_EXPERIMENT_EVENT);
            experiment.start();
            assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
        } finally {
            simulator.cleanUp();
        }
        return all;
    }

    private static void awaitEnd(DevsSimulator<Double> simulator, int ends, Runnable start)
            throws InterruptedException {
        CountDownLatch ended = new CountDownLatch(ends);
        EventListener listener = event -> ended.countDown();
        simulator.addListener(listener, Replication.END_REPLICATION_EVENT);
        start.run();
        assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
    }

    @Test
    void aRunThatIsCutShortKeepsWhatItHas() {
        AtomicInteger frames = new AtomicInteger();
        SceneResult result = new SceneRunner(new HillScene())
                .onFrame(frame -> frames.incrementAndGet())
                .cancelWhen(() -> frames.get() >= 10)
                .run();

        assertThat(result.complete()).isFalse();
        assertThat(frames.get()).isEqualTo(10);
        assertThat(result.simulated()).isBetween(0.1, 1.0);
    }

    @Test
    void aSweepRunsOncePerValueAndEndsWhenItsSettingIsSet() {
        Scene scene = new HillScene() {
            @Override
            protected void build() {
                super.build();
                sweep("sensors.wide.fov", 0.4, 0.8, 1.2);
            }
        };
        SceneResult swept = new SceneRunner(scene).run();
        assertThat(swept.runs()).hasSize(3);
        assertThat(swept.sweep().stream().filter(point -> point.sensor().equals("wide")))
                .extracting(SweepPoint::value)
                .containsExactly(0.4, 0.8, 1.2);

        SceneResult single =
                new SceneRunner(scene).set("sensors.wide.fov", "45.8366 deg").run();
        assertThat(single.runs()).hasSize(1);
        assertThat(single.sweep()).isEmpty();
        assertThat(single.firstDetectionRange("wide", "comer"))
                .isEqualTo(swept.firstDetectionRange(1, "wide", "comer"));
    }

    @Test
    void sweepsWithABadValueDoNotStart() {
        List<String> frames = new ArrayList<>();
        Scene scene = new HillScene() {
            @Override
            protected void build() {
                super.build();
                sweep("sensors.wide.fov", 0.4, 4.0);
            }
        };
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SceneRunner(scene)
                        .onFrame(frame -> frames.add("frame"))
                        .run())
                .withMessageContaining("sensors.wide.fov=4.0");
        assertThat(frames).isEmpty();
    }

    @Test
    void whatASensorThrowsReachesTheCallerAndTheNextRunWorks() {
        Scene scene = new HillScene() {
            @Override
            protected void build() {
                super.build();
                add("broken", new ActingSettings(new Position(0, 0, 0), 5.0, look -> {
                    throw new IllegalStateException("broken");
                }));
            }
        };
        assertThatIllegalStateException()
                .isThrownBy(() -> new SceneRunner(scene).run())
                .withMessage("broken");
        assertThatIllegalStateException().isThrownBy(scene::run).withMessage("broken");
        assertThat(new HillScene().run().complete()).isTrue();
    }

    @Test
    void noThreadIsLeftBehind() throws InterruptedException {
        new HillScene().run();
        Thread.sleep(200);
        assertThat(Thread.getAllStackTraces().keySet())
                .filteredOn(thread -> !thread.isDaemon() && thread.getName().contains("dronewatch"))
                .isEmpty();
    }

    @Test
    void theEventsTellWhenADroneIsGainedAndLost() {
        SceneResult result = new HillScene().run();
        for (RunResult run : result.runs()) {
            for (PairResult pair : run.pairs()) {
                List<DetectionEvent> events = run.events().stream()
                        .filter(event -> event.observation().sensor().equals(pair.sensor())
                                && event.observation().drone().equals(pair.drone()))
                        .toList();
                for (int i = 0; i < events.size(); i++) {
                    assertThat(events.get(i).gained()).isEqualTo(i % 2 == 0);
                    assertThat(events.get(i).observation().isDetected()).isEqualTo(i % 2 == 0);
                }
                assertThat(pair.firstDetected().isPresent()).isEqualTo(!events.isEmpty());
            }
        }
    }
}
