package org.dronewatch.sensor.radar;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Outline;

/** Where and how fast a drone must be for a radar to look for it. */
final class FieldOfRegard {
    private final RadarSettings settings;
    private final Outline outline;
    private final double fastest;

    FieldOfRegard(RadarSettings settings) {
        this.settings = settings;
        this.outline = settings.outline().orElseThrow();
        this.fastest = Math.min(settings.maxSpeed(), settings.budget().migrationSpeed());
    }

    /** Whether a drone is within the angles and ranges. */
    boolean contains(Position way) {
        return outline.contains(way);
    }

    /** Whether a drone comes or goes fast enough to be told from the ground, and not too fast. */
    boolean hasSpeed(double radial) {
        return Math.abs(radial) >= settings.minSpeed() && Math.abs(radial) <= fastest;
    }
}
