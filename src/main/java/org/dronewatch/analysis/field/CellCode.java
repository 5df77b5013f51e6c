package org.dronewatch.analysis.field;

import org.dronewatch.sensor.Cause;

/**
 * What is kept of an assessment, as a number of two bytes: its probability in steps of 1/250, where 0 and 250 mean
 * exactly 0 and 1, and its cause.
 */
final class CellCode {
    /** The steps of a probability. */
    static final int STEPS = 250;

    private static final Cause[] CAUSES = Cause.values();
    private static final int CAUSE_SHIFT = 8;
    private static final int BYTE = 0xFF;

    private CellCode() {}

    /** The number for a probability in steps and a cause. */
    static int of(int steps, Cause cause) {
        return steps | cause.ordinal() << CAUSE_SHIFT;
    }

    /** The probability in steps. */
    static int steps(int code) {
        return code & BYTE;
    }

    /** The cause. */
    static Cause cause(int code) {
        return CAUSES[code >> CAUSE_SHIFT];
    }

    /** The number at a place in an array of bytes. */
    static int at(byte[] pool, int at) {
        return pool[at] & BYTE | (pool[at + 1] & BYTE) << CAUSE_SHIFT;
    }

    /** Writes a number to a place in an array of bytes. */
    static void put(byte[] pool, int at, int code) {
        pool[at] = (byte) code;
        pool[at + 1] = (byte) (code >> CAUSE_SHIFT);
    }

    /** Whether an entry, and what it points to, can be those of a cell on a number of courses. */
    static boolean isPossible(int entry, byte[] pool, int courses) {
        if (entry >= 0) {
            return isPossible(entry);
        }
        long at = -1L - entry;
        if (at + 2L * courses > pool.length) {
            return false;
        }
        for (int course = 0; course < courses; course++) {
            if (!isPossible(at(pool, (int) at + 2 * course))) {
                return false;
            }
        }
        return true;
    }

    private static boolean isPossible(int code) {
        return (code & BYTE) <= STEPS && code >> CAUSE_SHIFT < CAUSES.length;
    }

    /** The least number of steps of a probability with which a sensor covers a cell. */
    static int stepsToCover(double covered) {
        return (int) Math.ceil(covered * STEPS - 1e-9);
    }

    /** A probability in steps of 1/250: 0 and 250 for exactly 0 and 1 alone. */
    static int steps(double probability) {
        if (probability <= 0.0 || probability >= 1.0) {
            return probability <= 0.0 ? 0 : STEPS;
        }
        return Math.max(1, Math.min(STEPS - 1, (int) Math.rint(STEPS * probability)));
    }
}
