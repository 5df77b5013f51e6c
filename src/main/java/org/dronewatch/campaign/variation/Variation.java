package org.dronewatch.campaign.variation;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Stream;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Quantity;

/**
 * How a setting varies from case to case: exactly one of the components is given. Values are written as in a scene
 * file, with a unit or without.
 *
 * @param values 1 to 10,000 values, each with the same probability
 * @param range evenly spaced values, each with the same probability
 * @param uniform any value in a range, with a uniform distribution
 * @param normal normally distributed values, within a range
 * @param triangular values likeliest at a mode, with a density that falls linearly to either side
 */
public record Variation(
        Optional<List<String>> values,
        Optional<EvenlySpaced> range,
        Optional<Uniform> uniform,
        Optional<Normal> normal,
        Optional<Triangular> triangular) {
    /** A variation in which nothing is stated yet. */
    @Defaults
    static final Variation NONE =
            new Variation(Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty());

    /** The largest number of values that can be listed, or evenly spaced. */
    static final int MOST_VALUES = 10_000;

    private static final MathContext WRITTEN = new MathContext(10);

    /** Copies the list. */
    public Variation {
        values = Check.present("values", values).map(List::copyOf);
        Check.present("range", range);
        Check.present("uniform", uniform);
        Check.present("normal", normal);
        Check.present("triangular", triangular);
    }

    /** Any value in a range, all equally likely. */
    public static Variation of(Uniform uniform) {
        return new Variation(
                Optional.empty(), Optional.empty(), Optional.of(uniform), Optional.empty(), Optional.empty());
    }

    /**
     * Checks that there is exactly one distribution.
     *
     * @throws IllegalArgumentException when there is none, or several
     */
    public void check() {
        long given = Stream.of(values, range, uniform, normal, triangular)
                .filter(Optional::isPresent)
                .count();
        if (given != 1) {
            throw new IllegalArgumentException(
                    "needs exactly one of values, range, uniform, normal and triangular; it has " + given);
        }
        range.ifPresent(EvenlySpaced::check);
        int listed = values.map(List::size).orElse(1);
        if (listed < 1 || listed > MOST_VALUES) {
            throw new IllegalArgumentException("values has " + listed + " entries but must have 1 to 10,000");
        }
    }

    /**
     * The value of the setting that corresponds to a random number, as in a scene file: the inverse of the cumulative
     * distribution at that number.
     *
     * @param quantity what the setting is measured in
     * @param u random number, 0 or more and below 1
     * @throws IllegalArgumentException when a parameter is not a value of the quantity, or contradicts the others
     */
    public String value(Quantity quantity, double u) {
        return values.map(all -> all.get((int) (u * all.size())))
                .orElseGet(() -> written(quantity, distribution(quantity).applyAsDouble(u)));
    }

    /**
     * Values, written as in a scene file, by which to check that all values suit the setting: the listed ones, or the
     * least and the greatest.
     */
    public List<String> extremes(Quantity quantity) {
        return values.orElseGet(() -> List.of(value(quantity, 0.0), value(quantity, Math.nextDown(1.0))));
    }

    /** The inverse of the cumulative distribution. */
    private DoubleUnaryOperator distribution(Quantity quantity) {
        return range.map(one -> one.inverse(quantity))
                .or(() -> uniform.map(one -> one.inverse(quantity)))
                .or(() -> normal.map(one -> one.inverse(quantity)))
                .or(() -> triangular.map(one -> one.inverse(quantity)))
                .orElseThrow();
    }

    /** A value with its unit, and with as many digits as are needed to repeat a case by hand. */
    private static String written(Quantity quantity, double value) {
        // Angles are the only ones shown in a unit other than that in which they are kept.
        double shown = quantity.unit().equals(quantity.displayUnit()) ? value : Math.toDegrees(value);
        BigDecimal rounded = new BigDecimal(shown).round(WRITTEN).stripTrailingZeros();
        return (rounded.toPlainString() + " " + quantity.displayUnit()).strip();
    }

    static double parsed(String name, Quantity quantity, String text) {
        try {
            return quantity.parse(text);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(name + ": " + e.getMessage(), e);
        }
    }

    static void requireOrder(String low, double lower, String high, double upper) {
        if (!(lower < upper)) {
            throw new IllegalArgumentException("'" + low + "' " + lower + " must be below '" + high + "' " + upper);
        }
    }
}
