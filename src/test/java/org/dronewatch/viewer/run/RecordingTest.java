package org.dronewatch.viewer.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.render.Yard;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.LookId;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecordingTest {
    @TempDir
    private Path directory;

    private final Recording recording = new Recording();
    private final List<Observation> told = new ArrayList<>();
    private SceneResult result;
    private RecordedRun run;

    @BeforeEach
    void record() {
        result = new SceneRunner(new Yard(directory))
                .listener(recording)
                .onFrame(frame -> told.addAll(frame.observations()))
                .run();
        recording.finish(true);
        run = recording.runs().get(0);
    }

    @Test
    void holdsWhatTheSensorsTold() {
        assertThat(told).hasSizeGreaterThan(150);
        for (Observation o : told) {
            PairReading reading =
                    run.reading(o.sensor(), o.drone(), o.arrival() + 1e-9).orElseThrow();
            assertThat(reading.value()).isCloseTo(o.value(), within(1e-4));
            assertThat(reading.range()).isCloseTo(o.range(), within(1e-4));
            assertThat(run.isDetected(o.sensor(), o.drone(), o.arrival())).isEqualTo(o.isDetected());
        }
        assertThat(run.reading("camera", "nobody", 5)).isEmpty();
        assertThat(run.isFinished()).isTrue();
        assertThat(run.reached()).isEqualTo(9.0);
    }

    @Test
    void changesNothingInTheResults() {
        SceneResult alone = new SceneRunner(new Yard(directory)).run();

        assertThat(alone.runs()).isEqualTo(result.runs());
        assertThat(result.runs().get(0).events()).isNotEmpty().isEqualTo(run.eventsFrom(0));
    }

    @Test
    void aVeryLongRunIsThinnedButKeepsItsWholeLength() {
        Readings readings = new Readings();
        int all = 5 * Readings.MOST;
        for (int i = 0; i < all; i++) {
            readings.add(new Observation(new LookId("s", "camera", i, i), "d", 100.0, new Reading(i, 12.0, "px")));
        }
        assertThat(readings.count()).isBetween(Readings.MOST / 2, Readings.MOST);
        for (int i = 0; i < all; i += 9973) {
            PairReading reading = readings.at(i).orElseThrow();
            assertThat(reading.time()).isLessThanOrEqualTo(i).isGreaterThan(i - 16.0);
        }
        assertThat(readings.at(-1.0)).isEmpty();
    }

    @Test
    void aRunThatWasCutShortEndsWhereItWasCut() {
        Recording cut = new Recording();
        cut.runStarted(new RunInfo(0, 1, run.info().settings()), run.stage());
        cut.observed(new Frame(0, 3.5, List.of(), List.of()));
        cut.finish(false);

        assertThat(cut.isFinished()).isTrue();
        assertThat(cut.runs().get(0).reached()).isEqualTo(3.5);
        assertThat(cut.runs().get(0).isFinished()).isFalse();
    }

    @Test
    void playsStepsAndJumpsWithinWhatIsSimulated() {
        Recording live = new Recording();
        live.runStarted(new RunInfo(0, 1, run.info().settings()), run.stage());
        RecordedRun half = live.runs().get(0);
        Playback playback = new Playback();
        playback.show(half);
        live.observed(new Frame(0, 4.0, List.of(), List.of()));

        playback.play();
        playback.advance(1.0);
        assertThat(playback.time()).isEqualTo(1.0);
        playback.setSpeed(5.0);
        playback.advance(0.2);
        assertThat(playback.time()).isCloseTo(2.0, within(1e-12));
        playback.setSpeed(Double.POSITIVE_INFINITY);
        playback.advance(0.01);
        assertThat(playback.time()).isEqualTo(4.0);
        assertThat(playback.isPlaying()).as("it waits for the simulation").isTrue();

        playback.step(-1);
        assertThat(playback.isPlaying()).isFalse();
        assertThat(playback.time()).isCloseTo(3.9, within(1e-9));
        playback.jump(2.03);
        playback.step(1);
        assertThat(playback.time()).as("from look to look").isCloseTo(2.1, within(1e-9));
        playback.step(1);
        assertThat(playback.time()).isCloseTo(2.2, within(1e-9));
        playback.jump(2.03);
        playback.step(-1);
        assertThat(playback.time()).isCloseTo(2.0, within(1e-9));
        playback.jump(100);
        assertThat(playback.time()).as("not beyond what is simulated").isEqualTo(4.0);
        playback.jump(-1);
        assertThat(playback.time()).isZero();
    }

    @Test
    void playingStopsAtTheEndAndBeginsAnew() {
        Playback playback = new Playback();
        playback.show(run);
        playback.jump(8.9);
        playback.play();
        playback.advance(0.5);
        assertThat(playback.time()).isEqualTo(9.0);
        assertThat(playback.isPlaying()).isFalse();
        playback.play();
        assertThat(playback.time()).isZero();
    }
}
