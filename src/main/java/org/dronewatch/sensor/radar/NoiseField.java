package org.dronewatch.sensor.radar;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.Outline;

/**
 * The positions at which a radar mistakes noise for a target: its cells are equally deep, equally wide in azimuth, and
 * of equal solid angle.
 */
final class NoiseField {
    private final Position radar;
    private final Outline.Sector field;
    private final Accuracy accuracy;

    NoiseField(Position radar, Outline.Sector field, Accuracy accuracy) {
        this.radar = radar;
        this.field = field;
        this.accuracy = accuracy;
    }

    /**
     * The sighting of a point of the field.
     *
     * @param u fraction of the range, 0 to 1
     * @param v fraction of the azimuth, 0 to 1
     * @param w fraction of the sine of the elevation, 0 to 1
     */
    Sighting at(double u, double v, double w) {
        double range = field.minRange() + u * (field.maxRange() - field.minRange());
        double azimuth = field.azimuth() + (v - 0.5) * field.azimuthWidth();
        double half = 0.5 * field.elevationWidth();
        double lowest = Math.sin(Math.max(-0.5 * Math.PI, field.elevation() - half));
        double highest = Math.sin(Math.min(0.5 * Math.PI, field.elevation() + half));
        boolean measured = accuracy.measuresElevation();
        double elevation = measured ? Math.asin(lowest + w * (highest - lowest)) : field.elevation();
        return new Sighting(radar, new Direction(azimuth, elevation), OptionalDouble.of(range), measured);
    }
}
