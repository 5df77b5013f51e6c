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
            case SILENT -> silent(drone.settings().radio(), explanation);
            case TOO_SLOW -> "too slow for the sensor";
            case TOO_FAST -> "too fast for the sensor";
            case HIDDEN_BY_TERRAIN, HIDDEN_BY_BUILDING, HIDDEN_BY_VEGETATION, HIDDEN_BY_OTHER ->
                "hidden by " + explanation.obstacle().orElseThrow().model().file();
            case TOO_WEAK, DETECTED -> weak;
        };
    }

    private static String silent(RadioLink link, Explanation explanation) {
        if (!link.emits()) {
            return "radio-silent (" + Choices.name(link.control().name()) + ")";
        }
        return explanation.limit().isPresent()
                ? "transmitting outside the receiver's frequency range"
                : "without an emission that the receiver can recognise";
    }
}
