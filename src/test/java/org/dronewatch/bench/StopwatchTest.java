package org.dronewatch.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;

/** Measuring works in turn. */
class StopwatchTest {
    @Test
    void worksAreWarmBeforeAnyIsMeasuredAndThenTakeTurns() {
        StringBuilder done = new StringBuilder();
        Runnable first = () -> done.append('a');
        Runnable second = () -> done.append('b');
        // Warmed up for no time: once each. Then three runs of each, since that was long work.
        new Stopwatch(0, 9).secondsInTurn(List.of(first, second));
        assertThat(done).hasToString("ab" + "ababab");
    }

    @Test
    void shortWorkIsDoneManyTimesInARun() {
        int[] done = new int[1];
        new Stopwatch(20_000_000L, 9).seconds(() -> done[0]++);
        assertThat(done[0]).isGreaterThan(1000);
    }

    /** A run is 5, 1 and 3 ms long, not counting that of the warm-up: the median is the last. */
    @Test
    void theMedianIsTold() {
        List<Integer> milliseconds = new ArrayList<>(List.of(0, 5, 1, 3));
        double seconds = new Stopwatch(0, 9).seconds(() -> pause(milliseconds.remove(0)));
        assertThat(milliseconds).isEmpty();
        assertThat(seconds).isCloseTo(3e-3, within(1.9e-3));
    }

    private static void pause(int milliseconds) {
        long end = System.nanoTime() + milliseconds * 1_000_000L;
        while (System.nanoTime() < end) {
            LockSupport.parkNanos(end - System.nanoTime());
        }
    }
}
