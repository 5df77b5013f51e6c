package org.dronewatch.sensor.radar;

import java.util.function.DoubleUnaryOperator;
import org.dronewatch.world.World;

/**
 * The radar cross-section of the clutter that competes with a drone in its resolution cell and passes the radar's
 * filters: the ground that is in sight in the cell, and the rain that fills it. For use by one thread.
 */
final class ClutterEcho {
    /** Number of bearings, evenly spaced over the beamwidth, at which the ground is sampled. */
    private static final int BEARINGS = 5;

    /**
     * The fraction that a two-way Gaussian beam fills of the box spanned by its two beamwidths: pi / (8 ln 2)
     * (Probert-Jones).
     */
    private static final double FILLED = Math.PI / (8.0 * Math.log(2.0));

    private final SurfaceReflectivity surface;
    private final double frequency;
    private final double width;
    private final double depth;
    private final double groundResidue;
    private final double rainByRangeSquared;
    private final VisibleGround ground;

    /** The clutter of a radar with a beam. */
    ClutterEcho(RadarSettings radar, Clutter clutter, World world) {
        BeamPattern beam = radar.beam().orElseThrow();
        surface = clutter.ground();
        frequency = radar.frequency();
        width = beam.azimuthBeamwidth();
        depth = clutter.depth(radar.budget());
        groundResidue = Math.pow(10.0, -0.1 * clutter.improvement());
        double rainResidue = Math.pow(10.0, -0.1 * clutter.rainImprovement());
        rainByRangeSquared = rainResidue
                * Rain.reflectivity(frequency, world.rain())
                * FILLED
                * width
                * beam.elevationBeamwidth()
                * depth;
        ground = new VisibleGround(world, radar.position());
    }

    /**
     * The radar cross-section that is left after the filters, m2.
     *
     * @param azimuth azimuth of the drone, clockwise from north, rad
     * @param range range of the drone, above 0, m
     * @param pattern two-way gain of the antenna at an elevation, relative to that towards the drone, as a ratio of
     *     powers
     */
    double residue(double azimuth, double range, DoubleUnaryOperator pattern) {
        double sum = 0.0;
        for (int i = 0; i < BEARINGS; i++) {
            double bearing = azimuth + ((i + 0.5) / BEARINGS - 0.5) * width;
            if (ground.look(bearing, range - 0.5 * depth, range + 0.5 * depth)) {
                sum += seen(range, pattern);
            }
        }
        return groundResidue * sum + rainByRangeSquared * range * range;
    }

    /** The contribution of the ground that is in sight at one bearing. */
    private double seen(double range, DoubleUnaryOperator pattern) {
        double across = range * width / BEARINGS;
        double middle = 0.5 * (ground.low() + ground.high());
        double facing = range * across * Math.cos(middle) * (ground.high() - ground.low());
        return pattern.applyAsDouble(middle) * surface.crossSection(frequency, facing, across * depth);
    }
}
