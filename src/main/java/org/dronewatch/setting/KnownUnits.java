package org.dronewatch.setting;

import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The units accepted for each quantity, the most useful first, and their synonyms. */
final class KnownUnits {
    private static final Map<Quantity, List<String>> UNITS = Map.ofEntries(
            Map.entry(Quantity.LENGTH, List.of("m", "km", "cm", "mm", "ft", "mi", "NM")),
            Map.entry(Quantity.ANGLE, List.of("deg", "rad")),
            Map.entry(Quantity.ANGULAR_SPEED, List.of("deg/s", "rad/s")),
            Map.entry(Quantity.DURATION, List.of("s", "ms", "min", "h", "day")),
            Map.entry(Quantity.SPEED, List.of("m/s", "km/h", "kt", "mi/h", "ft/s")),
            Map.entry(Quantity.ACCELERATION, List.of("m/s2", "g")),
            Map.entry(Quantity.FREQUENCY, List.of("Hz", "kHz", "MHz", "GHz")),
            Map.entry(Quantity.AREA, List.of("m2")),
            Map.entry(Quantity.TEMPERATURE, List.of("K", "degC", "degF")),
            Map.entry(Quantity.TEMPERATURE_DIFFERENCE, List.of("K")),
            Map.entry(Quantity.PRESSURE, List.of("Pa", "hPa", "kPa", "bar", "atm")),
            Map.entry(Quantity.MASS, List.of("kg", "g", "t", "lb")),
            Map.entry(Quantity.POWER, List.of("W", "mW", "kW", "MW")),
            Map.entry(Quantity.RATIO, List.of("%")));

    /** Other words for a speed: none of them is a unit of anything else that a setting takes. */
    private static final Map<String, String> SPEEDS = Map.of(
            "kmh", "km/h", "kph", "km/h", "kmph", "km/h", "mph", "mi/h", "mps", "m/s", "kn", "kt", "kts", "kt", "knot",
            "kt", "knots", "kt");

    private KnownUnits() {}

    /** The units of a quantity; only that of a bare number if there are no others. */
    static List<String> of(Quantity quantity) {
        return UNITS.getOrDefault(quantity, quantity.unit().isEmpty() ? List.of() : List.of(quantity.unit()));
    }

    /** The unit denoted by a word; the word itself if it is not a synonym of a unit. */
    static String meant(Quantity quantity, String written) {
        return quantity == Quantity.SPEED ? SPEEDS.getOrDefault(written.toLowerCase(Locale.ROOT), written) : written;
    }

    /** All units of a quantity for a message, with the one that was perhaps meant; empty for a plain number. */
    static String hint(Quantity quantity, String written) {
        List<String> units = of(quantity);
        if (units.isEmpty()) {
            return "";
        }
        String nearest = Spelling.nearest(written, units, 1).get(0);
        boolean near = letters(nearest).equals(letters(written)) || written.length() > 1 && isOneOff(written, nearest);
        return " (known units: " + String.join(", ", units) + ")" + (near ? "; did you mean '" + nearest + "'?" : "");
    }

    private static String letters(String unit) {
        return unit.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]", "");
    }

    /** Whether two words differ only by one letter too many or too few. */
    private static boolean isOneOff(String a, String b) {
        String longer = a.length() > b.length() ? a : b;
        String shorter = a.length() > b.length() ? b : a;
        if (longer.length() != shorter.length() + 1) {
            return false;
        }
        for (int i = 0; i < longer.length(); i++) {
            if ((longer.substring(0, i) + longer.substring(i + 1)).equals(shorter)) {
                return true;
            }
        }
        return false;
    }
}
