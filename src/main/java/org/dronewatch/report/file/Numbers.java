package org.dronewatch.report.file;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;

/** Numbers as files show them: at most six decimal places, no exponent, no trailing zeros. */
public final class Numbers {
    private static final int DECIMALS = 6;

    /** The greatest area that is stated in m2. */
    private static final double SMALL_AREA = 1000.0;

    private static final int AREA_DIGITS = 3;
    private static final double HECTARES = 1e-4;

    private Numbers() {}

    /** The rounded number as text. */
    public static String text(double value) {
        return Double.isFinite(value) ? rounded(value).toPlainString() : Double.toString(value);
    }

    /** An area in hectares; in m2 if it is less than a tenth of a hectare. */
    public static String area(double squareMetres) {
        return squareMetres < SMALL_AREA
                ? text(BigDecimal.valueOf(squareMetres)
                                .round(new MathContext(AREA_DIGITS))
                                .doubleValue()) + " m2"
                : String.format(Locale.ROOT, "%.2f ha", HECTARES * squareMetres);
    }

    /** The rounded number. */
    public static BigDecimal rounded(double value) {
        BigDecimal rounded = BigDecimal.valueOf(value).setScale(DECIMALS, RoundingMode.HALF_EVEN);
        BigDecimal shortest = rounded.stripTrailingZeros();
        return shortest.scale() < 0 ? shortest.setScale(0) : shortest;
    }
}
