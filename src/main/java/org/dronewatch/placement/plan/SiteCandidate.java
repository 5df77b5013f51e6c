package org.dronewatch.placement.plan;

import org.dronewatch.placement.Candidate;
import org.dronewatch.sensor.SensorSettings;

/**
 * A sensor with its position and aim.
 *
 * @param candidate name and price of the sensor, the name of its offer as its kind, and the position that it occupies
 * @param sensor settings of the sensor
 */
public record SiteCandidate(Candidate candidate, SensorSettings<?> sensor) {
    /** The name of the sensor in the layout. */
    public String name() {
        return candidate.name();
    }
}
