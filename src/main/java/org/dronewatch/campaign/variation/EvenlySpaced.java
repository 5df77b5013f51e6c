package org.dronewatch.campaign.variation;

import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * Evenly spaced values, each with the same probability: specified by their number, or by the step from each value to
 * the next.
 *
 * @param from the least value
 * @param to the greatest value; with {@code step}, values are no greater than this
 * @param count number of values, including the first and the last, 2 to 10,000
 * @param step distance from each value to the next, above 0
 */
public record EvenlySpaced(
        String from,
        String to,
        @In(value = Quantity.NUMBER, from = 2, to = Variation.MOST_VALUES) Optional<Integer> count,
        Optional<String> step) {
    /** A last value that rounding puts this fraction of a step beyond the limit is meant to be there. */
    private static final double ROUNDING = 1e-9;

    /** Checks the limits. */
    public EvenlySpaced {
        Check.present("count", count);
        Check.present("step", step);
        Limits.check(EvenlySpaced.class, from, to, count, step);
    }

    /** Limits, without a spacing. */
    @Defaults({"from", "to"})
    static EvenlySpaced of(String from, String to) {
        return new EvenlySpaced(from, to, Optional.empty(), Optional.empty());
    }

    /**
     * Checks that the spacing is stated exactly once.
     *
     * @throws IllegalArgumentException when it is not stated, or twice
     */
    void check() {
        if (count.isPresent() == step.isPresent()) {
            throw new IllegalArgumentException(
                    "range needs either count or step; it has " + (count.isPresent() ? "both" : "neither"));
        }
    }

    DoubleUnaryOperator inverse(Quantity quantity) {
        double low = Variation.parsed("from", quantity, from);
        double high = Variation.parsed("to", quantity, to);
        Variation.requireOrder("from", low, "to", high);
        if (count.isPresent()) {
            int last = count.get() - 1;
            return u -> low + (high - low) * (int) (u * (last + 1)) / last;
        }
        double distance = distance(quantity);
        int values = number(high - low, distance);
        return u -> Math.min(high, low + distance * (int) (u * values));
    }

    private double distance(Quantity quantity) {
        // A step of 5 degC is 5 K.
        Quantity difference = quantity == Quantity.TEMPERATURE ? Quantity.TEMPERATURE_DIFFERENCE : quantity;
        double distance = Variation.parsed("step", difference, step.orElseThrow());
        if (!(distance > 0.0)) {
            throw new IllegalArgumentException("step " + distance + " must be above 0");
        }
        return distance;
    }

    private static int number(double width, double distance) {
        double steps = Math.floor(width / distance + ROUNDING);
        if (steps < 1.0) {
            throw new IllegalArgumentException(
                    "step " + distance + " must be at most " + width + ", the difference between 'from' and 'to'");
        }
        if (steps >= Variation.MOST_VALUES) {
            throw new IllegalArgumentException(
                    "step " + distance + " gives too many values; it must give at most 10,000");
        }
        return (int) steps + 1;
    }
}
