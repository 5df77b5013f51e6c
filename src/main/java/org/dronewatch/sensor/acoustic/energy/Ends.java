package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.imagesource.ImageSources;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;

/**
 * The two ends of all paths of one look, and the image sources that join points near them to the rest of a path.
 * Immutable.
 *
 * @param source the drone's sound
 * @param sensor where the microphone is, m
 * @param ofSource image sources of the source that join sound scattered elsewhere to it
 * @param ofSensor image sources of the sensor that join sound at its first scattering to it
 * @param pureOfSource those found from the source: paths of specular reflections alone are exact
 * @param pureOfSensor those found from the sensor
 * @param exactly those of exact paths, from the source on, and their parents
 * @param known about what is heard without rays that pass the source, in all bands, as intensity over the source's
 *     power, 1/m2
 * @param curvature how air bends the paths of sound
 * @param isOpen whether an appreciable part of the sound leaves the site
 */
record Ends(
        SoundSource source,
        Position sensor,
        ImageSources ofSource,
        ImageSources ofSensor,
        ImageSources pureOfSource,
        ImageSources pureOfSensor,
        ImageSources exactly,
        double known,
        PathCurvature curvature,
        boolean isOpen) {

    /**
     * Maximum number of times that a ray from the source is scattered, and connected there. Indoors, where rays from
     * the sensor hit everything, more than once is not worth the time.
     */
    int scatterings() {
        return isOpen ? Connections.FROM_SOURCE : 1;
    }
}
