package org.dronewatch.world;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * Visibility, daylight and turbulence; they affect cameras that detect by contrast, and turbulence affects thermal
 * cameras, too.
 *
 * @param visibility visibility, above 0 and at most 1,000,000 m
 * @param contrastAtVisibility fraction of a black object's contrast that remains at a distance equal to
 *     {@code visibility}, 0.01 to 0.1: 0.05 for the meteorological optical range that weather stations report, 0.02 for
 *     Koschmieder's visual range
 * @param illuminance illuminance of the ground, 1e-5 to 200,000 lx: about 50,000 in sunshine, 5,000 under cloud, 5 at
 *     dusk, 0.2 under a full moon, 0.001 in starlight
 * @param sun position of the sun; omit it if the sun does not shine
 * @param cn2 refractive-index structure constant Cn2 of the air, assumed equal everywhere, 0 to 1e-10 m^(-2/3): 5e-15
 *     by day and 1e-15 at night are typical 50 m above the ground, 2e-14 and 8e-15 near it, 1e-13 or more over hot
 *     ground; 0 without turbulence
 * @param skyToGroundRatio ratio of the luminance of the sky at the horizon to that of the ground, 0.05 to 100: about
 *     1.4 for grass and 5 for dark forest under a clear sky, 4 and 15 under clouds, and 1 where the two are equal
 */
public record Light(
        @In(value = Quantity.LENGTH, above = 0, to = 1e6) double visibility,
        @In(value = Quantity.RATIO, from = 0.01, to = 0.1) double contrastAtVisibility,
        @In(value = Quantity.ILLUMINANCE, from = 1e-5, to = 200_000) double illuminance,
        Optional<Sun> sun,
        @Minor @In(value = Quantity.REFRACTIVE_INDEX_STRUCTURE, from = 0, to = 1e-10) double cn2,
        @Minor @In(value = Quantity.NUMBER, from = 0.05, to = 100) double skyToGroundRatio) {
    /** Drops per volume and diameter at a diameter of 0 (Marshall and Palmer 1948), 1/m4. */
    private static final double DROPS = 8e6;

    /** How fast drops become fewer with their diameter in rain of 1 mm/h (Marshall and Palmer 1948), 1/m. */
    private static final double DROP_DECAY = 4100.0;

    /** The rate R of the rain changes it as {@code R^-0.21}. */
    private static final double DROP_DECAY_POWER = 0.21;

    /**
     * A day of good visibility under high cloud: 20 km, 5,000 lx, no sun, no turbulence, equal luminance of ground and
     * sky.
     */
    @Defaults
    public static final Light DAY = new Light(20_000.0, 0.05, 5_000.0, Optional.empty(), 0.0, 1.0);

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public Light {
        Limits.check(Light.class, visibility, contrastAtVisibility, illuminance, sun, cn2, skyToGroundRatio);
    }

    /** This light with another visibility, m. */
    public Light withVisibility(double metres) {
        return SettingsForm.with(this, "visibility", metres);
    }

    /**
     * This light with another fraction of a black object's contrast that remains at the distance of the visibility,
     * such as 0.02 or 0.05.
     */
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

    /** This light with another structure constant Cn2 of the air, m^(-2/3). */
    public Light withCn2(double structure) {
        return SettingsForm.with(this, "cn2", structure);
    }

    /** This light with another ratio of the luminance of the horizon sky to that of the ground. */
    public Light withSkyToGroundRatio(double ratio) {
        return SettingsForm.with(this, "skyToGroundRatio", ratio);
    }

    /**
     * This light in rain, with the visibility through air and rain. Each of the drops of Marshall and Palmer (1948),
     * {@code 8000 exp(-4.1 R^-0.21 D)} per cubic metre and millimetre of diameter D, removes light from twice its
     * cross-section (van de Hulst, "Light Scattering by Small Particles", 1957). The extinction by all drops together
     * is {@code 0.365 R^0.63} per kilometre, or {@code 1.58 R^0.63} dB/km, where R is the rain rate in mm/h.
     *
     * @param rain rain rate, 0 or more, mm/h
     */
    public Light inRain(double rain) {
        if (rain == 0.0) {
            return this;
        }
        double decay = DROP_DECAY * Math.pow(rain, -DROP_DECAY_POWER);
        double byRain = Math.PI * DROPS / (decay * decay * decay);
        double needed = -Math.log(contrastAtVisibility);
        // 1 / (1 / visibility + byRain / needed), which stays above 0 in the thickest fog, too.
        return withVisibility(visibility / (1.0 + byRain * visibility / needed));
    }

    /**
     * The fraction of a contrast that remains at a distance: {@code exp(-s d)}, where d is the distance and
     * {@code s = -ln(contrastAtVisibility) / visibility} the extinction coefficient (Koschmieder 1924; CIE 17-31-020).
     * Valid for a target seen against the horizon sky under uniform illumination.
     *
     * @param distance distance d, 0 or more, m
     */
    public double contrastLeft(double distance) {
        return Math.pow(contrastAtVisibility, distance / visibility);
    }

    /**
     * The luminance of a target's background as it appears at the target, relative to that of the sky at the horizon.
     * For the ground itself it is {@code 1 / skyToGroundRatio}; with the haze on the path to the target, it becomes
     * {@code 1 - (1 - 1 / skyToGroundRatio) exp(-s G)} with s as for {@link #contrastLeft(double)}.
     *
     * @param behind distance G from the target to the ground behind it, 0 or more, m; infinite for the sky
     * @return above 0; 1 for the sky
     */
    public double backgroundBrightness(double behind) {
        return 1.0 - (1.0 - 1.0 / skyToGroundRatio) * contrastLeft(behind);
    }

    /**
     * The fraction of a contrast against any background that remains at a distance R:
     * {@code 1 / (1 + K (exp(s R) - 1))}, where s is as for {@link #contrastLeft(double)}, and K is the ratio of the
     * luminance of the sky at the horizon to that of the background: the air scatters light into the line of sight
     * (Duntley, "The reduction of apparent contrast by the atmosphere", Journal of the Optical Society of America 38,
     * 179, 1948). For K = 1 this is Koschmieder's law.
     *
     * @param distance distance R, 0 or more, m
     * @param brightness 1/K, luminance of the background relative to that of the sky at the horizon, above 0
     */
    public double contrastLeft(double distance, double brightness) {
        double left = contrastLeft(distance);
        // The same without overflow, and exactly Koschmieder's where K is 1.
        return left * brightness / (1.0 - left * (1.0 - brightness));
    }

    /**
     * The position of the sun.
     *
     * @param azimuth azimuth of the sun, clockwise from north, rad
     * @param elevation elevation of the sun above the horizon, -pi/2 to pi/2, rad
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
