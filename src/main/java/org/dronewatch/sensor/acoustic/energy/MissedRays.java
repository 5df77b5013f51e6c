package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.OctaveBands;

/**
 * An allowance for rays that were not drawn: the possible contribution of a rare ray that is scattered once, by a
 * surface near one of the ends, where all other rays have missed this surface. The allowance is for the case in which
 * no ray has shown such a surface, and therefore does not depend on what rays contribute; where there is no such
 * surface, it is too large.
 *
 * <p>A path that is scattered once, at the distances l and d from the ends and at the angles a and b to the surface's
 * normal, is found by rays from both ends. By the balance heuristic ({@link Connections}) each of them contributes E /
 * (pi (l^2 / cos a + d^2 / cos b)), E being the fraction of the energy that the surface scatters. However the surface
 * lies, the sum in brackets is not below the square of the distance between the ends. E is that of the materials that a
 * few rays from either end meet. Each end may have image sources near it: the allowance is for one end over ground and
 * the other one in a corner of ground and wall, which makes {@value #PATHS} paths. It is not a bound on what a ray can
 * contribute: more image sources, several scatterings and the directivity of the source may add to it. For use by one
 * thread.
 */
final class MissedRays {
    private static final int BANDS = OctaveBands.COUNT;

    /** Ends nearer to each other than this count as this far apart, m. */
    private static final double NEAREST = 1.0;

    /** Two places in which the one end is heard, four for the other one. */
    private static final int PATHS = 8;

    private final BandSurfaces surfaces;
    private final double[] allowances = new double[BANDS + 1];

    MissedRays(BandSurfaces surfaces) {
        this.surfaces = surfaces;
    }

    /** Prepares for one look. */
    void between(Ends ends) {
        Arrays.fill(allowances, 0.0);
        double distance = Math.max(NEAREST, ends.start().distance(ends.target()));
        for (int band = 0; band < BANDS; band++) {
            double scattered = 0.0;
            for (int material : ends.scatterers()) {
                scattered =
                        Math.max(scattered, surfaces.reflected(material, band) * surfaces.scattered(material, band));
            }
            double once = scattered / (Math.PI * distance * distance);
            allowances[band] = PATHS * ends.source().fraction(band) * once;
            allowances[EnergyTally.A_WEIGHTED] += EnergyTally.aWeight(band) * allowances[band];
        }
    }

    /**
     * What such a ray may contribute to the sum over all rays, as intensity over the source's power, 1/m2.
     *
     * @param quantity a band or {@link EnergyTally#A_WEIGHTED}
     */
    double contribution(int quantity) {
        return allowances[quantity];
    }
}
