package org.dronewatch.analysis.cell;

/**
 * The margin by which the signal of a sensor exceeds its threshold in a cell, in the form in which a field keeps it.
 * Most cells are decided by bounds on the signal, which cost less than the signal itself; in these cells, only a bound
 * on the margin is known. An estimated margin counts as a value.
 *
 * @param kind what is known
 * @param db the value or the bound, from -51.1 to 51.1 dB: values in steps of 0.1 dB, bounds in steps of 1 dB; 0 for
 *     other kinds. Signals in other units are also compared in dB: {@code 10 lg(quantity / threshold)}
 */
public record Margin(Known kind, double db) {
    /** What is known of a margin. */
    public enum Known {
        /** Nothing: the drone cannot be there, or the line of sight leaves the known ground. */
        NOTHING,
        /** It is known that nothing reaches the sensor. */
        NO_SIGNAL,
        /** A value, to 0.1 dB. */
        VALUE,
        /** A lower bound. */
        AT_LEAST,
        /** An upper bound. */
        AT_MOST
    }

    /** The lowest margin that is possible, dB. */
    public double least() {
        return switch (kind) {
            case VALUE -> db - 1.0 / MarginCode.PER_DB;
            case AT_LEAST -> db;
            case NOTHING, NO_SIGNAL, AT_MOST -> Double.NEGATIVE_INFINITY;
        };
    }

    /** The highest margin that is possible, dB. */
    public double greatest() {
        return switch (kind) {
            case VALUE -> db + 1.0 / MarginCode.PER_DB;
            case AT_MOST -> db;
            case NO_SIGNAL -> Double.NEGATIVE_INFINITY;
            case NOTHING, AT_LEAST -> Double.POSITIVE_INFINITY;
        };
    }
}
