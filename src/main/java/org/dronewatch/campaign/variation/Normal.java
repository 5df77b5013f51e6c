package org.dronewatch.campaign.variation;

import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.numbers.gamma.Erfc;
import org.apache.commons.numbers.gamma.InverseErfc;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Quantity;

/**
 * Normally distributed values, truncated at the limits.
 *
 * @param mean mean of the distribution before truncation
 * @param deviation standard deviation before truncation, above 0
 * @param from the least value; without it, five standard deviations below the mean
 * @param to the greatest value; without it, five standard deviations above the mean
 */
public record Normal(String mean, String deviation, Optional<String> from, Optional<String> to) {
    /** Beyond this many standard deviations there is one value in 1.7 million. */
    private static final double FARTHEST = 5.0;

    private static final double ROOT = Math.sqrt(2.0);

    /** Checks that nothing is missing. */
    public Normal {
        Check.present("from", from);
        Check.present("to", to);
    }

    /** A distribution with the default limits. */
    @Defaults({"mean", "deviation"})
    public static Normal of(String mean, String deviation) {
        return new Normal(mean, deviation, Optional.empty(), Optional.empty());
    }

    DoubleUnaryOperator inverse(Quantity quantity) {
        double middle = Variation.parsed("mean", quantity, mean);
        double width = Variation.parsed("deviation", quantity, deviation);
        if (!(width > 0.0)) {
            throw new IllegalArgumentException("deviation " + width + " must be above 0");
        }
        double low = from.map(text -> Variation.parsed("from", quantity, text)).orElse(middle - FARTHEST * width);
        double high = to.map(text -> Variation.parsed("to", quantity, text)).orElse(middle + FARTHEST * width);
        Variation.requireOrder("from", low, "to", high);
        if (!Double.isFinite(low) || !Double.isFinite(high)) {
            throw new IllegalArgumentException("mean " + middle + " and deviation " + width
                    + " give values too large for a number; set smaller ones, or set 'from' and 'to'");
        }
        // Beyond the mean, probabilities near 1 have no digits left: the other tail, mirrored, has them all.
        boolean isMirrored = low > middle;
        double side = isMirrored ? -1.0 : 1.0;
        double near = cumulative(side * (low - middle) / width);
        double far = cumulative(side * (high - middle) / width);
        if (near == far) {
            throw new IllegalArgumentException("'from' " + low + " and 'to' " + high + " leave out all of the normal"
                    + " distribution with mean " + middle + " and deviation " + width);
        }
        // Rounding in the inverse must not carry a value past a limit.
        return u -> Math.max(low, Math.min(high, middle + side * width * quantile(near + (far - near) * u)));
    }

    private static double cumulative(double z) {
        return 0.5 * Erfc.value(-z / ROOT);
    }

    private static double quantile(double p) {
        return -ROOT * InverseErfc.value(2.0 * p);
    }
}
