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
 * @param beyond how many of them are off the mean by more than three of their stated errors
 * @param unconverged how many readings did not converge
 */
record ReadingSpread(double mean, double deviation, double stated, int beyond, int unconverged) {
    /**
     * Takes readings.
     *
     * @param seed of the first one
     * @param negligible what no reading need be nearer to the mean than, dB
     */
    static ReadingSpread of(
            SoundSites site,
            Criterion criterion,
            Position drone,
            Position microphone,
            int readings,
            long seed,
            double negligible) {
        EnergyTracer tracer = site.microphone(EnergyModel.DEFAULT.withCriterion(criterion), microphone);
        BandLevels noise = site.world().backgroundNoise().spectrum();
        double[] levels = new double[readings];
        double[] errors = new double[readings];
        int count = 0;
        double energy = 0;
        double sum = 0;
        double stated = 0;
        for (int i = 0; i < readings; i++) {
            EnergyReading reading = tracer.trace(site.drone(drone), new SplittableRandom(seed + i), RayRecorder.NONE);
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
        int beyond = 0;
        for (int i = 0; i < count; i++) {
            squares += (levels[i] - sum / count) * (levels[i] - sum / count) / (count - 1);
            beyond += Math.abs(levels[i] - mean) > 3 * errors[i] + negligible ? 1 : 0;
        }
        return new ReadingSpread(mean, Math.sqrt(squares), stated / count, beyond, readings - count);
    }

    /** Standard deviation over stated error. */
    double ratio() {
        return deviation / stated;
    }

    /** Whether nothing is heard, or only on exact paths. */
    boolean isExact() {
        return !(deviation > 0) && !(stated > 0);
    }
}
