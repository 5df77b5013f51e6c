package org.dronewatch.sensor;

import java.util.List;
import java.util.Map;

/**
 * The texts about a kind of sensor, for reports.
 *
 * @param measures the quantity that its observations measure, as the label of an axis, such as {@code sound level}
 * @param weakness the words for a drone whose signal is insufficient, such as {@code too quiet}
 * @param leavesOut effects that the model of this sensor leaves out, in sentences for a report
 * @param ignoredConditions conditions of the site that would matter to a real sensor of this kind, but that its model
 *     does not take into account, each with advice for the user, such as
 *     {@code set its 'transmission' for such weather}. A scene that sets one of them gets a warning
 */
public record SensorDescription(
        String measures, String weakness, List<String> leavesOut, Map<Condition, String> ignoredConditions) {

    /** Copies the lists: later changes by the caller have no effect. */
    public SensorDescription {
        leavesOut = List.copyOf(leavesOut);
        ignoredConditions = Map.copyOf(ignoredConditions);
    }

    /**
     * The description of a sensor for which a drone with insufficient signal is reported as {@code signal too weak},
     * and whose model leaves out nothing worth mentioning.
     */
    public static SensorDescription measuring(String measures) {
        return new SensorDescription(measures, "signal too weak", List.of(), Map.of());
    }

    /** This description with other words for a drone whose signal is insufficient. */
    public SensorDescription withWeakness(String other) {
        return new SensorDescription(measures, other, leavesOut, ignoredConditions);
    }

    /** This description with sentences about what the model leaves out. */
    public SensorDescription withLeavesOut(String... sentences) {
        return new SensorDescription(measures, weakness, List.of(sentences), ignoredConditions);
    }

    /** This description with conditions that the model does not take into account, each with advice for the user. */
    public SensorDescription withIgnoredConditions(Map<Condition, String> others) {
        return new SensorDescription(measures, weakness, leavesOut, others);
    }
}
