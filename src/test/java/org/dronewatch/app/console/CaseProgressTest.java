package org.dronewatch.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/** What a campaign says of its progress where it cannot draw a bar. */
class CaseProgressTest {
    private static final long SECOND = 1_000_000_000L;

    private final StringWriter said = new StringWriter();
    private long now = 5 * SECOND;

    private CaseProgress progress(int all) {
        return new CaseProgress(all, new PrintWriter(said, true), left -> null, false, () -> now);
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
        now += 2 * SECOND;
        progress.ran(40);
        now += 12 * SECOND;
        progress.ran(60);

        assertThat(said.toString().strip()).isEqualTo("8,100 of 9,000 cases, 5.00 per second, 3 min left");
    }

    /** Most of a campaign is kept at once, which says nothing about the rest. */
    @Test
    void aBarStatesTheTimeThatCasesTakeWhichAreNotKept() {
        List<Supplier<Optional<Duration>>> bar = new ArrayList<>();
        CaseProgress progress = new CaseProgress(
                9_000,
                new PrintWriter(said, true),
                left -> {
                    bar.add(left);
                    return null;
                },
                false,
                () -> now);
        progress.kept(8_000);
        now += 2 * SECOND;
        assertThat(bar.get(0).get()).isEmpty();
        progress.ran(40);
        now += 12 * SECOND;
        progress.ran(60);

        assertThat(bar.get(0).get()).contains(Duration.ofSeconds(180));
        now += 30 * SECOND;
        assertThat(bar.get(0).get()).contains(Duration.ofSeconds(150));
        now += 150 * SECOND;
        assertThat(bar.get(0).get()).isEmpty();
    }

    /** Nine seconds for the site, one for each of the cases. */
    @Test
    void whatTheSiteTakesDoesNotCountForTheRate() {
        CaseProgress progress = progress(100);
        now += 9 * SECOND;
        for (int second = 0; second < 12; second++) {
            now += SECOND;
            progress.ran(1);
        }

        assertThat(said.toString().lines())
                .containsExactly("1 of 100 cases", "11 of 100 cases, 1.00 per second, 1 min left");
    }

    @Test
    void longTimesAreInHoursAndShortOnesInSeconds() {
        CaseProgress progress = progress(2000);
        now += SECOND;
        progress.ran(1);
        now += 100 * SECOND;
        progress.ran(10);
        now += 4 * SECOND;
        progress.ran(1);
        now += 6 * SECOND;
        progress.ran(1888);

        assertThat(said.toString().lines())
                .containsExactly(
                        "11 of 2,000 cases, 0.100 per second, 5 h 32 min left",
                        "1,900 of 2,000 cases, 17.3 per second, 6 s left");
    }
}
