package org.dronewatch.sensor.acoustic.energy;

import java.util.Set;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.imagesource.ImageSources;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;

/**
 * The two ends of all paths of one look, and the image sources that join points near them to the rest of a path. Rays
 * are followed from one end, the start, until they are absorbed or leave the site; rays from the other end, the target,
 * are followed only to the first few surfaces. The start is the sensor, unless the source is in a more sheltered place,
 * such as a room or a courtyard: sound takes every path in both directions, and rays find the way out through a door
 * far more often than the way in. Immutable.
 *
 * @param source the drone's sound
 * @param sensor position of the microphone, m
 * @param isFromSource whether the source is the start
 * @param ofTarget image sources of the target that join rays scattered elsewhere to it
 * @param ofStart image sources of the start that join rays from the target at their first scatterings to it
 * @param pureOfTarget those found from the target: paths of specular reflections alone are exact
 * @param pureOfStart those found from the start
 * @param exactly those of exact paths, from the target on, and their parents
 * @param known about what is heard without rays that pass the target, in all bands, as intensity over the source's
 *     power, 1/m2
 * @param curvature how air bends the paths of sound
 * @param isOpen whether an appreciable part of the sound leaves the site from one end at least: few rays that pass the
 *     other end do so by chance
 * @param isThroughWalls whether the straight path leads through walls that transmit sound
 * @param roulette fraction of a ray's initial energy below which Russian roulette decides whether the ray survives
 * @param scatterers the materials of surfaces that scatter sound near either end, as far as a few rays met them
 */
record Ends(
        SoundSource source,
        Position sensor,
        boolean isFromSource,
        ImageSources ofTarget,
        ImageSources ofStart,
        ImageSources pureOfTarget,
        ImageSources pureOfStart,
        ImageSources exactly,
        double known,
        PathCurvature curvature,
        boolean isOpen,
        boolean isThroughWalls,
        double roulette,
        Set<Integer> scatterers) {

    /**
     * Maximum number of times that a ray from the target is scattered, and connected there. Indoors, where rays
     * from the start hit everything, more than once is not worth the time.
     */
    int scatterings() {
        return isOpen ? Connections.FROM_TARGET : 1;
    }

    /** The position at which rays that are followed to their end begin, m. */
    Position start() {
        return isFromSource ? source.position() : sensor;
    }

    /** The position of the other end, m. */
    Position target() {
        return isFromSource ? sensor : source.position();
    }

    /**
     * The sound in a band that the start emits in one direction, relative to its mean over all directions; 1 if the
     * start is the sensor.
     *
     * @param rise sine of the elevation at which the path leaves the start
     */
    double startFactor(int band, double rise) {
        return isFromSource ? source.factor(band, rise) : 1.0;
    }

    /**
     * The sound in a band that the target emits in one direction, relative to its mean over all directions; 1 if the
     * target is the sensor.
     *
     * @param rise sine of the elevation at which the path leaves the target
     */
    double targetFactor(int band, double rise) {
        return isFromSource ? 1.0 : source.factor(band, rise);
    }

    /** The curvature of sound on a straight piece of a path, a vector that points from target to start, 1/m. */
    double curvature(double x, double y, double z) {
        return isFromSource ? curvature.along(-x, -y, -z) : curvature.along(x, y, z);
    }
}
