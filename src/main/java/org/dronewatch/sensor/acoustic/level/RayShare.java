package org.dronewatch.sensor.acoustic.level;

/**
 * Single rays that were traced, and how many of them were heard: what that says about a number of such rays in a look.
 * Not thread-safe.
 */
final class RayShare {
    private final int number;
    private int traced;
    private int heard;

    /**
     * No ray has been traced yet.
     *
     * @param number how many such rays a look has
     */
    RayShare(int number) {
        this.number = number;
    }

    void add(boolean isHeard) {
        traced++;
        heard += isHeard ? 1 : 0;
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
     * The variance of the logarithm of that probability, if the directions of rays were independent; with a uniform
     * prior, so that it is never 0 if there are any.
     */
    double variance() {
        if (number == 0 || traced == 0) {
            return 0.0;
        }
        double likely = (heard + 1.0) / (traced + 2.0);
        return (double) number * number * likely / (traced * (1.0 - likely));
    }
}
