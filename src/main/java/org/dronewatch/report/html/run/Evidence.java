package org.dronewatch.report.html.run;

import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Explanation;

/**
 * What was found at all the instants at which one reason for a miss held: the materials that hid the drone, and the
 * limits that it violated. The limit of radial speed of a radar with a notch depends on the strength of the echo, so
 * that a single reason may have many.
 */
final class Evidence {
    private final Set<String> materials = new TreeSet<>();
    private Cause cause = Cause.UNKNOWN;
    private double least = Double.POSITIVE_INFINITY;
    private double greatest = Double.NEGATIVE_INFINITY;

    /** Adds one instant. */
    void add(Explanation explanation) {
        cause = explanation.cause();
        explanation.obstacle().ifPresent(obstacle -> materials.add(obstacle.material()));
        explanation.limit().ifPresent(limit -> {
            least = Math.min(least, limit);
            greatest = Math.max(greatest, limit);
        });
    }

    /** The evidence in parentheses, to follow the words of the reason; empty if there is none. */
    String inWords() {
        if (cause.isHidden()) {
            return " (" + String.join(", ", materials) + ")";
        }
        if (greatest < least) {
            return "";
        }
        return switch (cause) {
            case TOO_SLOW -> " (radial speed below " + range("%.1f") + " m/s)";
            case TOO_FAST -> " (radial speed above " + range("%.0f") + " m/s)";
            default -> "";
        };
    }

    private String range(String pattern) {
        String from = String.format(Locale.ROOT, pattern, least);
        String to = String.format(Locale.ROOT, pattern, greatest);
        return from.equals(to) ? from : from + " to " + to;
    }
}
