package org.dronewatch.report.file;

import java.math.BigDecimal;
import java.math.RoundingMode;

/** Numbers as files show them: at most six decimal places, no exponent, no trailing zeros. */
public final class Numbers {
    private static final int DECIMALS = 6;

    private Numbers() {}

    /** The rounded number as text. */
    public static String text(double value) {
        return Double.isFinite(value) ? rounded(value).toPlainString() : Double.toString(value);
    }

    /** The rounded number. */
    public static BigDecimal rounded(double value) {
        BigDecimal rounded = BigDecimal.valueOf(value).setScale(DECIMALS, RoundingMode.HALF_EVEN);
        BigDecimal shortest = rounded.stripTrailingZeros();
        return shortest.scale() < 0 ? shortest.setScale(0) : shortest;
    }
}
