package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * How much one ray can contribute: known before any ray is traced. A path that is scattered once, at the distances l
 * and d from the ends and at the angles a and b to the surface's normal, is found by rays from both ends. By the
 * balance heuristic ({@link Connections}) each of them contributes E / (pi (l^2 / cos a + d^2 / cos b)), E being the
 * energy that the surface scatters. However the surface lies, the sum in brackets is not below the square of the
 * distance between the ends. One per thread.
 */
final class StrongestRay {
    private static final int BANDS = OctaveBands.COUNT;

    /** Ends nearer to each other than this count as this far apart, m. */
    private static final double NEAREST = 1.0;

    /** The largest fraction that any surface scatters, by band. */
    private final double[] scattered = new double[BANDS];

    private final double[] once = new double[BANDS + 1];

    StrongestRay(World world, BandSurfaces surfaces) {
        for (int material = 0; material < world.surfaces().size(); material++) {
            for (int band = 0; band < BANDS; band++) {
                scattered[band] = Math.max(
                        scattered[band], surfaces.reflected(material, band) * surfaces.scattered(material, band));
            }
        }
    }

    /** Prepares for one look. */
    void between(SoundSource source, Position sensor) {
        double distance = Math.max(NEAREST, source.position().distance(sensor));
        double all = 0.0;
        for (int band = 0; band < BANDS; band++) {
            once[band] = source.fraction(band) * scattered[band] / (Math.PI * distance * distance);
            all += EnergyTally.aWeight(band) * once[band];
        }
        once[EnergyTally.A_WEIGHTED] = all;
    }

    /**
     * The most that one ray can contribute if it is scattered once, as intensity over the source's power, 1/m2.
     *
     * @param quantity a band or {@link EnergyTally#A_WEIGHTED}
     */
    double scatteredOnce(int quantity) {
        return once[quantity];
    }
}
