package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.mirror.MirrorChains;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;

/**
 * The two ends of all paths of one look, and the chains of walls that join points near them to the rest of a path. Immutable.
 *
 * @param source the drone's sound
 * @param sensor where the microphone is, m
 * @param ofSource the chains of walls that join sound scattered elsewhere to the source
 * @param ofSensor the chains of walls that join sound at its first scattering to the sensor
 * @param pureOfSource the chains that were found from the source: paths of specular reflections alone are exact
 * @param pureOfSensor the chains that were found from the sensor
 * @param exactly the chains of exact paths, from the source on, and what they begin with
 * @param known about what is heard without rays that pass the source, in all bands, as intensity over the source's power, 1/m2
 * @param curvature how air bends the paths of sound
 * @param isOpen whether an appreciable part of the sound leaves the site
 */
record Ends(
        SoundSource source,
        Position sensor,
        MirrorChains ofSource,
        MirrorChains ofSensor,
        MirrorChains pureOfSource,
        MirrorChains pureOfSensor,
        MirrorChains exactly,
        double known,
        PathCurvature curvature,
        boolean isOpen) {

    /**
     * Maximum number of times that a ray from the source is scattered, and connected there. Indoors, where rays from the
     * sensor hit everything, more than once is not worth the time.
     */
    int scatterings() {
        return isOpen ? Connections.FROM_SOURCE : 1;
    }
}
