package org.dronewatch.mesh.io;

/**
 * Reads decimal numbers as they are usually written, without an exponent and with few digits, exactly as Java's own
 * methods do, but without an object for each.
 */
final class PlainDecimal {
    /** An integer of this many digits is one that a double holds exactly. */
    static final int MOST_DIGITS = 15;

    /** The powers of ten by which an integer is divided: a double holds each of them exactly. */
    private static final double[] POWERS = new double[MOST_DIGITS + 1];

    /** The bits of a double that a float lacks, and their value halfway between two floats. */
    private static final long BELOW_A_FLOAT = (1L << 29) - 1;

    private static final long HALFWAY = 1L << 28;

    static {
        POWERS[0] = 1.0;
        for (int i = 1; i < POWERS.length; i++) {
            POWERS[i] = 10.0 * POWERS[i - 1];
        }
    }

    private PlainDecimal() {}

    /**
     * The number in a part of a text: the double nearest to it, as by {@link Double#parseDouble}.
     *
     * @return NaN if it is not written in digits, with a sign or a point or without, or has more than 15 digits
     */
    static double read(char[] text, int start, int end) {
        int at = start;
        boolean isNegative = at < end && text[at] == '-';
        if (isNegative || at < end && text[at] == '+') {
            at++;
        }
        long digits = 0;
        int count = 0;
        int point = -1;
        for (; at < end; at++) {
            char c = text[at];
            if (c >= '0' && c <= '9') {
                digits = 10 * digits + (c - '0');
                count++;
            } else if (c == '.' && point < 0) {
                point = at;
            } else {
                return Double.NaN;
            }
        }
        if (count == 0 || count > MOST_DIGITS) {
            return Double.NaN;
        }
        // Both are exact, so that the quotient is rounded once.
        double size = point < 0 ? digits : digits / POWERS[end - point - 1];
        return isNegative ? -size : size;
    }

    /**
     * Whether the float nearest to what was read is the one nearest to the double: not where the double lies halfway
     * between two floats, since the number may lie on either side of it.
     *
     * @param number from {@link #read}
     */
    static boolean isSafeAsFloat(double number) {
        return (Double.doubleToRawLongBits(number) & BELOW_A_FLOAT) != HALFWAY;
    }
}
