package org.dronewatch.analysis.cell;

import org.dronewatch.sensor.Cause;

/**
 * What is kept of an assessment, as a number of three bytes: its probability in steps of 1/250, where 0 and 250 mean
 * exactly 0 and 1, its cause, and its {@link MarginCode margin}.
 */
public final class CellCode {
    /** The bytes of a number. */
    public static final int BYTES = 3;

    /** The steps of a probability. */
    public static final int STEPS = 250;

    private static final Cause[] CAUSES = Cause.values();
    private static final int CAUSE_SHIFT = 8;
    private static final int MARGIN_SHIFT = 12;
    private static final int STEP_BITS = (1 << CAUSE_SHIFT) - 1;
    private static final int CAUSE_BITS = (1 << MARGIN_SHIFT - CAUSE_SHIFT) - 1;

    private CellCode() {}

    /** The number for a probability in steps, a cause, and a {@link MarginCode}. */
    public static int of(int steps, Cause cause, int margin) {
        return steps | cause.ordinal() << CAUSE_SHIFT | margin << MARGIN_SHIFT;
    }

    /** The probability in steps. */
    public static int steps(int code) {
        return code & STEP_BITS;
    }

    /** The cause. */
    public static Cause cause(int code) {
        return CAUSES[code >> CAUSE_SHIFT & CAUSE_BITS];
    }

    /** The margin. */
    public static Margin margin(int code) {
        return MarginCode.margin(code >> MARGIN_SHIFT);
    }

    /** Whether a number that is not negative is such a code. */
    public static boolean isPossible(int code) {
        return (code & STEP_BITS) <= STEPS
                && (code >> CAUSE_SHIFT & CAUSE_BITS) < CAUSES.length
                && code >> MARGIN_SHIFT + MarginCode.BITS == 0
                && MarginCode.isPossible(code >> MARGIN_SHIFT);
    }

    /** The lowest threshold at which a sensor covers a cell, in steps of a probability. */
    public static int stepsToCover(double covered) {
        return (int) Math.ceil(covered * STEPS - 1e-9);
    }

    /** A probability in steps of 1/250: 0 and 250 for exactly 0 and 1 alone. */
    public static int steps(double probability) {
        if (probability <= 0.0 || probability >= 1.0) {
            return probability <= 0.0 ? 0 : STEPS;
        }
        return Math.max(1, Math.min(STEPS - 1, (int) Math.rint(STEPS * probability)));
    }
}
