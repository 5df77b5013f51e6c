package org.dronewatch.campaign.variation;

import java.util.function.DoubleUnaryOperator;
import org.dronewatch.setting.Quantity;

/**
 * Any value in a range, all equally likely.
 *
 * @param from the least value
 * @param to the upper limit; all values are below it
 */
public record Uniform(String from, String to) {
    DoubleUnaryOperator inverse(Quantity quantity) {
        double low = Variation.parsed("from", quantity, from);
        double high = Variation.parsed("to", quantity, to);
        Variation.requireOrder("from", low, "to", high);
        return u -> low + (high - low) * u;
    }
}
