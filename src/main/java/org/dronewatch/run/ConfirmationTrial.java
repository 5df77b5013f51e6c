package org.dronewatch.run;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;
import org.dronewatch.fusion.Confirmation;

/**
 * The alerts that another M-of-N confirmation would have raised from the looks of a run.
 *
 * @param confirm the confirmation
 * @param alerts time at which the alert for each drone would have been raised, by name of the drone, s; empty if never
 */
public record ConfirmationTrial(Confirmation confirm, Map<String, OptionalDouble> alerts) {
    /** Copies the map: later changes by the caller have no effect. */
    public ConfirmationTrial {
        alerts = Collections.unmodifiableMap(new LinkedHashMap<>(alerts));
    }
}
