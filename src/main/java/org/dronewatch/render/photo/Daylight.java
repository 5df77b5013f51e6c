package org.dronewatch.render.photo;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.ClearSky;
import org.dronewatch.world.Light;

/**
 * How the daylight of a world is divided between sun and sky. All light is relative: 1 is the
 * illuminance of level ground, {@link Light#illuminance()}, and the radiance of a white, matt surface that receives it.
 * Immutable.
 *
 * <p>Under a clear sky they are in the proportion of {@link ClearSky}, scaled so that both together give the world's
 * illuminance. Without a sun, or with one below the horizon, all light is that of the sky.
 */
final class Daylight {
    /** Red, green, blue. */
    static final int CHANNELS = 3;

    /** The channels' contributions to brightness (ITU-R BT.709). */
    private static final double[] BRIGHTNESS = {0.2126, 0.7152, 0.0722};

    private final Optional<Light.Sun> sun;
    private final double diffuse;
    private final double direct;
    private final double[] colour;

    Daylight(Light light) {
        this.sun = light.sun();
        double elevation = sun.map(Light.Sun::elevation).orElse(-1.0);
        double up = Math.sin(elevation);
        if (up > 0.0) {
            double sky = ClearSky.diffuse(elevation);
            double normal = ClearSky.direct(elevation);
            this.diffuse = sky / (sky + normal * up);
            this.direct = normal / (sky + normal * up);
        } else {
            this.diffuse = 1.0;
            this.direct = 0.0;
        }
        this.colour = tint(elevation);
    }

    /** The sun; empty when it is hidden by cloud. It may be below the horizon. */
    Optional<Position> toSun() {
        return sun.map(Light.Sun::direction);
    }

    /** Elevation of the sun, rad; if there is none, that of a sun below the horizon. */
    double elevation() {
        return sun.map(Light.Sun::elevation).orElse(-0.5 * Math.PI);
    }

    /** Whether the sun shines. */
    boolean isSunny() {
        return direct > 0.0;
    }

    /** Fraction of the light on level ground that comes from the sky, 0 to 1. */
    double diffuse() {
        return diffuse;
    }

    /** Irradiance by the sun alone of a surface that faces it, relative to the illuminance of level ground. */
    double direct(int channel) {
        return direct * colour[channel];
    }

    /** The colour of white sunlight on the ground, of brightness 1. */
    private static double[] tint(double elevation) {
        double[] rgb = new double[CHANNELS];
        SunInAir.write(0.0, Math.max(0.0, Math.sin(elevation)), rgb);
        return equallyBright(rgb);
    }

    /** Brightness of a colour; 1 for white. */
    static double brightness(double[] rgb) {
        return brightness(rgb[0], rgb[1], rgb[2]);
    }

    /** Brightness of a colour by its channels; 1 for white. */
    static double brightness(double red, double green, double blue) {
        return BRIGHTNESS[0] * red + BRIGHTNESS[1] * green + BRIGHTNESS[2] * blue;
    }

    /** Scales a colour to a brightness of 1. */
    static double[] equallyBright(double[] rgb) {
        double brightness = brightness(rgb);
        for (int i = 0; i < CHANNELS; i++) {
            rgb[i] /= brightness;
        }
        return rgb;
    }
}
