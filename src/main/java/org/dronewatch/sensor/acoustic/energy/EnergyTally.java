package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;

/**
 * Accumulates the contributions of rays, as intensity divided by the source's power, and their variance from ray to
 * ray. For use by one thread.
 */
final class EnergyTally {
    private static final int BANDS = OctaveBands.COUNT;

    /** Index of the A-weighted sum of all bands, which follows those of the bands. */
    static final int A_WEIGHTED = BANDS;

    private static final int QUANTITIES = BANDS + 1;

    /** Probability that there is one more ray that is as strong as the strongest. */
    private static final double ANOTHER = 0.5;

    private static final double[] A_WEIGHTS = new double[BANDS];

    static {
        for (int band = 0; band < BANDS; band++) {
            A_WEIGHTS[band] = Levels.toRatio(OctaveBands.aWeight(band));
        }
    }

    private final Air air;
    private final DecayCurve decay = new DecayCurve();
    private final double[] ofThisRay = new double[QUANTITIES];
    private final double[] sums = new double[QUANTITIES];
    private final double[] squares = new double[QUANTITIES];
    private final double[] strongest = new double[QUANTITIES];
    private long rays;

    EnergyTally(Air air) {
        this.air = air;
    }

    void clear() {
        decay.clear();
        Arrays.fill(ofThisRay, 0.0);
        Arrays.fill(sums, 0.0);
        Arrays.fill(squares, 0.0);
        Arrays.fill(strongest, 0.0);
        rays = 0;
    }

    /**
     * Adds the contribution of a ray.
     *
     * @param ray the ray that contributes
     * @param inBand its contribution in each band, 1/m2
     * @param onward distance from the ray's last surface to the receiver, m
     */
    void add(AcousticRay ray, double[] inBand, double onward) {
        double weighted = 0.0;
        for (int band = 0; band < BANDS; band++) {
            ofThisRay[band] += inBand[band];
            weighted += A_WEIGHTS[band] * inBand[band];
        }
        ofThisRay[A_WEIGHTED] += weighted;
        decay.add((ray.travelled + onward) / air.soundSpeed(), inBand);
    }

    /** The factor of a band's energy in the A-weighted sum. */
    static double aWeight(int band) {
        return A_WEIGHTS[band];
    }

    /** Adds the contributions of other rays, which have all ended. */
    void add(EnergyTally others) {
        for (int i = 0; i < QUANTITIES; i++) {
            sums[i] += others.sums[i];
            squares[i] += others.squares[i];
            strongest[i] = Math.max(strongest[i], others.strongest[i]);
        }
        decay.add(others.decay);
        rays += others.rays;
    }

    /** Records that a ray has ended: rays are the independent samples. */
    void endRay() {
        for (int i = 0; i < QUANTITIES; i++) {
            sums[i] += ofThisRay[i];
            squares[i] += ofThisRay[i] * ofThisRay[i];
            strongest[i] = Math.max(strongest[i], ofThisRay[i]);
            ofThisRay[i] = 0.0;
        }
        rays++;
    }

    /** The number of rays that have ended. */
    long rays() {
        return rays;
    }

    /**
     * The mean contribution of a ray, 1/m2.
     *
     * @param quantity a band or {@link #A_WEIGHTED}
     */
    double received(int quantity) {
        return sums[quantity] / rays;
    }

    /**
     * Standard error of {@link #received}, 1/m2, which allows, with a probability of one half, for one more ray that is
     * as strong as the strongest. If a few strong rays contribute much, those that were not drawn do not show in the
     * scatter of the others.
     */
    double standardError(int quantity) {
        return Math.sqrt(scatter(quantity) + ANOTHER * strongest[quantity] * strongest[quantity]) / rays;
    }

    /** The contribution of the strongest ray to {@link #received}, 1/m2. */
    double strongest(int quantity) {
        return strongest[quantity] / rays;
    }

    /** The sum of squared deviations from the mean contribution. */
    private double scatter(int quantity) {
        double sum = sums[quantity];
        return Math.max(0.0, squares[quantity] - sum * sum / rays);
    }

    /**
     * The number of rays with equal contributions that would scatter as much as these (Kish, Survey Sampling, 1965).
     */
    double effectiveRays(int quantity) {
        return squares[quantity] > 0.0 ? sums[quantity] * sums[quantity] / squares[quantity] : 0.0;
    }

    /** The decay curve, by time of arrival; not a copy. */
    DecayCurve decay() {
        return decay.scaled(1.0 / rays);
    }
}
