package org.dronewatch.positioner;

import org.dronewatch.geometry.Position;

/**
 * An alpha-beta filter: a vector is corrected by {@code alpha} times the difference between its measured value and its
 * predicted one, and its rate by {@code beta} times that difference divided by the time since the previous measurement,
 * with {@code beta = alpha^2 / (2 - alpha)} (Benedict and Bordner 1962).
 */
final class AlphaBeta {
    private static final double ALPHA = 0.5;
    private static final double BETA = ALPHA * ALPHA / (2.0 - ALPHA);
    private static final Position REST = new Position(0, 0, 0);

    private Position value;
    private Position rate = REST;
    private double time;

    AlphaBeta(Position first, double time) {
        this.value = first;
        this.time = time;
    }

    /**
     * Takes the value measured at a time, s; if that is not later than the time of the last measurement, the measured
     * value replaces the filtered one.
     */
    void add(Position measured, double at) {
        double since = at - time;
        if (since > 0.0) {
            Position expected = at(at);
            Position difference = measured.minus(expected);
            value = expected.plus(difference.times(ALPHA));
            rate = rate.plus(difference.times(BETA / since));
        } else {
            value = measured;
        }
        time = at;
    }

    /** The prediction for a time, s. */
    Position at(double when) {
        return value.plus(rate.times(when - time));
    }

    /** The time at which the last measurement was taken, s. */
    double time() {
        return time;
    }
}
