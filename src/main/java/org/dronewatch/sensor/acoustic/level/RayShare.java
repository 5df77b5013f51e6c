package org.dronewatch.sensor.acoustic.level;

import java.util.Arrays;

/**
 * The fraction of single traced rays that were heard, and what it shows about a number of such rays in a look. Not
 * thread-safe.
 */
final class RayShare {
    /** The number of blocks of successive rays in which the rays that are heard are counted. */
    private static final int BLOCKS = 16;

    private final int number;
    private final int[] heardInBlock = new int[BLOCKS];
    private int blockSize = 1;
    private int traced;
    private int heard;

    /** The variance of the number of rays that are heard, as a fraction of the variance with independent directions. */
    private double evenness = 1.0;

    /**
     * A count in which no ray has been traced yet.
     *
     * @param number number of such rays in a look
     */
    RayShare(int number) {
        this.number = number;
    }

    void add(boolean isHeard) {
        int one = isHeard ? 1 : 0;
        heardInBlock[traced / blockSize] += one;
        heard += one;
        traced++;
        if (traced == BLOCKS * blockSize) {
            measureEvenness();
            mergeBlocks();
        }
    }

    /**
     * Measures how evenly the directions are spread. Blocks of successive directions are also spread evenly, but less
     * evenly than all directions together: the variance between blocks is an upper estimate.
     */
    private void measureEvenness() {
        double mean = (double) heard / BLOCKS;
        double squares = 0.0;
        for (int inBlock : heardInBlock) {
            squares += (inBlock - mean) * (inBlock - mean);
        }
        double between = squares * BLOCKS / (BLOCKS - 1);
        evenness = Math.min(1.0, between / (traced * likely() * (1.0 - likely())));
    }

    /** Merges each pair of blocks into one, so that further blocks are twice as long. */
    private void mergeBlocks() {
        for (int i = 0; i < BLOCKS / 2; i++) {
            heardInBlock[i] = heardInBlock[2 * i] + heardInBlock[2 * i + 1];
        }
        Arrays.fill(heardInBlock, BLOCKS / 2, BLOCKS, 0);
        blockSize *= 2;
    }

    int number() {
        return number;
    }

    int traced() {
        return traced;
    }

    /** The probability that all these rays of a look are missed, 0 to 1. */
    double missed() {
        return number == 0 || traced == 0 ? 1.0 : Math.pow(1.0 - (double) heard / traced, number);
    }

    /**
     * An upper estimate of the variance of the logarithm of that probability. The degree to which the directions are
     * spread more evenly than independent ones is measured whenever the number of traced rays has doubled. The variance
     * is never 0 if there are any rays: the number of rays that are heard is not taken to be more accurate than one
     * ray.
     */
    double variance() {
        if (number == 0 || traced == 0) {
            return 0.0;
        }
        double likely = likely();
        double heardVariance = Math.max(1.0, evenness * traced * likely * (1.0 - likely));
        double missed = traced * (1.0 - likely);
        return (double) number * number * heardVariance / (missed * missed);
    }

    /** The probability that a ray is heard, with a uniform prior. */
    private double likely() {
        return (heard + 1.0) / (traced + 2.0);
    }
}
