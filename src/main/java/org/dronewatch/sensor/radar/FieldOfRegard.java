package org.dronewatch.sensor.radar;

import org.dronewatch.geometry.Position;

/** Where and how fast a drone must be for a radar to look for it. */
final class FieldOfRegard {
    /** Rounding must not cut what lies on an edge, least of all straight behind a radar that looks all round. */
    private static final double ROUNDING = 1e-9;

    private final RadarSettings settings;
    private final double azimuth;
    private final double tilt;
    private final double fastest;

    FieldOfRegard(RadarSettings settings) {
        this.settings = settings;
        Position axis = settings.aim().from(settings.position());
        this.azimuth = Math.atan2(axis.x(), axis.y());
        this.tilt = Math.atan2(axis.z(), Math.hypot(axis.x(), axis.y()));
        this.fastest = Math.min(settings.maxSpeed(), settings.budget().migrationSpeed());
    }

    /** Whether a drone is within the angles and ranges. */
    boolean contains(Position way) {
        double range = way.length();
        if (range < settings.minRange() || range > settings.maxRange()) {
            return false;
        }
        double aside = Math.abs(Math.IEEEremainder(Math.atan2(way.x(), way.y()) - azimuth, 2.0 * Math.PI));
        double above = Math.abs(Math.atan2(way.z(), Math.hypot(way.x(), way.y())) - tilt);
        return aside <= 0.5 * settings.azimuthWidth() + ROUNDING && above <= 0.5 * settings.elevationWidth() + ROUNDING;
    }

    /** Whether a drone comes or goes fast enough to be told from the ground, and not too fast. */
    boolean hasSpeed(double radial) {
        return Math.abs(radial) >= settings.minSpeed() && Math.abs(radial) <= fastest;
    }
}
