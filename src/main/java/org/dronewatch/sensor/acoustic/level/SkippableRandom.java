package org.dronewatch.sensor.acoustic.level;

import java.util.random.RandomGenerator;

/**
 * The numbers of a {@link java.util.SplittableRandom} of the same seed, of which any number can be skipped at once:
 * SplitMix64 (Steele, Lea and Flood 2014), whose state grows by the same step with each number.
 */
final class SkippableRandom implements RandomGenerator {
    private static final long STEP = 0x9E3779B97F4A7C15L;

    private long state;

    SkippableRandom(long seed) {
        state = seed;
    }

    @Override
    public long nextLong() {
        state += STEP;
        long z = (state ^ state >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }

    /** Skips some numbers. */
    void skip(int count) {
        state += STEP * count;
    }

    /** Skips some numbers of a generator: at once if it is a generator of this class. */
    static void skip(RandomGenerator random, int count) {
        if (random instanceof SkippableRandom skippable) {
            skippable.skip(count);
        } else {
            for (int i = 0; i < count; i++) {
                random.nextLong();
            }
        }
    }
}
