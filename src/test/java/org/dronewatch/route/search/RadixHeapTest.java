package org.dronewatch.route.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class RadixHeapTest {
    @Test
    void numbersComeOutOfTheQueueInTheOrderOfTheirKeys() {
        long seed = 4714;
        SplittableRandom random = new SplittableRandom(seed);
        RadixHeap heap = new RadixHeap();
        double[] keys = new double[20_000];
        int added = 0;
        double last = 0.0;
        for (int i = 0; added < keys.length || !heap.isEmpty(); i++) {
            if (added < keys.length && (heap.isEmpty() || random.nextInt(3) > 0)) {
                keys[added] = last + (random.nextInt(5) == 0 ? 0.0 : random.nextDouble());
                heap.add(keys[added], added++);
            } else {
                int out = heap.poll();
                assertThat(heap.key())
                        .as("seed %d, step %d", seed, i)
                        .isEqualTo(keys[out])
                        .isGreaterThanOrEqualTo(last);
                last = heap.key();
            }
        }
    }
}
