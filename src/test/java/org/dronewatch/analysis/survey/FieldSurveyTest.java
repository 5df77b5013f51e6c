package org.dronewatch.analysis.survey;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.parallel.Workers;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A survey that is interrupted after any number of cells. */
class FieldSurveyTest {
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 380, 20, List.of(2.0, 26.0, 60.0));
    private static final int HEIGHT = 19 * 19;

    @TempDir
    private static Path directory;

    private static FieldRequest request;
    private static FieldSurvey whole;
    private static long looks;

    @BeforeAll
    static void survey() throws IOException {
        FieldSite site = FieldSite.in(directory, FieldSite.ROUND);
        request = new FieldRequest(
                site.settings(),
                site.stage(),
                FieldSite.DRONE,
                GRID,
                Course.all(site.settings().enabledSensors(), DetectionField.droneOf(site.stage(), FieldSite.DRONE)),
                FieldCoverage.Choice.BEST,
                FieldTerms.ONE_LOOK,
                0.5);
        AtomicLong done = new AtomicLong();
        whole = survey(done::addAndGet, () -> {});
        looks = done.get();
    }

    private static FieldSurvey survey(IntConsumer progress, Runnable stopped) {
        try (Workers workers = new Workers(2)) {
            return workers.call(() -> FieldSurvey.of(request, List.of(), progress, stopped));
        }
    }

    /** Interrupts the thread of the survey once so many cells have been looked at. */
    private static FieldSurvey interruptedAfter(long cells, AtomicInteger stops) {
        Thread caller = Thread.currentThread();
        AtomicLong done = new AtomicLong();
        IntConsumer interrupting = some -> {
            long now = done.addAndGet(some);
            if (now >= cells && now - some < cells) {
                caller.interrupt();
            }
        };
        return survey(interrupting, () -> {
            stops.incrementAndGet();
            assertThat(Thread.interrupted()).isTrue();
        });
    }

    @AfterEach
    void clear() {
        Thread.interrupted();
    }

    @Test
    void aSurveyThatIsNotInterruptedIsComplete() {
        assertThat(whole.isComplete()).isTrue();
        assertThat(looks).as("announced").isEqualTo(request.looks());
    }

    @Test
    void beforeTheFirstHeightIsWholeThereIsNothing() {
        assertThatThrownBy(() -> interruptedAfter(HEIGHT / 2, new AtomicInteger()))
                .isInstanceOf(CancellationException.class);
    }

    /** The heights that remain are those of the whole survey. */
    @Test
    void wholeHeightsRemain() {
        AtomicInteger stops = new AtomicInteger();
        FieldSurvey found = interruptedAfter(2 * HEIGHT + HEIGHT / 2, stops);
        assertThat(stops.get()).isOne();
        assertThat(found.isComplete()).isFalse();
        assertThat(found.hasAllHeights()).isFalse();
        assertThat(found.summary().heights()).hasSize(2);
        assertThat(found.visible()).isEmpty();
        assertThat(found.detectable()).isEmpty();
        assertThat(found.warnings()).isEmpty();
        for (int height = 0; height < 2; height++) {
            HeightSummary one = found.summary().heights().get(height);
            HeightSummary other = whole.summary().heights().get(height);
            assertThat(one.causes()).isEqualTo(other.causes());
            assertThat(one.covered()).isEqualTo(other.covered()).isPositive();
            assertThat(one.lost()).isEqualTo(other.lost());
            assertThat(one.gap()).isEqualTo(other.gap());
        }
        assertThat(Thread.currentThread().isInterrupted()).isFalse();
    }

    @Test
    void laterPartsAreLeftOut() {
        AtomicInteger stops = new AtomicInteger();
        FieldSurvey found = interruptedAfter(looks - 50, stops);
        assertThat(stops.get()).isOne();
        assertThat(found.hasAllHeights()).isTrue();
        assertThat(found.isComplete()).isFalse();
        assertThat(found.visible()).isPresent();
        assertThat(found.detectable()).isPresent();
        assertThat(found.warnings()).isEmpty();
        assertThat(found.detectable().orElseThrow().count(26.0))
                .isEqualTo(whole.detectable().orElseThrow().count(26.0));
    }
}
