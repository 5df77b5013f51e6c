package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.sensor.ActingSettings;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.camera.CameraSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * An interrupt ends a run as a cancellation, wherever it is; an error passes unchanged; both leave the runner as it
 * was.
 */
@Timeout(value = 300, unit = TimeUnit.SECONDS)
class InterruptTest {
    private static final Duration PROMPT = Duration.ofMinutes(1);

    /** The hill with a number of sensors that do something at each look. */
    private static final class DoingScene extends Scene {
        private static final long serialVersionUID = 1L;
        private final int sensors;
        private final transient Consumer<Look> action;

        DoingScene(int sensors, Consumer<Look> action) {
            this.sensors = sensors;
            this.action = action;
        }

        @Override
        protected void build() {
            loadWorld(loadPackaged("hill.obj"));
            add("drone", DroneSettings.of(loadPackaged("quadrotor.obj"), Hover.at(new Position(0, 20, 144))));
            for (int i = 0; i < sensors; i++) {
                add("sensor-" + i, new ActingSettings(new Position(0, 0, 144), 10.0, action));
            }
            setRun(RunSettings.DEFAULT.withDuration(1.0));
        }
    }

    /** Runs a scene that interrupts its own thread, and checks that the run is cancelled and the flag is kept. */
    private static void interruptAt(SceneRunner runner, int threads) {
        AtomicReference<Throwable> thrown = new AtomicReference<>();
        try {
            runner.threads(threads).run();
        } catch (RuntimeException e) {
            thrown.set(e);
        }
        assertThat(thrown.get()).isInstanceOf(CancellationException.class);
        assertThat(Thread.interrupted()).as("the thread stays interrupted").isTrue();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void anInterruptBetweenLooksEndsTheRunAndTheRunnerRunsAgain(int threads) {
        SceneResult expected = new SceneRunner(new HillScene()).threads(threads).run();
        AtomicInteger frames = new AtomicInteger();
        SceneRunner runner = new SceneRunner(new HillScene()).onFrame(frame -> {
            if (frames.incrementAndGet() == 4) {
                Thread.currentThread().interrupt();
            }
        });
        interruptAt(runner, threads);
        assertThat(frames).hasValue(4);

        SceneResult again = runner.run();
        assertThat(again.complete()).isTrue();
        assertThat(again.pairs()).isEqualTo(expected.pairs());
        assertThat(again.runs().get(0).events())
                .isEqualTo(expected.runs().get(0).events());
    }

    /**
     * A custom sensor that waits, on the caller's thread or on a worker, whether or not it keeps the interrupt flag.
     */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void anInterruptReachesSensorsThatWait(boolean keepsFlag) throws InterruptedException {
        AtomicInteger looks = new AtomicInteger();
        CountDownLatch waiting = new CountDownLatch(3);
        SceneRunner runner = new SceneRunner(new DoingScene(3, look -> {
            if (looks.incrementAndGet() > 3 && looks.get() <= 6) {
                waiting.countDown();
                try {
                    Thread.sleep(Duration.ofHours(1).toMillis());
                } catch (InterruptedException e) {
                    if (keepsFlag) {
                        Thread.currentThread().interrupt();
                    }
                    throw new IllegalStateException("woken", e);
                }
            }
        }));
        assertInterruptedFromOutside(runner, 3, waiting);
        looks.set(100);
        assertThat(runner.run().complete()).isTrue();
    }

    /** A run of 1000 s with pictures of 36 million pixels and 40 drones in them would take hours. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void anInterruptEndsALongLook(int threads) throws InterruptedException {
        CountDownLatch looking = new CountDownLatch(1);
        Scene scene = new Scene() {
            private static final long serialVersionUID = 1L;

            @Override
            protected void build() {
                loadWorld(loadPackaged("hill.obj"));
                for (int i = 0; i < 40; i++) {
                    add(
                            "drone-" + i,
                            DroneSettings.of(loadPackaged("quadrotor.obj"), Hover.at(new Position(i - 20, 4, 144))));
                }
                add("first", new ActingSettings(new Position(0, 0, 144), 10.0, look -> looking.countDown()));
                add("eye", CameraSettings.at(new Position(0, 0, 144)).withResolution(6000, 6000));
                setRun(RunSettings.DEFAULT.withDuration(1000.0));
            }
        };
        assertInterruptedFromOutside(new SceneRunner(scene), threads, looking);
    }

    @Test
    void anInterruptBeforeTheRunIsNotOverlooked() {
        SceneRunner runner = new SceneRunner(new HillScene());
        Thread.currentThread().interrupt();
        interruptAt(runner, 2);
        assertThat(runner.run().complete()).isTrue();
    }

    @Test
    void anInterruptWhileModelsAreReadEndsTheRun() {
        SceneRunner runner = new SceneRunner(new HillScene())
                .notes(note -> Thread.currentThread().interrupt());
        interruptAt(runner, 2);
        Thread.currentThread().interrupt();
        assertThatThrownBy(() -> runner.stage(runner.settings())).isInstanceOf(CancellationException.class);
        assertThat(Thread.interrupted()).isTrue();
    }

    /** Whoever cancels and interrupts gets what there is, also before the first look. */
    @Test
    void aCancelledRunThatIsInterruptedKeepsWhatItHas() {
        AtomicInteger frames = new AtomicInteger();
        SceneRunner runner = new SceneRunner(new HillScene())
                .cancelWhen(() -> frames.get() >= 4)
                .onFrame(frame -> {
                    if (frames.incrementAndGet() == 4) {
                        Thread.currentThread().interrupt();
                    }
                });
        SceneResult result = runner.run();
        assertThat(Thread.interrupted()).isTrue();
        assertThat(result.complete()).isFalse();
        assertThat(result.simulated()).isBetween(0.01, 1.0);

        SceneResult nothing = new SceneRunner(new HillScene())
                .cancelWhen(() -> true)
                .listener(new SceneListener() {
                    @Override
                    public void runStarted(RunInfo info, Stage stage) {
                        Thread.currentThread().interrupt();
                    }
                })
                .run();
        assertThat(Thread.interrupted()).isTrue();
        assertThat(nothing.complete()).isFalse();
        assertThat(nothing.simulated()).isZero();
        assertThat(nothing.pairs()).hasSize(8);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void anErrorPassesUnchangedAndTheRunnerRunsAgain(int threads) {
        for (Throwable error : List.of(
                new AssertionError("of the user"),
                new OutOfMemoryError("test"),
                new NoClassDefFoundError("a/B"),
                new IllegalArgumentException("of the user"))) {
            AtomicInteger looks = new AtomicInteger();
            SceneRunner runner = new SceneRunner(new DoingScene(3, look -> {
                        if (looks.incrementAndGet() == 5) {
                            sneak(error);
                        }
                    }))
                    .threads(threads);
            assertThatThrownBy(runner::run).isSameAs(error);
            assertThat(runner.run().complete()).isTrue();
        }
    }

    @SuppressWarnings("unchecked")
    private static <E extends Throwable> void sneak(Throwable error) throws E {
        throw (E) error;
    }

    private static void assertInterruptedFromOutside(SceneRunner runner, int threads, CountDownLatch begun)
            throws InterruptedException {
        AtomicReference<Throwable> thrown = new AtomicReference<>();
        AtomicReference<Boolean> flag = new AtomicReference<>();
        Thread thread = new Thread(() -> {
            try {
                runner.threads(threads).run();
            } catch (RuntimeException | Error e) {
                thrown.set(e);
            }
            flag.set(Thread.currentThread().isInterrupted());
        });
        thread.start();
        assertThat(begun.await(60, TimeUnit.SECONDS)).isTrue();
        Thread.sleep(200);
        long start = System.nanoTime();
        thread.interrupt();
        thread.join(2 * PROMPT.toMillis());
        assertThat(thread.isAlive()).isFalse();
        assertThat(Duration.ofNanos(System.nanoTime() - start)).isLessThan(PROMPT);
        assertThat(thrown.get()).isInstanceOf(CancellationException.class);
        assertThat(flag.get()).isTrue();
    }
}
