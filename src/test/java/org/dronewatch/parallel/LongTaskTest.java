package org.dronewatch.parallel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Who hears of long tasks. */
class LongTaskTest {
    private final List<String> lines = new ArrayList<>();
    private final List<String> shown = new ArrayList<>();

    private final LongTask.Watcher watcher = new LongTask.Watcher() {
        @Override
        public void started(String what, long steps) {
            shown.add(what + " of " + steps);
        }

        @Override
        public synchronized void advanced(long steps) {
            shown.add(String.valueOf(steps));
        }

        @Override
        public void ended() {
            shown.add("ended");
        }
    };

    @AfterEach
    void watchNothing() {
        LongTask.watch(null);
    }

    private void work(String what, long steps, boolean isLong, int times, long each) {
        try (LongTask task = LongTask.begin(what, steps, isLong, lines::add)) {
            for (int i = 0; i < times; i++) {
                task.advance(each);
            }
        }
    }

    @Test
    void withoutAWatcherOneLineAnnouncesALongTask() {
        work("reading", 100, true, 100, 1);
        work("something short", 100, false, 100, 1);

        assertThat(lines).containsExactly("reading ...");
    }

    @Test
    void aWatcherIsShownWhatIsLong() {
        LongTask.watch(watcher);
        work("reading", 4, true, 2, 2);
        work("something short", 100, false, 100, 1);

        assertThat(shown).containsExactly("reading of 4", "2", "4", "ended");
        assertThat(lines).isEmpty();
        LongTask.watch(null);
        work("reading", 4, true, 2, 2);
        assertThat(lines).containsExactly("reading ...");
    }

    /** However many steps there are, on however many threads. */
    @Test
    void reportsAreFew() {
        LongTask.watch(watcher);
        try (Workers workers = new Workers(4);
                LongTask task = LongTask.begin("building", 1_000_000, true, lines::add)) {
            workers.call(() -> {
                Workers.forEach(1000, i -> {
                    for (int k = 0; k < 1000; k++) {
                        task.advance(0.5);
                        task.advance(0.5);
                    }
                });
                return null;
            });
        }
        assertThat(shown).hasSize(500 + 2).contains("2000", "1000000");

        shown.clear();
        work("thinning out", -1, true, 10_000, 1);
        assertThat(shown).containsExactly("thinning out of -1", "4096", "8192", "ended");
    }

    @Test
    void aTaskThatFailsHasEndedToo() {
        LongTask.watch(watcher);

        assertThatThrownBy(() -> fail("failed")).hasMessage("failed");
        assertThat(shown).containsExactly("failing of 10", "ended");
    }

    private void fail(String message) {
        try (LongTask task = LongTask.begin("failing", 10, true, lines::add)) {
            task.advance(0);
            throw new IllegalStateException(message);
        }
    }
}
