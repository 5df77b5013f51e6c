package org.dronewatch.analysis.cell;

import org.dronewatch.sensor.Cause;

/**
 * What a field keeps of an assessment, as a three-byte number: its probability as a {@link ProbabilityStep step}, its
 * cause, and its {@link MarginCode margin}.
 */
public final class CellCode {
    /** The size of a code, bytes. */
    public static final int BYTES = 3;

    private static final Cause[] CAUSES = Cause.values();
    private static final int CAUSE_SHIFT = 8;
    private static final int MARGIN_SHIFT = 12;
    private static final int STEP_BITS = (1 << CAUSE_SHIFT) - 1;
    private static final int CAUSE_BITS = (1 << MARGIN_SHIFT - CAUSE_SHIFT) - 1;

    private CellCode() {}

    /** The code for the step of a probability, a cause, and a {@link MarginCode}. */
    public static int of(int step, Cause cause, int margin) {
        return step | cause.ordinal() << CAUSE_SHIFT | margin << MARGIN_SHIFT;
    }

    /** The {@link ProbabilityStep step} of the probability in a code. */
    public static int step(int code) {
        return code & STEP_BITS;
    }

    /** The cause in a code. */
    public static Cause cause(int code) {
        return CAUSES[code >> CAUSE_SHIFT & CAUSE_BITS];
    }

    /** The margin in a code. */
    public static Margin margin(int code) {
        return MarginCode.margin(code >> MARGIN_SHIFT);
    }

    /** Whether a non-negative number is a valid code. */
    public static boolean isPossible(int code) {
        return (code >> CAUSE_SHIFT & CAUSE_BITS) < CAUSES.length
                && code >> MARGIN_SHIFT + MarginCode.BITS == 0
                && MarginCode.isPossible(code >> MARGIN_SHIFT);
    }
}
