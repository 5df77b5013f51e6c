package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLong;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.parallel.LongTask;
import org.dronewatch.parallel.Workers;
import org.junit.jupiter.api.Test;

/** How far a tree has grown. */
class GrowthReportTest {
    /** Each triangle counts once, however many leaves it is in, and however many threads place it. */
    @Test
    void growthIsReportedToItsEnd() {
        TriangleMesh mesh = TreePartsTest.mesh(6000, new SplittableRandom(6));
        AtomicLong last = new AtomicLong();
        LongTask.watch(new LongTask.Watcher() {
            @Override
            public void started(String what, long steps) {
                assertThat(steps).isEqualTo(6000);
            }

            @Override
            public void advanced(long steps) {
                last.accumulateAndGet(steps, Math::max);
            }

            @Override
            public void ended() {
                last.addAndGet(1_000_000);
            }
        });
        try (Workers workers = new Workers(3);
                LongTask task = LongTask.begin("building", 6000, true, line -> {})) {
            workers.call(() -> KDTree.of(mesh, SahCost.DEFAULT, task));
        } finally {
            LongTask.watch(null);
        }
        assertThat(last.get()).isBetween(1_005_980L, 1_006_000L);
    }
}
