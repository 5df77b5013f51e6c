package org.dronewatch.report.html.run;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Explanation;

/**
 * What was found at all the instants at which one reason for a miss held: the buildings and materials that hid the
 * drone, and the limits that it violated. The limit of radial speed of a radar with a notch depends on the strength of
 * the echo, so that a single reason may come with many limits.
 */
final class Evidence {
    private static final int MOST_BUILDINGS = 3;

    private final Set<String> materials = new TreeSet<>();

    /** The number of instants at which each building of the map hid the drone, by its name. */
    private final Map<String, Integer> buildings = new LinkedHashMap<>();

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

    /** Adds a building of the map that hid the drone at one instant. */
    void addBuilding(String name) {
        buildings.merge(name, 1, Integer::sum);
    }

    /** The evidence in parentheses, to follow the words of the reason; empty if there is none. */
    String inWords() {
        if (cause.isHidden()) {
            return " (" + (buildings.isEmpty() ? "" : buildings() + "; ") + String.join(", ", materials) + ")";
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

    /** The buildings that hid the drone for the longest time. */
    private String buildings() {
        List<Map.Entry<String, Integer>> sorted = new ArrayList<>(buildings.entrySet());
        sorted.sort(Map.Entry.comparingByValue(Comparator.reverseOrder()));
        return sorted.stream().limit(MOST_BUILDINGS).map(Map.Entry::getKey).collect(Collectors.joining(", "))
                + (sorted.size() > MOST_BUILDINGS ? " and others" : "");
    }

    private String range(String pattern) {
        String from = String.format(Locale.ROOT, pattern, least);
        String to = String.format(Locale.ROOT, pattern, greatest);
        return from.equals(to) ? from : from + " to " + to;
    }
}
