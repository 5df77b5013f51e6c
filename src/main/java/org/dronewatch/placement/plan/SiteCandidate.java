package org.dronewatch.placement.plan;

import org.dronewatch.placement.Candidate;
import org.dronewatch.sensor.SensorSettings;

/**
 * A sensor with its position and aim.
 *
 * @param candidate its name, its price, the name of its offer as its kind, and the position that it occupies
 * @param sensor its settings
 */
public record SiteCandidate(Candidate candidate, SensorSettings<?> sensor) {
    /** Its name in the layout. */
    public String name() {
        return candidate.name();
    }
}
