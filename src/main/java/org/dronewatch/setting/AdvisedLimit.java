package org.dronewatch.setting;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** An upper limit in a message, rounded so that a user who enters exactly that value stays within the limit. */
public final class AdvisedLimit {
    private static final MathContext DOWN = new MathContext(3, RoundingMode.FLOOR);

    /**
     * A limit that differs from a round number only by the rounding errors of its computation counts as that number.
     */
    private static final double ROUNDING = 1e-12;

    private AdvisedLimit() {}

    /**
     * The limit rounded down to three significant digits, such as {@code 0.0333} for 1/30. A limit that is a round
     * number except for rounding errors gives that number, which may exceed the limit by up to 1e-12 of its value.
     *
     * @param limit the limit, finite
     */
    public static String inWords(double limit) {
        BigDecimal rounded = new BigDecimal(limit + ROUNDING * Math.abs(limit)).round(DOWN);
        return Quantity.NUMBER.inWords(rounded.doubleValue());
    }
}
