package org.dronewatch.sensor.radar;

import java.util.OptionalDouble;
import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * The accuracy with which a radar measures a drone's position: standard deviations of normally distributed errors,
 * independent between scans.
 *
 * @param range standard deviation of the range, 0 to 1000 m
 * @param azimuth standard deviation of the bearing, 0 to pi/6, rad
 * @param elevation standard deviation of the elevation, 0 to pi/6, rad
 * @param measuresElevation whether the radar measures elevations at all; one with a fan beam does not, and assumes the
 *     elevation of its aim
 */
public record Accuracy(
        @In(value = Quantity.LENGTH, from = 0, to = 1000) double range,
        @In(value = Quantity.ANGLE, from = 0, to = Math.PI / 6) double azimuth,
        @In(value = Quantity.ANGLE, from = 0, to = Math.PI / 6) double elevation,
        @Minor boolean measuresElevation) {
    /** 5 m and one degree. */
    @Defaults
    public static final Accuracy DEFAULT = new Accuracy(5.0, Math.toRadians(1.0), Math.toRadians(1.0), true);

    /** Checks the limits. */
    public Accuracy {
        Limits.check(Accuracy.class, range, azimuth, elevation, measuresElevation);
    }

    /** This accuracy without any measurement of elevation. */
    public Accuracy withoutElevation() {
        return SettingsForm.with(this, "measuresElevation", false);
    }

    /**
     * The sighting that a radar with this accuracy reports of something at a given position.
     *
     * @param middle elevation of the radar's aim, rad
     */
    Sighting sighting(Position radar, Position position, double middle, RandomGenerator random) {
        Position vector = position.minus(radar);
        Direction found =
                Direction.of(vector).turned(azimuth * random.nextGaussian(), elevation * random.nextGaussian());
        Direction believed = measuresElevation ? found : new Direction(found.azimuth(), middle);
        double distance = Math.max(0.0, vector.length() + range * random.nextGaussian());
        return new Sighting(radar, believed, OptionalDouble.of(distance), measuresElevation);
    }
}
