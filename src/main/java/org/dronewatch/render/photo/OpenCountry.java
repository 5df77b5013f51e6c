package org.dronewatch.render.photo;

import org.dronewatch.geometry.AABB;
import org.dronewatch.world.World;

/**
 * The country around a site, of which nothing is known: a level, matt plane at the height of the site's lowest point,
 * which reflects on average what the site reflects as seen from above, so that the site's own ground goes on. In haze
 * it fades into the sky at the horizon. Immutable.
 */
final class OpenCountry {
    /** The least height of a camera above the country, m: that of the eyes of someone who stands there. */
    private static final double EYES = 1.7;

    private final double height;
    private final double[] colour = new double[Daylight.CHANNELS];

    private OpenCountry(double height) {
        this.height = height;
    }

    /**
     * The country around a world in a light.
     *
     * @param site what the world's surfaces reflect; ordinary ground where nothing faces up
     */
    static OpenCountry around(World world, Surfaces site, Daylight daylight, AmbientLight ambient) {
        AABB bounds = world.bounds();
        OpenCountry country = new OpenCountry(Double.isFinite(bounds.minZ()) ? bounds.minZ() : 0.0);
        ambient.addTo(country.colour, 1.0, new double[] {0.0, 0.0, 1.0}, AmbientLight.newTerms());
        double[] ground =
                site.fromAbove().orElse(new double[] {AmbientLight.ALBEDO, AmbientLight.ALBEDO, AmbientLight.ALBEDO});
        double sine = Math.max(0.0, Math.sin(daylight.elevation()));
        for (int channel = 0; channel < Daylight.CHANNELS; channel++) {
            country.colour[channel] += sine * daylight.direct(channel);
            country.colour[channel] *= ground[channel];
        }
        return country;
    }

    /** Writes its radiance without the air in front of it. */
    void write(double[] rgb) {
        System.arraycopy(colour, 0, rgb, 0, colour.length);
    }

    /**
     * How far away the country is, m.
     *
     * @param from height of the camera, m
     * @param down sine of the elevation at which it is seen, below 0
     */
    double distance(double from, double down) {
        return Math.max(EYES, from - height) / -down;
    }
}
