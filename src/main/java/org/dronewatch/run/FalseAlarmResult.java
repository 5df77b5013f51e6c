package org.dronewatch.run;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.fusion.Alert;

/**
 * The false alarms of one run.
 *
 * @param counted number of false alarms by name of the sensor; a false alarm that lasts for several looks counts once,
 *     and a bird counts each time the sensor begins to detect it
 * @param ofBirds how many of the false alarms were caused by birds, by name of the sensor
 * @param alertCount number of false alerts that the false alarms raised under the scene's rule
 * @param alerts the false alerts in order of time, at most the first {@link #MOST_ALERTS}
 * @param birds the false alerts for birds, by name of the bird
 * @param trials times of the drones' alerts with other confirmations; none in a scene whose sensors state no
 *     false-alarm rate
 */
public record FalseAlarmResult(
        Map<String, Long> counted,
        Map<String, Long> ofBirds,
        long alertCount,
        List<Alert> alerts,
        Map<String, Alert> birds,
        List<ConfirmationTrial> trials) {
    /** Maximum number of alerts that are kept. */
    public static final int MOST_ALERTS = 1000;

    /** The result of a run in which no sensor looked. */
    static final FalseAlarmResult NONE = new FalseAlarmResult(Map.of(), Map.of(), 0, List.of(), Map.of(), List.of());

    /** Copies maps and lists: later changes by the caller have no effect. */
    public FalseAlarmResult {
        counted = Collections.unmodifiableMap(new LinkedHashMap<>(counted));
        ofBirds = Collections.unmodifiableMap(new LinkedHashMap<>(ofBirds));
        alerts = List.copyOf(alerts);
        birds = Collections.unmodifiableMap(new LinkedHashMap<>(birds));
        trials = List.copyOf(trials);
    }

    /** The number of false alarms of all sensors. */
    public long count() {
        return counted.values().stream().mapToLong(Long::longValue).sum();
    }
}
