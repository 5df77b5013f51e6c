package org.dronewatch.route.proof;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.sensor.Observation;

/**
 * What a run with one seed gives.
 *
 * @param detection the look that first detects the drone on its route; empty if none does
 * @param alert time of the alert, s since the start of the run; empty if there is none, or if it was not asked for
 */
record FlownRun(Optional<Observation> detection, OptionalDouble alert) {
    /** Whether the alert comes at or before a time, s since the start of the run. */
    boolean isAlertedBy(double time) {
        return alert.isPresent() && alert.getAsDouble() <= time;
    }
}
