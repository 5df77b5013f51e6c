package org.dronewatch.run;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.fusion.Alert;

/**
 * The alert for one drone in one run, with the warning time.
 *
 * @param run number of the run in a sweep, from 0
 * @param drone name of the drone
 * @param firstSight first time with an unobstructed line of sight from a sensor to the drone, within that sensor's
 *     field of view and range, s; empty if there was none, or if no sensor has a field of view
 * @param alert the alert, or empty when there was none
 * @param zoneDistance the drone's distance to the protected zone at the alert, m; empty without a zone or an alert
 * @param warning warning time: straight-line flight time from the drone's position at the alert to the zone at cruise
 *     speed, s; 0 if the drone had already reached the zone; empty without a zone or an alert
 * @param entered time at which the drone reached the zone, s; empty if it did not during the run
 * @param zone name of the protected zone that the drone enters first or, if it enters none, to which it is nearest at
 *     its alert; empty without named zones, or if there is neither an entry nor an alert
 * @param inTime whether the warning time covers the response time and the alert preceded the drone's arrival; empty if
 *     no time is required or nothing is protected
 */
public record AlertResult(
        int run,
        String drone,
        OptionalDouble firstSight,
        Optional<Alert> alert,
        OptionalDouble zoneDistance,
        OptionalDouble warning,
        OptionalDouble entered,
        Optional<String> zone,
        Optional<Boolean> inTime) {

    /** The time at which the alert was raised, s; empty if never. */
    public OptionalDouble time() {
        return alert.map(one -> OptionalDouble.of(one.time())).orElse(OptionalDouble.empty());
    }

    /** The sensors that raised the alert; empty if there was none. */
    public List<String> sensors() {
        return alert.map(Alert::sensors).orElse(List.of());
    }

    /**
     * The time from {@code firstSight} to the alert, s: 0 if the alert preceded the first sight, since the drone was
     * heard or partly seen before; empty without a first sight or an alert.
     */
    public OptionalDouble timeToAlert() {
        return alert.isPresent() && firstSight.isPresent()
                ? OptionalDouble.of(Math.max(0.0, alert.get().time() - firstSight.getAsDouble()))
                : OptionalDouble.empty();
    }
}
