package org.dronewatch.report.html.run;

import org.dronewatch.drone.Drone;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.setting.Choices;

/** Describes in words why a sensor misses a drone. */
final class CauseWords {
    private CauseWords() {}

    /**
     * The cause in words, such as {@code hidden by hill.obj}, without its {@link Evidence}.
     *
     * @param drone the missed drone
     * @param weak the words for a drone whose signal is insufficient
     */
    static String of(Explanation explanation, Drone drone, String weak) {
        return switch (explanation.cause()) {
            case UNKNOWN -> "unknown: the line of sight leaves the known ground";
            case OUT_OF_RANGE -> "out of range";
            case OUT_OF_VIEW -> "out of its field of view";
            case SILENT -> silent(drone.settings().radio());
            case TOO_SLOW -> "too slow for the sensor";
            case TOO_FAST -> "too fast for the sensor";
            case HIDDEN_BY_TERRAIN, HIDDEN_BY_BUILDING, HIDDEN_BY_VEGETATION, HIDDEN_BY_OTHER ->
                "hidden by " + explanation.obstacle().orElseThrow().model().file();
            case TOO_WEAK, DETECTED -> weak;
        };
    }

    private static String silent(RadioLink link) {
        return link.emits()
                ? "without an emission that the receiver can recognise"
                : "radio-silent (" + Choices.name(link.control().name()) + ")";
    }
}
