package org.dronewatch.report.html;

import java.util.DoubleSummaryStatistics;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;

/** Number formats for the report. */
public final class ReadableNumbers {
    /** Shown in tables where there is no value. */
    public static final String NONE = "-";

    private ReadableNumbers() {}

    /** A number with one decimal place; with none if it is whole, or if its magnitude is 100 or more. */
    public static String number(double value) {
        return Math.abs(value) >= 100.0 || value == Math.rint(value) ? format("%.0f", value) : format("%.1f", value);
    }

    /** A number with its unit; one without a unit is a probability, shown in percent. */
    public static String measured(double value, String unit) {
        if (!unit.isEmpty()) {
            return number(value) + " " + unit;
        }
        double percent = 100.0 * value;
        return percent < 0.1 ? "less than 0.1 %" : format(percent < 10.0 ? "%.1f %%" : "%.0f %%", percent);
    }

    /** A value with one decimal place, or a word where there is no value. */
    public static String orElse(OptionalDouble value, String none) {
        return value.isPresent() ? format("%.1f", value.getAsDouble()) : none;
    }

    /**
     * The smallest and the largest of some values, with one decimal place: {@code 3.0 to 7.5}, or only {@code 3.0} if
     * both are the same; a dash if there are no values.
     */
    public static String range(DoubleStream values) {
        DoubleSummaryStatistics all = values.summaryStatistics();
        if (all.getCount() == 0) {
            return NONE;
        }
        String least = format("%.1f", all.getMin());
        String greatest = format("%.1f", all.getMax());
        return least.equals(greatest) ? least : least + " to " + greatest;
    }

    /** Formats values as {@link String#format(String, Object...)} does, independently of the locale. */
    public static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
