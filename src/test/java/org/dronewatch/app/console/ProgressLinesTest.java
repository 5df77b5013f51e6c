package org.dronewatch.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.jupiter.api.Test;

/** How far a task is, in lines. */
class ProgressLinesTest {
    private static final long SECOND = 1_000_000_000L;

    private long now = 7 * SECOND;

    @Test
    void aLineEveryFiveSecondsStatesPercentAndTimeLeft() {
        StringWriter said = new StringWriter();
        ProgressLines lines = new ProgressLines("field", 2_000, new PrintWriter(said, true), () -> now);
        for (int second = 1; second <= 16; second++) {
            now += SECOND;
            lines.reached(10L * second);
        }
        now += 200 * SECOND;
        lines.reached(2_100);
        lines.ended();

        assertThat(said.toString().lines())
                .containsExactly(
                        "field: 2 %, 3 min left",
                        "field: 5 %, 3 min left", "field: 7 %, 3 min left", "field: done after 4 min");
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

        assertThat(said.toString().lines()).containsExactly("field: 15 %, 3 min left");
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

        assertThat(said.toString().lines())
                .containsExactly("field: less than 1 % after 5 s", "field: 1 %, 17 min left");
    }
}
