package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.jupiter.api.Test;

/** What a campaign says of its progress where it cannot draw a bar. */
class CaseProgressTest {
    private static final long SECOND = 1_000_000_000L;

    private final StringWriter said = new StringWriter();
    private long now = 5 * SECOND;

    private CaseProgress progress(int all) {
        return new CaseProgress(all, new PrintWriter(said, true), null, () -> now);
    }

    @Test
    void aLineEveryTenSecondsStatesRateAndTimeLeft() {
        CaseProgress progress = progress(10_000);
        for (int second = 1; second <= 25; second++) {
            now += SECOND;
            progress.ran(40);
        }

        assertThat(said.toString().lines())
                .containsExactly(
                        "400 of 10,000 cases, 40.0 per second, 4 min left",
                        "800 of 10,000 cases, 40.0 per second, 4 min left");
    }

    @Test
    void casesOfAnEarlierRunDoNotCountForTheRate() {
        CaseProgress progress = progress(9_000);
        progress.kept(8_000);
        now += 20 * SECOND;
        progress.ran(100);

        assertThat(said.toString().strip()).isEqualTo("8,100 of 9,000 cases, 5.00 per second, 3 min left");
    }

    @Test
    void longTimesAreInHoursAndShortOnesInSeconds() {
        CaseProgress progress = progress(1000);
        now += 10 * SECOND;
        progress.ran(1);
        now += 10 * SECOND;
        progress.ran(899);

        assertThat(said.toString().lines())
                .containsExactly(
                        "1 of 1,000 cases, 0.100 per second, 2 h 47 min left",
                        "900 of 1,000 cases, 45.0 per second, 2 s left");
    }
}
