package org.dronewatch.run;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.fusion.Alert;

/**
 * The false alarms of one run, which no drone caused.
 *
 * @param counted how many each sensor raised, by name; one that lasts counts once, and a bird each time that the sensor
 *     begins to detect it
 * @param alertCount how many false alerts followed from them by the scene's rule
 * @param alerts these alerts in order of time, the first {@link #MOST_ALERTS} of them at most
 * @param birds the alerts among them that were birds, by the bird's name
 * @param trials when each drone's alert would have been raised with other confirmations; none in a scene whose sensors
 *     state no rate of false alarms
 */
public record FalseAlarmResult(
        Map<String, Long> counted,
        long alertCount,
        List<Alert> alerts,
        Map<String, Alert> birds,
        List<ConfirmationTrial> trials) {
    /** How many alerts are kept: more say no more than their number does. */
    public static final int MOST_ALERTS = 1000;

    /** That of a run in which no sensor looked. */
    static final FalseAlarmResult NONE = new FalseAlarmResult(Map.of(), 0, List.of(), Map.of(), List.of());

    /** Copies map and lists: later changes by the caller have no effect. */
    public FalseAlarmResult {
        counted = Collections.unmodifiableMap(new LinkedHashMap<>(counted));
        alerts = List.copyOf(alerts);
        birds = Collections.unmodifiableMap(new LinkedHashMap<>(birds));
        trials = List.copyOf(trials);
    }

    /** The number of false alarms of all sensors. */
    public long count() {
        return counted.values().stream().mapToLong(Long::longValue).sum();
    }
}
