package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.OctaveBands;

/**
 * An allowance for rays that were not drawn: the possible contribution of a rare ray that is scattered once, by a
 * surface near one of the ends, where all other rays have missed this surface. The allowance is for the case in which
 * no ray has shown such a surface, and therefore does not depend on the contributions of rays; if there is no such
 * surface, it is too large.
 *
 * <p>A path that is scattered once, at the distances l and d from the ends and at the angles a and b to the surface's
 * normal, is found by rays from both ends. By the balance heuristic ({@link Connections}) each of them contributes E /
 * (pi (l^2 / cos a + d^2 / cos b)), E being the fraction of the energy that the surface scatters. However the surface
 * lies, the sum in brackets is not below the square of the distance between the ends. E is that of the materials that a
 * few rays from either end meet. Each end may have image sources near it: the allowance is for one end over ground and
 * the other one in a corner of ground and wall, which makes {@value #PATHS} paths. It is not a bound on what a ray can
 * contribute: more image sources, several scatterings and the directivity of the source may add to it.
 *
 * <p>In an enclosed space, sound that reaches the target by specular reflections is counted only in rays that happen to
 * pass the target, except over the image sources that were found. A ray that passes contributes its energy over the
 * cross-section of the sphere around the target; the faintest have about the energy at which roulette begins. For use
 * by one thread.
 */
final class MissedRays {
    private static final int BANDS = OctaveBands.COUNT;

    /** Ends nearer to each other than this count as this far apart, m. */
    private static final double NEAREST = 1.0;

    /** The number of paths: two apparent positions of one end, times four of the other. */
    private static final int PATHS = 8;

    /** A ray that passes the target early is taken to contribute this many times as much as the faintest. */
    private static final double STRONGER = 4.0;

    private final BandSurfaces surfaces;
    private final double crossSection;
    private final double[] allowances = new double[BANDS + 1];
    private final double[] passing = new double[BANDS + 1];

    /**
     * Rays in a world.
     *
     * @param radius of the sphere in which passing rays are counted, m
     */
    MissedRays(double radius, BandSurfaces surfaces) {
        this.surfaces = surfaces;
        this.crossSection = Math.PI * radius * radius;
    }

    /** Prepares for one look. */
    void between(Ends ends) {
        Arrays.fill(allowances, 0.0);
        Arrays.fill(passing, 0.0);
        double ofPassing = ends.isOpen() ? 0.0 : ends.roulette() / crossSection;
        double distance = Math.max(NEAREST, ends.start().distance(ends.target()));
        for (int band = 0; band < BANDS; band++) {
            double scattered = 0.0;
            for (int material : ends.scatterers()) {
                scattered =
                        Math.max(scattered, surfaces.reflected(material, band) * surfaces.scattered(material, band));
            }
            double once = scattered / (Math.PI * distance * distance);
            passing[band] = ends.source().fraction(band) * ofPassing;
            allowances[band] = Math.max(ends.source().fraction(band) * PATHS * once, STRONGER * passing[band]);
            passing[EnergyTally.A_WEIGHTED] += EnergyTally.aWeight(band) * passing[band];
            allowances[EnergyTally.A_WEIGHTED] += EnergyTally.aWeight(band) * allowances[band];
        }
    }

    /**
     * The possible contribution of such a ray to the sum over all rays, as intensity divided by the source's power,
     * 1/m2.
     *
     * @param quantity a band or {@link EnergyTally#A_WEIGHTED}
     */
    double contribution(int quantity) {
        return allowances[quantity];
    }

    /**
     * What a faint ray that happens to pass the target contributes to the sum over all rays, as intensity over the
     * source's power, 1/m2; 0 where paths to the target are connected.
     *
     * @param quantity a band or {@link EnergyTally#A_WEIGHTED}
     */
    double passing(int quantity) {
        return passing[quantity];
    }
}
