package org.dronewatch.sensor.rf;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.World;

/**
 * The path loss of a radio wave between two positions in a site: free-space loss, and diffraction at the one edge that
 * obstructs it most. Edges are those of the site as seen from above: ground, trees and roofs. One per thread.
 */
public final class RadioPath {
    private static final double LIGHT = 299_792_458.0;

    /** An edge this far below the line, in units of the Fresnel zone, costs nothing (ITU-R P.526, equation (31)). */
    private static final double CLEAR = -0.78;

    /** The number of points at which the path is sampled, and again around the highest. */
    private static final int STEPS = 512;

    private final World world;
    private final RayTracer traversal;
    private final double above;

    /** For the paths of a site. */
    public RadioPath(World world) {
        this.world = world;
        this.traversal = world.newRayTracer();
        this.above = world.bounds().maxZ() + 1.0;
    }

    /**
     * Loss in free space between isotropic antennas: {@code 20 lg(4 pi d f / c)} (ITU-R P.525).
     *
     * @param distance above 0, m
     * @param frequency Hz
     * @return dB
     */
    public static double freeSpaceLoss(double distance, double frequency) {
        return 20.0 * Math.log10(4.0 * Math.PI * distance * frequency / LIGHT);
    }

    /**
     * Loss at a knife edge (ITU-R P.526, equation (31)).
     *
     * @param v height of the edge over the line, in units of the Fresnel zone; negative below it
     * @return dB, 0 for an edge far below
     */
    public static double knifeEdgeLoss(double v) {
        return v <= CLEAR ? 0.0 : 6.9 + 20.0 * Math.log10(Math.sqrt((v - 0.1) * (v - 0.1) + 1.0) + v - 0.1);
    }

    /** The diffraction loss at the highest edge between two positions, dB. */
    public double obstacleLoss(Position from, Position to, double frequency) {
        double length = from.distance(to);
        if (!(length > 0.0)) {
            return 0.0;
        }
        return knifeEdgeLoss(parameter(from, to, length, highest(from, to, length, frequency), frequency));
    }

    /** The model with the highest edge between two positions; empty where nothing is below the line. */
    Optional<Obstacle> obstacle(Position from, Position to, double frequency) {
        double length = from.distance(to);
        boolean found = length > 0.0
                && Double.isFinite(parameter(from, to, length, highest(from, to, length, frequency), frequency));
        return found ? Optional.of(world.obstacle(traversal.triangle())) : Optional.empty();
    }

    /** The fraction of the path at which the highest edge stands, above 0 and below 1. */
    private double highest(Position from, Position to, double length, double frequency) {
        double worst = Double.NEGATIVE_INFINITY;
        double at = 0.5;
        for (int i = 1; i < STEPS; i++) {
            double fraction = (double) i / STEPS;
            double v = parameter(from, to, length, fraction, frequency);
            if (v > worst) {
                worst = v;
                at = fraction;
            }
        }
        // Once more, finely, around the worst: edges are sharp.
        double step = 1.0 / STEPS;
        double middle = at;
        for (int i = -STEPS / 2; i <= STEPS / 2; i++) {
            double fraction = middle + 2.0 * i * step / STEPS;
            double v = fraction > 0.0 && fraction < 1.0
                    ? parameter(from, to, length, fraction, frequency)
                    : Double.NEGATIVE_INFINITY;
            if (v > worst) {
                worst = v;
                at = fraction;
            }
        }
        return at;
    }

    /** {@code v = h sqrt(2 (d1 + d2) / (wavelength d1 d2))} of the site's highest point at a fraction of the path. */
    private double parameter(Position from, Position to, double length, double fraction, double frequency) {
        double x = from.x() + fraction * (to.x() - from.x());
        double y = from.y() + fraction * (to.y() - from.y());
        if (!traversal.closestHit(x, y, above, 0.0, 0.0, -1.0, 0.0, Double.POSITIVE_INFINITY)) {
            return Double.NEGATIVE_INFINITY;
        }
        double height = above - traversal.distance() - (from.z() + fraction * (to.z() - from.z()));
        double one = fraction * length;
        double other = length - one;
        return height * Math.sqrt(2.0 * length * frequency / (LIGHT * one * other));
    }

    /** The site. */
    World world() {
        return world;
    }
}
