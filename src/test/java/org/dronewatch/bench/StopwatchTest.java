package org.dronewatch.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Measuring works in turn, by a clock that only works move on. */
class StopwatchTest {
    private static final long MS = 1_000_000L;

    private long now;
    private final StringBuilder done = new StringBuilder();

    private Stopwatch watch(long warmUp) {
        return new Stopwatch(warmUp, 9, () -> now);
    }

    private Runnable work(char name, long duration) {
        return () -> {
            done.append(name);
            now += duration;
        };
    }

    @Test
    void worksAreWarmBeforeAnyIsMeasuredAndThenTakeTurns() {
        // Both take longer than the warm-up, so three runs are enough.
        double[] seconds = watch(5 * MS).secondsInTurn(List.of(work('a', 6 * MS), work('b', 8 * MS)));
        assertThat(done).hasToString("ab" + "ababab");
        assertThat(seconds).containsExactly(0.006, 0.008);
    }

    /** 2 ms for a warm-up of 200 ms: a hundred times to warm up, then nine runs of five times, 10 ms. */
    @Test
    void shortWorkIsDoneManyTimesInARun() {
        double seconds = watch(200 * MS).seconds(work('a', 2 * MS));
        assertThat(seconds).isEqualTo(0.002);
        assertThat(done).hasSize(100 + 9 * 5);
    }

    /** Runs of 5, 1 and 3 ms, after one to warm up. */
    @Test
    void theMedianIsTold() {
        List<Integer> milliseconds = new ArrayList<>(List.of(1, 5, 1, 3));
        double seconds = watch(0).seconds(() -> now += MS * milliseconds.remove(0));
        assertThat(milliseconds).isEmpty();
        assertThat(seconds).isEqualTo(0.003);
    }
}
