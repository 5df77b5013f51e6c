package org.dronewatch.viewer.part;

import java.util.Locale;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.WorldSettings;

/** Texts of the viewer: numbers, positions, problems. */
public final class Texts {
    private Texts() {}

    /** A position, m. */
    public static String place(Position position) {
        return String.format(
                Locale.ROOT,
                "east %.1f m, north %.1f m, up %.1f m",
                tenths(position.x()),
                tenths(position.y()),
                tenths(position.z()));
    }

    /** A length to be written with one decimal, m: nothing is written as -0.0. */
    private static double tenths(double metres) {
        return Math.rint(10.0 * metres) / 10.0 + 0.0;
    }

    /** A position, m, with its latitude and longitude if the site has a geographic origin. */
    public static String place(Position position, WorldSettings site) {
        if (site.origin().isEmpty()) {
            return place(position);
        }
        Origin origin = site.origin().get();
        GeoPoint there = new Geodesy(origin).onEarth(position);
        boolean aboveTheSea = origin.height().isPresent() || site.terrain().isPresent();
        return String.format(
                Locale.ROOT,
                "%s; %.6f\u00b0 %s, %.6f\u00b0 %s%s",
                place(position),
                Math.abs(there.latitude()),
                there.latitude() < 0.0 ? "S" : "N",
                Math.abs(there.longitude()),
                there.longitude() < 0.0 ? "W" : "E",
                aboveTheSea ? String.format(Locale.ROOT, ", %.1f m above sea level", there.height()) : "");
    }

    /** A description of a problem, in one line. */
    public static String problem(Throwable problem) {
        if (problem instanceof InputException) {
            return problem.getMessage();
        }
        return problem instanceof OutOfMemoryError
                ? "not enough memory to render this view"
                : "internal error: " + problem;
    }

    /** A time in s, such as {@code 12.50 s} or, from one minute on, {@code 1:05.00}. */
    public static String time(double seconds) {
        int minutes = (int) (seconds / 60.0);
        return minutes == 0
                ? String.format(Locale.ROOT, "%.2f s", seconds)
                : String.format(Locale.ROOT, "%d:%05.2f", minutes, seconds - 60.0 * minutes);
    }

    /**
     * A measured value. A magnitude below 10 is shown with two decimals, one from 10 to below 1000 with one decimal;
     * larger ones and whole numbers are shown without decimals, infinities in words.
     */
    public static String value(double value) {
        if (value == Double.NEGATIVE_INFINITY) {
            return "none";
        }
        // An observer could find the drone, but has not yet.
        if (value == Double.POSITIVE_INFINITY) {
            return "more search time";
        }
        double size = Math.abs(value);
        if (size >= 1000.0 || value == Math.rint(value)) {
            return String.format(Locale.ROOT, "%.0f", value);
        }
        return String.format(Locale.ROOT, size < 10.0 ? "%.2f" : "%.1f", value);
    }

    /** A measured value with its unit; infinities in words, without a unit. */
    public static String measured(double value, String unit) {
        if (value == Double.NEGATIVE_INFINITY) {
            return "no signal";
        }
        return value == Double.POSITIVE_INFINITY ? value(value) : (value(value) + " " + unit).strip();
    }

    /** A playback speed. */
    public static String speed(double factor) {
        return factor == Double.POSITIVE_INFINITY
                ? "as fast as possible"
                : String.format(Locale.ROOT, factor < 1.0 ? "%.2g x" : "%.0f x", factor);
    }
}
