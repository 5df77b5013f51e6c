package org.dronewatch.report.html;

import java.util.Locale;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.setting.Choices;

/** Says in words why a sensor misses a drone. */
final class CauseWords {
    private CauseWords() {}

    /**
     * The cause in words, such as {@code hidden by hill.obj}.
     *
     * @param drone that is missed
     * @param weak what is said of a drone of which the sensor has too little
     */
    static String of(Explanation explanation, Drone drone, String weak) {
        return switch (explanation.cause()) {
            case OUT_OF_RANGE -> "out of range";
            case OUT_OF_VIEW -> "out of its field of view";
            case SILENT -> silent(drone.settings().radio());
            case TOO_SLOW -> "too slow for it" + limit(explanation, " (radial speed below %.1f m/s)");
            case TOO_FAST -> "too fast for it" + limit(explanation, " (radial speed above %.0f m/s)");
            case HIDDEN_BY_TERRAIN, HIDDEN_BY_BUILDING, HIDDEN_BY_VEGETATION, HIDDEN_BY_OTHER ->
                "hidden by " + explanation.obstacle().orElseThrow().model().file();
            case TOO_WEAK, DETECTED -> weak;
        };
    }

    private static String silent(RadioLink link) {
        return link.emits()
                ? "radio-silent on the frequencies that it receives"
                : "radio-silent (" + Choices.name(link.control().name()) + ")";
    }

    private static String limit(Explanation explanation, String pattern) {
        return explanation.limit().isPresent()
                ? String.format(Locale.ROOT, pattern, explanation.limit().getAsDouble())
                : "";
    }
}
