package org.dronewatch.viewer;

import java.util.Locale;
import org.dronewatch.geometry.Position;

/** Number formats of the viewer. */
final class Texts {
    private Texts() {}

    /** A position, m. */
    static String place(Position position) {
        return String.format(
                Locale.ROOT, "east %.1f m, north %.1f m, up %.1f m", position.x(), position.y(), position.z());
    }

    /** A time, s. */
    static String time(double seconds) {
        int minutes = (int) (seconds / 60.0);
        return minutes == 0
                ? String.format(Locale.ROOT, "%.2f s", seconds)
                : String.format(Locale.ROOT, "%d:%05.2f", minutes, seconds - 60.0 * minutes);
    }

    /** A measured value with three digits, or as a whole number; infinities in words. */
    static String value(double value) {
        if (value == Double.NEGATIVE_INFINITY) {
            return "none";
        }
        double size = Math.abs(value);
        if (size >= 1000.0 || value == Math.rint(value)) {
            return String.format(Locale.ROOT, "%.0f", value);
        }
        return String.format(Locale.ROOT, size < 10.0 ? "%.2f" : "%.1f", value);
    }

    /** A measured value with its unit; in words where there was no signal at all. */
    static String measured(double value, String unit) {
        return value == Double.NEGATIVE_INFINITY ? "no signal" : (value(value) + " " + unit).strip();
    }

    /** A speed of playing. */
    static String speed(double factor) {
        return factor == Double.POSITIVE_INFINITY
                ? "as fast as possible"
                : String.format(Locale.ROOT, factor < 1.0 ? "%.2g x" : "%.0f x", factor);
    }
}
