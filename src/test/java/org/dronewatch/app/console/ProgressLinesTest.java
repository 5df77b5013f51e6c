package org.dronewatch.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import me.tongfei.progressbar.DelegatingProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import org.junit.jupiter.api.Test;

/** How far a task is, in lines. */
class ProgressLinesTest {
    private static final long SECOND = 1_000_000_000L;

    private long now = 7 * SECOND;

    @Test
    void aLineEveryFiveSecondsStatesPercentAndTimeLeft() {
        StringWriter said = new StringWriter();
        ProgressLines lines = new ProgressLines("field", 400, new PrintWriter(said, true), () -> now);
        for (int second = 1; second <= 16; second++) {
            now += SECOND;
            lines.reached(10L * second);
        }
        now += 200 * SECOND;
        lines.reached(410);
        lines.ended();

        assertThat(said.toString().lines())
                .containsExactly(
                        "field: 12 % after 5 s",
                        "field: 25 %, 30 s left", "field: 37 %, 25 s left", "field: done after 4 min");
    }

    /** In a batch job, a long task shows that it is alive, and a short one says nothing. */
    @Test
    void aSignOfLifeIsASingleLineAfterHalfAMinute() {
        StringWriter said = new StringWriter();
        ProgressLines lines = ProgressLines.once("field", 2_000, new PrintWriter(said, true), () -> now);
        for (int second = 1; second <= 160; second++) {
            now += SECOND;
            lines.reached(10L * second);
            assertThat(said.toString().isEmpty()).isEqualTo(second < 30);
        }
        lines.ended();

        assertThat(said.toString().lines()).containsExactly("field: 15 % after 30 s");
    }

    /** Fifteen steps in five seconds, most of which went into preparations, say nothing about a hundred thousand. */
    @Test
    void noTimeIsEstimatedFromTheFirstSteps() {
        StringWriter said = new StringWriter();
        ProgressLines lines = new ProgressLines("field", 100_000, new PrintWriter(said, true), () -> now);
        now += 5 * SECOND;
        lines.reached(15);
        now += 5 * SECOND;
        lines.reached(1_000);

        assertThat(said.toString().lines()).containsExactly("field: less than 1 % after 5 s", "field: 1 % after 10 s");
    }

    /** A sensor whose cells take long comes first, and those of the next one hardly any time. */
    @Test
    void theTimeLeftFollowsFromTheSpeedOfTheSecondHalf() {
        StringWriter said = new StringWriter();
        ProgressLines lines = new ProgressLines("field", 1_000, new PrintWriter(said, true), () -> now);
        int done = 0;
        for (int second = 1; second <= 60; second++) {
            now += SECOND;
            done += second <= 30 ? 4 : 25;
            lines.reached(done);
        }

        assertThat(said.toString().lines())
                .contains("field: 12 % after 30 s", "field: 24 % after 35 s")
                .contains("field: 74 %, 11 s left", "field: 87 %, 5 s left");
    }

    /** Of a task that takes an hour, nobody waits for a quarter. */
    @Test
    void aLongTaskStatesTheTimeLeftAfterTwoMinutes() {
        StringWriter said = new StringWriter();
        ProgressLines lines = new ProgressLines("field", 1_200, new PrintWriter(said, true), () -> now);
        for (int second = 1; second <= 120; second++) {
            now += SECOND;
            lines.reached(second);
        }

        assertThat(said.toString().lines()).contains("field: 9 % after 2 min").endsWith("field: 10 %, 18 min left");
    }

    @Test
    void aBarStatesTheTimeThatItIsGiven() {
        List<String> drawn = new ArrayList<>();
        try (ProgressBar bar = Progress.builder("field", 100, state -> Optional.of(Duration.ofSeconds(5_025)))
                .setConsumer(new DelegatingProgressBarConsumer(drawn::add, 120))
                .build()) {
            bar.stepTo(40);
        }

        assertThat(drawn).anyMatch(line -> line.contains("1:23:45"));
    }

    /** Of four long steps, none ends in the second half of the time. */
    @Test
    void theLastEstimateHoldsUntilTheNextStepEnds() {
        TimeLeft left = new TimeLeft(4);
        for (int second = 1; second < 10; second++) {
            left.after(0, second);
        }

        assertThat(left.after(1, 15.0)).hasValue(24.0);
        assertThat(left.after(1, 25.0)).hasValue(48.0);
        assertThat(left.after(1, 31.0)).hasValue(42.0);
        assertThat(left.after(1, 80.0)).isEmpty();
        assertThat(left.after(2, 85.0)).hasValue(108.0);
    }

    @Test
    void theTimeLeftIsThatOfTheSecondHalf() {
        TimeLeft left = new TimeLeft(100);

        assertThat(left.after(20, Duration.ofSeconds(10))).isEmpty();
        assertThat(left.after(40, Duration.ofSeconds(20))).contains(Duration.ofSeconds(30));
        assertThat(left.after(40, Duration.ofSeconds(60))).isEmpty();
        assertThat(left.after(100, Duration.ofSeconds(70))).isEmpty();
        assertThat(new TimeLeft(-1).after(3, Duration.ofSeconds(1))).isEmpty();
    }
}
