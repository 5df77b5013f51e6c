package org.dronewatch.placement.site;

import org.dronewatch.placement.Candidate;
import org.dronewatch.sensor.SensorSettings;

/**
 * A sensor at a place and with an aim.
 *
 * @param candidate its name, price, the name of its offer as its kind, and the place that it takes
 * @param sensor its settings
 */
public record SiteCandidate(Candidate candidate, SensorSettings<?> sensor) {
    /** Its name in the layout. */
    public String name() {
        return candidate.name();
    }
}
