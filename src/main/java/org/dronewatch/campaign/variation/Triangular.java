package org.dronewatch.campaign.variation;

import java.util.function.DoubleUnaryOperator;
import org.dronewatch.setting.Quantity;

/**
 * Values whose density rises linearly from 0 at the least value to the mode, and falls linearly to 0 at the greatest.
 *
 * @param from the least value
 * @param mode the likeliest value, {@code from} to {@code to}
 * @param to the greatest value
 */
public record Triangular(String from, String mode, String to) {
    DoubleUnaryOperator inverse(Quantity quantity) {
        double low = Variation.parsed("from", quantity, from);
        double likeliest = Variation.parsed("mode", quantity, mode);
        double high = Variation.parsed("to", quantity, to);
        Variation.requireOrder("from", low, "to", high);
        if (likeliest < low || likeliest > high) {
            throw new IllegalArgumentException("mode " + likeliest + " must be " + low + " to " + high);
        }
        double below = (likeliest - low) / (high - low);
        return u -> u < below
                ? low + Math.sqrt(u * (high - low) * (likeliest - low))
                : high - Math.sqrt((1.0 - u) * (high - low) * (high - likeliest));
    }
}
