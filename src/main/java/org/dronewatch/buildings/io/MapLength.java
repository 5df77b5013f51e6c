package org.dronewatch.buildings.io;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Lengths as maps state them: {@code 12}, {@code 12.5 m}, {@code 9,5}, {@code 40 ft}, {@code 39'4"}. */
public final class MapLength {
    private static final double FOOT = 0.3048;
    private static final double INCHES = 12.0;

    private static final Pattern METRES =
            Pattern.compile("(-?\\d{1,6}(?:[.,]\\d+)?)\\s*(?:m|metres|meters|metre|meter)?");
    private static final Pattern FEET = Pattern.compile(
            "(-?\\d{1,6}(?:[.,]\\d+)?)\\s*(?:ft|feet|foot|')\\s*(?:(\\d{1,2}(?:[.,]\\d+)?)\\s*(?:in|\"|''))?");

    private MapLength() {}

    /** A length in metres; empty if the text does not state one. */
    public static Optional<Double> parse(String text) {
        String plain = text.strip().toLowerCase(Locale.ROOT);
        Matcher metres = METRES.matcher(plain);
        if (metres.matches()) {
            return Optional.of(number(metres.group(1)));
        }
        Matcher feet = FEET.matcher(plain);
        if (feet.matches()) {
            double inches = feet.group(2) == null ? 0.0 : number(feet.group(2));
            return Optional.of(FOOT * (number(feet.group(1)) + inches / INCHES));
        }
        return Optional.empty();
    }

    private static double number(String text) {
        return Double.parseDouble(text.replace(',', '.'));
    }
}
