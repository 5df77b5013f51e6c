package org.dronewatch.render.photo;

import org.dronewatch.world.Light;
import org.dronewatch.world.World;

/** All the light of a world: sun, sky, light reflected by the ground, and the air in between. Immutable. */
record SceneLight(World world, Daylight daylight, Sky sky, AmbientLight ambient, OpenCountry country) {

    /**
     * The light of a world.
     *
     * @param site what its surfaces reflect
     */
    static SceneLight of(World world, Surfaces site) {
        Daylight daylight = new Daylight(world.light());
        Sky sky = new Sky(daylight);
        AmbientLight ambient = new AmbientLight(sky);
        return new SceneLight(world, daylight, sky, ambient, OpenCountry.around(world, site, daylight, ambient));
    }

    Light light() {
        return world.light();
    }

    /**
     * Writes what is seen where no part of the site is hit: sky, sun, or the country around.
     *
     * @param from height of the camera, m
     * @param scratch for one colour
     */
    void backdrop(double from, double[] direction, double[] rgb, double[] scratch) {
        if (direction[2] < 0.0) {
            country.write(rgb);
            addHaze(direction, country.distance(from, direction[2]), rgb, scratch);
            return;
        }
        sky.radiance(direction[0], direction[1], direction[2], rgb);
        sky.addSun(direction[0], direction[1], direction[2], rgb);
    }

    /**
     * Puts the air in front of a surface: the fraction {@link Light#contrastLeft} is left of its difference from the
     * sky at the horizon, which is what an infinitely long path through air would show (Koschmieder 1924).
     *
     * @param direction direction of the line of sight, of unit length
     * @param distance distance of the surface, m
     * @param rgb radiance without air in front, which is replaced by that with it
     * @param scratch for one colour
     */
    void addHaze(double[] direction, double distance, double[] rgb, double[] scratch) {
        double left = light().contrastLeft(distance);
        sky.radiance(direction[0], direction[1], 0.0, scratch);
        for (int i = 0; i < Daylight.CHANNELS; i++) {
            rgb[i] = scratch[i] + left * (rgb[i] - scratch[i]);
        }
    }
}
