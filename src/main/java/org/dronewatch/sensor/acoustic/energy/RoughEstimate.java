package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.energy.ScatterSamples.Sample;
import org.dronewatch.sensor.acoustic.energy.ScatterSamples.Samples;
import org.dronewatch.sensor.acoustic.imagesource.EnteredSolids;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.imagesource.WallTransmission;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Rough estimates of the sound heard, from a few samples. They affect how accurately sound is computed, not its
 * expected value. For use by one thread.
 */
final class RoughEstimate {
    /** A sample nearer to an end than this does not represent others, m. */
    private static final double NEAREST = 1.0;

    /** Walls that transmit less than this power of ten count as transmitting this much. */
    private static final double LEAST_DECADE = -8.0;

    private final Visibility visibility;
    private final WallTransmission walls;
    private final boolean anyTransmits;

    RoughEstimate(World world, WallPlanes planes, BandSurfaces surfaces) {
        this.visibility = Visibility.ofClearPoints(world);
        this.walls = new WallTransmission(world, planes, surfaces);
        this.anyTransmits = surfaces.anyTransmits();
    }

    /** Direct sound, as intensity divided by the source's power, 1/m2. */
    double straight(Position source, Position sensor) {
        double distance = Math.max(NEAREST, source.distance(sensor));
        return visibility.isFree(source, sensor) ? 1.0 / (4.0 * Math.PI * distance * distance) : 0.0;
    }

    /**
     * The fraction of direct sound that passes through walls, rounded down to a power of ten, so that it is the same
     * for many positions; 1 if no direct sound arrives at all.
     */
    double through(Position source, Position sensor) {
        if (!anyTransmits
                || !walls.trace(
                        source.x(),
                        source.y(),
                        source.z(),
                        sensor.x(),
                        sensor.y(),
                        sensor.z(),
                        EnteredSolids.NONE,
                        0.0)) {
            return 1.0;
        }
        double mean = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            mean += walls.passed(band) / OctaveBands.COUNT;
        }
        return Math.pow(10.0, Math.max(LEAST_DECADE, Math.floor(Math.log10(mean))));
    }

    /** The sound scattered straight from the samples of one end to the other end, 1/m2. */
    double scattered(Position end, Samples near) {
        double sum = 0.0;
        for (Sample point : near.points()) {
            Position to = end.minus(point.at());
            double distance = Math.max(NEAREST, to.length());
            double cosine =
                    (to.x() * point.normal()[0] + to.y() * point.normal()[1] + to.z() * point.normal()[2]) / distance;
            if (cosine > 0.0 && visibility.isFree(point.at(), end)) {
                sum += point.energy() * cosine / (Math.PI * distance * distance);
            }
        }
        return sum / near.rays();
    }
}
