package org.dronewatch.analysis.cell;

/**
 * A {@link Margin} as a twelve-bit number: two bits for what is known, ten for a number of tenths of a decibel. A value
 * keeps its sign: a margin just below 0 is not rounded to 0. A value that is too large for the bits becomes a bound.
 */
public final class MarginCode {
    /** The size of a code, bits. */
    public static final int BITS = 12;

    /** Steps of a value. */
    static final int PER_DB = 10;

    /** The code for a margin of which nothing is known. */
    public static final int NOTHING = 0;

    /** The code for the absence of a signal. */
    public static final int NO_SIGNAL = 1;

    private static final int MOST = 511;
    private static final int TENTHS = (1 << 10) - 1;
    private static final int VALUE = 1 << 10;
    private static final int AT_LEAST = 2 << 10;
    private static final int AT_MOST = 3 << 10;

    private MarginCode() {}

    /** The code for a margin, dB; NaN if nothing is known of it, negative infinity if there is no signal. */
    public static int of(double db) {
        if (Double.isNaN(db) || db == Double.NEGATIVE_INFINITY) {
            return Double.isNaN(db) ? NOTHING : NO_SIGNAL;
        }
        double tenths = db < 0.0 ? Math.min(-1.0, Math.rint(PER_DB * db)) : Math.rint(PER_DB * db);
        if (Math.abs(tenths) > MOST) {
            return tenths > 0.0 ? code(AT_LEAST, MOST) : code(AT_MOST, -MOST);
        }
        return code(VALUE, (int) tenths);
    }

    /** The code for a margin of at least the given value, dB. */
    public static int atLeast(double db) {
        double tenths = PER_DB * Math.floor(db);
        return tenths >= -MOST ? code(AT_LEAST, (int) Math.min(MOST, tenths)) : NOTHING;
    }

    /** The code for a margin of at most the given value, dB. */
    public static int atMost(double db) {
        if (db == Double.NEGATIVE_INFINITY) {
            return NO_SIGNAL;
        }
        double tenths = PER_DB * Math.ceil(db);
        return tenths <= MOST ? code(AT_MOST, (int) Math.max(-MOST, tenths)) : NOTHING;
    }

    /**
     * The code for a margin between two bounds, dB: the code of both if it is the same, otherwise the code for one of
     * them.
     *
     * @param isDetected whether the drone is detected: then the lower bound is kept, otherwise the upper one
     */
    public static int between(double least, double greatest, boolean isDetected) {
        int lowest = of(least);
        return lowest == of(greatest) ? lowest : isDetected ? atLeast(least) : atMost(greatest);
    }

    private static int code(int kind, int tenths) {
        return kind | tenths + MOST;
    }

    /** The margin that a code represents. */
    public static Margin margin(int code) {
        double db = (double) ((code & TENTHS) - MOST) / PER_DB;
        return switch (code & ~TENTHS) {
            case VALUE -> new Margin(Margin.Known.VALUE, db);
            case AT_LEAST -> new Margin(Margin.Known.AT_LEAST, db);
            case AT_MOST -> new Margin(Margin.Known.AT_MOST, db);
            default -> new Margin(code == NO_SIGNAL ? Margin.Known.NO_SIGNAL : Margin.Known.NOTHING, 0.0);
        };
    }

    /** Whether a twelve-bit number is a valid code. */
    public static boolean isPossible(int code) {
        return code < VALUE ? code <= NO_SIGNAL : (code & TENTHS) <= 2 * MOST;
    }
}
