package org.dronewatch.sensor.acoustic.level;

import java.util.random.RandomGenerator;

/**
 * Pairs of numbers that are spread evenly over the unit square, from a random start: the fraction of the pairs that lie
 * in a shape drawn in the square approaches its area much faster than with independent numbers. The additive recurrence
 * with the powers of 1/1.32471795724474602596, the root of {@code x^3 = x + 1} (Roberts 2018, "R2").
 */
final class EvenPairs implements RandomGenerator {
    private static final long FIRST = 0xC13FA9A902A6328FL;
    private static final long SECOND = 0x91E10DA5C79E7B1DL;

    private long first;
    private long second;
    private boolean isSecond;

    EvenPairs(RandomGenerator random) {
        first = random.nextLong();
        second = random.nextLong();
    }

    @Override
    public long nextLong() {
        isSecond = !isSecond;
        if (isSecond) {
            first += FIRST;
            return first;
        }
        second += SECOND;
        return second;
    }
}
