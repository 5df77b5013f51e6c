package org.dronewatch.sensor.acoustic.energy;

import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Criterion;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Levels;

/**
 * How readings of the same sound scatter, and what they state.
 *
 * @param mean level of the mean energy of those that converged, dB
 * @param deviation their standard deviation, dB
 * @param stated mean of their stated errors, dB
 * @param ratio root of the mean square of what they are off their mean over what they state themselves
 * @param beyond how many of them are off the mean by more than three of their stated errors
 * @param converged how many readings converged
 * @param unconverged how many did not
 * @param isSilent whether none heard anything
 */
record ReadingSpread(
        double mean,
        double deviation,
        double stated,
        double ratio,
        int beyond,
        int converged,
        int unconverged,
        boolean isSilent) {
    /**
     * The part of a stated error up to this is assumed, above all for rays that were not drawn ({@link Convergence}),
     * and is too large wherever there are no such rays, dB.
     */
    static final double ALLOWANCE = 0.053;

    /** Of means of exact readings, dB. */
    private static final double ROUNDING = 1e-9;

    /**
     * Takes readings.
     *
     * @param seed of the first one
     */
    static ReadingSpread of(
            SoundSites site, Criterion criterion, Position drone, Position microphone, int readings, long seed) {
        EnergyTracer tracer = site.microphone(EnergyModel.DEFAULT.withCriterion(criterion), microphone);
        BandLevels noise = site.world().backgroundNoise().spectrum();
        double[] levels = new double[readings];
        double[] errors = new double[readings];
        int count = 0;
        boolean isSilent = true;
        double energy = 0;
        double sum = 0;
        double stated = 0;
        for (int i = 0; i < readings; i++) {
            EnergyReading reading = tracer.trace(site.drone(drone), new SplittableRandom(seed + i), RayRecorder.NONE);
            isSilent &= reading.totalLevel() == Double.NEGATIVE_INFINITY;
            if (!reading.isConverged()) {
                continue;
            }
            int band = reading.bestBand(noise);
            levels[count] = criterion == Criterion.A_WEIGHTED
                    ? reading.aWeightedLevel()
                    : reading.level(band) - noise.level(band);
            errors[count] = reading.standardError();
            energy += Levels.toRatio(levels[count]);
            sum += levels[count];
            stated += errors[count];
            count++;
        }
        double mean = Levels.ofRatio(energy / count);
        double squares = 0;
        double ratios = 0;
        int beyond = 0;
        for (int i = 0; i < count; i++) {
            squares += (levels[i] - sum / count) * (levels[i] - sum / count) / (count - 1);
            double off = Math.max(0, Math.abs(levels[i] - mean) - ROUNDING);
            ratios += off > 0 ? Math.pow(off / errors[i], 2) / count : 0;
            beyond += off > 3 * errors[i] ? 1 : 0;
        }
        return new ReadingSpread(
                mean, Math.sqrt(squares), stated / count, Math.sqrt(ratios), beyond, count, readings - count, isSilent);
    }

    /** The least that the ratio may be: 0.8 without the allowance, which is the root of a difference of squares. */
    double leastRatio() {
        double allowed = ALLOWANCE / stated;
        return 0.8 * Math.sqrt(Math.max(0.0, 1.0 - allowed * allowed));
    }

    /** Whether more readings than one in fifty, or all of them, did not converge, though there is something to hear. */
    boolean standsOnFewRays() {
        return !isSilent && (converged < 2 || 50 * unconverged > converged + unconverged);
    }
}
