package org.dronewatch.parallel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WorkersTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5})
    void everyNumberIsDoneOnceAlsoInLoopsWithinLoops(int threads) {
        AtomicIntegerArray done = new AtomicIntegerArray(50 * 40);
        try (Workers workers = new Workers(threads)) {
            workers.call(() -> {
                Workers.forEach(50, i -> Workers.forEach(40, j -> done.incrementAndGet(40 * i + j)));
                return null;
            });
        }
        for (int i = 0; i < done.length(); i++) {
            assertThat(done.get(i)).isEqualTo(1);
        }
    }

    /** Each waits for the other: on one thread this would never end. */
    @Test
    void twoThreadsWorkAtTheSameTime() {
        CountDownLatch both = new CountDownLatch(2);
        Runnable meet = () -> {
            both.countDown();
            try {
                assertThat(both.await(20, TimeUnit.SECONDS)).isTrue();
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        };
        try (Workers workers = new Workers(2)) {
            workers.call(() -> {
                Workers.both(meet, meet);
                return null;
            });
        }
    }

    @Test
    void withoutWorkersTheCallerDoesAll() {
        Thread caller = Thread.currentThread();
        AtomicInteger others = new AtomicInteger();
        Workers.forEach(100, i -> others.addAndGet(Thread.currentThread() == caller ? 0 : 1));
        assertThat(others).hasValue(0);
        assertThat(Workers.available()).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void aFailureReachesTheCallerAndEndsTheLoop(int threads) {
        AtomicInteger begun = new AtomicInteger();
        Assertions.assertTimeoutPreemptively(Duration.ofMinutes(1), () -> {
            try (Workers workers = new Workers(threads)) {
                assertThatThrownBy(() -> workers.call(() -> {
                            Workers.forEach(1_000_000, i -> {
                                begun.incrementAndGet();
                                if (i == 5) {
                                    throw new IllegalArgumentException("the sixth");
                                }
                            });
                            return null;
                        }))
                        .isInstanceOf(IllegalArgumentException.class)
                        .hasMessage("the sixth");
            }
        });
        assertThat(begun.get()).isLessThan(1_000_000);
    }

    @Test
    void eachThreadHasItsOwnScratchMemory() {
        AtomicInteger made = new AtomicInteger();
        try (Workers workers = new Workers(3)) {
            workers.call(() -> {
                Workers.forEach(
                        1000,
                        () -> {
                            made.incrementAndGet();
                            return Thread.currentThread();
                        },
                        (own, i) -> assertThat(own).isSameAs(Thread.currentThread()));
                return null;
            });
        }
        assertThat(made.get()).isBetween(1, 3);
    }

    @Test
    void noThreadsAreNoWorkers() {
        assertThatThrownBy(() -> new Workers(0)).hasMessage("threads 0 must be 1 to 1024");
    }
}
