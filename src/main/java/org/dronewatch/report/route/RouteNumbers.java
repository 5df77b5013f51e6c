package org.dronewatch.report.route;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.Locale;
import java.util.OptionalDouble;
import org.dronewatch.report.html.ReadableNumbers;

/** The form of the numbers of routes: times, probabilities and exposures. */
final class RouteNumbers {
    private RouteNumbers() {}

    /** The time left, compared with the response: {@code 14 s late}; a dash without a detection. */
    static String margin(OptionalDouble left, double response) {
        if (left.isEmpty()) {
            return "-";
        }
        double margin = tenths(left.getAsDouble() - response);
        return number(Math.abs(margin)) + (margin < 0.0 ? " s late" : " s early");
    }

    /** A time, {@code 14.2 s}; a dash if there is none. */
    static String seconds(OptionalDouble time) {
        return time.isPresent() ? number(tenths(time.getAsDouble())) + " s" : "-";
    }

    /** A probability or a fraction in percent, {@code 54 %}; {@code < 0.1 %} where it is lower, but not 0. */
    static String percent(double share) {
        return share == 0.0 ? "0 %" : isRare(share) ? "< 0.1 %" : ReadableNumbers.measured(share, "");
    }

    /** Whether a probability is printed as less than 0.1 %. */
    static boolean isRare(double probability) {
        return probability < 0.001;
    }

    /** A probability in percent, or a dash where there is none. */
    static String orDash(OptionalDouble probability) {
        return probability.isPresent() ? percent(probability.getAsDouble()) : "-";
    }

    /** An exposure. */
    static String exposure(double value) {
        return value == 0.0
                ? "0"
                : value < 0.001 ? "< 0.001" : String.format(Locale.ROOT, value < 1.0 ? "%.3f" : "%.2f", value);
    }

    /** A value to a tenth; never -0. */
    static double tenths(double value) {
        return Math.rint(10.0 * value) / 10.0 + 0.0;
    }
}
