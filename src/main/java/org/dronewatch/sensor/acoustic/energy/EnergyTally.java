package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sound.OctaveBands;

/**
 * Accumulates the contributions of rays, as intensity over the source's power, and their variance from ray to ray. One
 * per thread.
 */
final class EnergyTally {
    private static final int BANDS = OctaveBands.COUNT;

    private final Air air;
    private final double[] received = new double[BANDS];
    private final DecayCurve decay = new DecayCurve();
    private double ofThisRay;
    private double sum;
    private double squares;
    private long rays;

    EnergyTally(Air air) {
        this.air = air;
    }

    void clear() {
        Arrays.fill(received, 0.0);
        decay.clear();
        ofThisRay = 0.0;
        sum = 0.0;
        squares = 0.0;
        rays = 0;
    }

    /**
     * The contribution of a ray.
     *
     * @param ray where it comes from
     * @param inBand its contribution in each band, 1/m2
     * @param onward how far it still was from its last surface, m
     */
    void add(AcousticRay ray, double[] inBand, double onward) {
        double brought = 0.0;
        for (int band = 0; band < BANDS; band++) {
            received[band] += inBand[band];
            brought += inBand[band];
        }
        ofThisRay += brought;
        decay.add((ray.travelled + onward) / air.soundSpeed(), brought);
    }

    /** Adds the contributions of other rays, which have all ended. */
    void add(EnergyTally others) {
        for (int band = 0; band < BANDS; band++) {
            received[band] += others.received[band];
        }
        decay.add(others.decay);
        sum += others.sum;
        squares += others.squares;
        rays += others.rays;
    }

    /** Records that a ray has ended: rays are the independent samples. */
    void endRay() {
        sum += ofThisRay;
        squares += ofThisRay * ofThisRay;
        ofThisRay = 0.0;
        rays++;
    }

    /** How many rays have ended. */
    long rays() {
        return rays;
    }

    /** The mean contribution of a ray in a band, 1/m2. */
    double received(int band) {
        return received[band] / rays;
    }

    /** The mean contribution of a ray in all bands, 1/m2. */
    double received() {
        return sum / rays;
    }

    /** Standard error of {@link #received()}, 1/m2. */
    double standardError() {
        return Math.sqrt(Math.max(0.0, squares - sum * sum / rays)) / rays;
    }

    /** When it arrives; keeps its own figures. */
    DecayCurve decay() {
        return decay.scaled(1.0 / rays);
    }
}
