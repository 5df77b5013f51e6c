package org.dronewatch.analysis.cell;

/**
 * A {@link Margin} as a number of twelve bits: two for what is known, ten for a number of tenths of a decibel. A value
 * keeps its sign: a margin just below 0 is not rounded to 0. A value that is too large for the bits becomes a bound.
 */
public final class MarginCode {
    /** The bits of a number. */
    public static final int BITS = 12;

    /** Steps of a value. */
    static final int PER_DB = 10;

    /** Nothing is known. */
    public static final int NOTHING = 0;

    /** There is no signal. */
    public static final int NO_SIGNAL = 1;

    private static final int MOST = 511;
    private static final int TENTHS = (1 << 10) - 1;
    private static final int VALUE = 1 << 10;
    private static final int AT_LEAST = 2 << 10;
    private static final int AT_MOST = 3 << 10;

    private MarginCode() {}

    /** The number for a margin, dB. */
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

    /** The number for a margin that is at least this, dB. */
    public static int atLeast(double db) {
        double tenths = PER_DB * Math.floor(db);
        return tenths >= -MOST ? code(AT_LEAST, (int) Math.min(MOST, tenths)) : NOTHING;
    }

    /** The number for a margin that is at most this, dB. */
    public static int atMost(double db) {
        if (db == Double.NEGATIVE_INFINITY) {
            return NO_SIGNAL;
        }
        double tenths = PER_DB * Math.ceil(db);
        return tenths <= MOST ? code(AT_MOST, (int) Math.max(-MOST, tenths)) : NOTHING;
    }

    /**
     * The number for a margin between two, dB: their value if both have the same, otherwise the tighter bound.
     *
     * @param isDetected whether the drone is detected: then the lower bound says more
     */
    public static int between(double least, double greatest, boolean isDetected) {
        int lowest = of(least);
        return lowest == of(greatest) ? lowest : isDetected ? atLeast(least) : atMost(greatest);
    }

    private static int code(int kind, int tenths) {
        return kind | tenths + MOST;
    }

    /** The margin that a number represents. */
    public static Margin margin(int code) {
        double db = (double) ((code & TENTHS) - MOST) / PER_DB;
        return switch (code & ~TENTHS) {
            case VALUE -> new Margin(Margin.Known.VALUE, db);
            case AT_LEAST -> new Margin(Margin.Known.AT_LEAST, db);
            case AT_MOST -> new Margin(Margin.Known.AT_MOST, db);
            default -> new Margin(code == NO_SIGNAL ? Margin.Known.NO_SIGNAL : Margin.Known.NOTHING, 0.0);
        };
    }

    /** Whether a number of twelve bits is such a code. */
    public static boolean isPossible(int code) {
        return code < VALUE ? code <= NO_SIGNAL : (code & TENTHS) <= 2 * MOST;
    }
}
