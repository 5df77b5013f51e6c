package org.dronewatch.sensor;

import java.util.Optional;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.dronewatch.sensor.positioner.Pointing;

/**
 * One look of one sensor. Its random numbers depend on the run's seed, the sensor's place in the scene and the sample's
 * index only: the same in whatever order, and on however many threads, the work is done.
 *
 * @param sensor name of the sensor in the scene
 * @param index number of the look, from 0
 * @param time seconds since the start of the run
 * @param random the sample's own random numbers
 * @param pointing where a mount points the sensor now; empty for a sensor that stands still, or is to look along its own aim
 */
public record Sample(String sensor, long index, double time, RandomGenerator random, Optional<Pointing> pointing) {

    /**
     * The sample with its random generator.
     *
     * @param runSeed seed of the run
     * @param sensorNumber the sensor's place in the scene, from 0
     */
    public static Sample of(long runSeed, int sensorNumber, String sensor, long index, double time) {
        return new Sample(
                sensor, index, time, new SplittableRandom(mix(mix(runSeed, sensorNumber), index)), Optional.empty());
    }

    /** This sample with the sensor's mount pointing somewhere. */
    public Sample withPointing(Optional<Pointing> where) {
        return new Sample(sensor, index, time, random, where);
    }

    /** Joins two numbers to one in which every bit depends on all of theirs (the finalizer of SplitMix64). */
    public static long mix(long a, long b) {
        long z = a * 0x9E3779B97F4A7C15L + b + 0x632BE59BD9B4E019L;
        z = (z ^ z >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }
}
