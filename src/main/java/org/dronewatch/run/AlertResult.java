package org.dronewatch.run;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.fusion.Alert;

/**
 * How early the site was alerted to one drone in one run.
 *
 * @param run number of the run in a sweep, from 0
 * @param drone name of the drone
 * @param firstSight when a sensor could have seen it for the first time: a free line of sight to it, within the sensor's field
 *     of view and range, s; empty for never, and where no sensor has a field of view
 * @param alert the alert, or empty when there was none
 * @param zoneDistance how far it was from the protected zone at the alert, m; empty without zone or alert
 * @param warning how long it needed from there straight to the zone at its cruise speed, s; 0 when it had been there already;
 *     empty without zone or alert
 * @param entered when its flight reached the zone, s; empty when it did not in the run's time
 * @param inTime whether the warning leaves the time that is needed and came before the drone did; empty when no time was
 *     asked for or nothing is protected
 */
public record AlertResult(
        int run,
        String drone,
        OptionalDouble firstSight,
        Optional<Alert> alert,
        OptionalDouble zoneDistance,
        OptionalDouble warning,
        OptionalDouble entered,
        Optional<Boolean> inTime) {

    /** When the alert was, s; empty for never. */
    public OptionalDouble time() {
        return alert.map(one -> OptionalDouble.of(one.time())).orElse(OptionalDouble.empty());
    }

    /** The sensors on which the alert rests; none without one. */
    public List<String> sensors() {
        return alert.map(Alert::sensors).orElse(List.of());
    }

    /**
     * From the moment when a sensor could have seen it to the alert, s: 0 when it was heard before, or a part of it seen; empty
     * when there was no such moment or no alert.
     */
    public OptionalDouble timeToAlert() {
        return alert.isPresent() && firstSight.isPresent()
                ? OptionalDouble.of(Math.max(0.0, alert.get().time() - firstSight.getAsDouble()))
                : OptionalDouble.empty();
    }
}
