package org.dronewatch.world;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * Visibility and daylight; they matter to cameras that decide by contrast.
 *
 * @param visibility visibility, above 0 and at most 1000 km, m
 * @param contrastAtVisibility fraction of a black object's contrast that is left at that distance, 0.01 to 0.1: 0.05
 *     for the meteorological optical range that weather stations report, 0.02 for Koschmieder's
 * @param illuminance illuminance of the ground, 1e-5 to 200,000 lx: about 50,000 in sunshine, 5,000 under cloud, 5 at
 *     dusk, 0.2 under a full moon, 0.001 in starlight
 * @param sun where the sun is, or empty if it does not shine
 */
public record Light(
        @In(value = Quantity.LENGTH, above = 0, to = 1e6) double visibility,
        @In(value = Quantity.RATIO, from = 0.01, to = 0.1) double contrastAtVisibility,
        @In(value = Quantity.ILLUMINANCE, from = 1e-5, to = 200_000) double illuminance,
        Optional<Sun> sun) {
    /** A clear day under high cloud: 20 km, 5,000 lx, no sun. */
    @Defaults
    public static final Light DAY = new Light(20_000.0, 0.05, 5_000.0, Optional.empty());

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public Light {
        Limits.check(Light.class, visibility, contrastAtVisibility, illuminance, sun);
    }

    /** This light with another visibility, m. */
    public Light withVisibility(double metres) {
        return SettingsForm.with(this, "visibility", metres);
    }

    /** This light with another fraction of a black object's contrast left at the visibility, such as 0.02 or 0.05. */
    public Light withContrastAtVisibility(double share) {
        return SettingsForm.with(this, "contrastAtVisibility", share);
    }

    /** This light with another illuminance, lx. */
    public Light withIlluminance(double lux) {
        return SettingsForm.with(this, "illuminance", lux);
    }

    /** This light with the sun in the sky. */
    public Light withSun(Sun shining) {
        return SettingsForm.with(this, "sun", Optional.of(shining));
    }

    /**
     * What is left of a contrast at a distance: {@code exp(-s d)} with
     * {@code s = -ln(contrastAtVisibility) / visibility} (Koschmieder 1924; CIE 17-31-020). Valid for a target seen
     * against the horizon sky under uniform illumination.
     *
     * @param distance m
     */
    public double contrastLeft(double distance) {
        return Math.pow(contrastAtVisibility, distance / visibility);
    }

    /**
     * Where the sun is.
     *
     * @param azimuth clockwise from north, rad
     * @param elevation above the horizon, -pi/2 to pi/2, rad
     */
    public record Sun(
            @In(value = Quantity.ANGLE, from = -In.TWO_TURNS, to = In.TWO_TURNS) double azimuth,
            @In(value = Quantity.ANGLE, from = -Math.PI / 2, to = Math.PI / 2) double elevation) {
        /** Checks the limits. */
        public Sun {
            Limits.check(Sun.class, azimuth, elevation);
        }

        /** Unit vector to the sun. */
        public Position direction() {
            double level = Math.cos(elevation);
            return new Position(level * Math.sin(azimuth), level * Math.cos(azimuth), Math.sin(elevation));
        }
    }
}
