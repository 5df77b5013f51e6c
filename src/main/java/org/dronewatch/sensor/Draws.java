package org.dronewatch.sensor;

import java.nio.charset.StandardCharsets;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;

/**
 * Streams of random numbers, keyed by names. Each purpose of each look of a sensor at a drone has a separate stream,
 * whose key is
 *
 * <pre>
 * mix(mix(mix(mix(seed, hash(sensor)), hash(drone)), look), hash(purpose))
 * </pre>
 *
 * <p>with the seed of the run. No stream depends on which other sensors and drones there are, on their order, or on how
 * many numbers were drawn from another stream; renaming a sensor or a drone changes its numbers. {@code hash} is 64-bit
 * FNV-1a over the name's UTF-8 bytes (Fowler, Noll and Vo, 1991; offset basis 0xCBF29CE484222325, prime 0x100000001B3),
 * {@code mix} is the finalizer of SplitMix64 (Steele, Lea and Flood 2014), and the stream is a {@link SplittableRandom}
 * with that key as its seed.
 */
public final class Draws {
    private static final long FNV_BASIS = 0xCBF29CE484222325L;
    private static final long FNV_PRIME = 0x100000001B3L;

    /** Bits of a derived seed: as many as every JSON reader preserves. */
    private static final int SEED_BITS = 53;

    private Draws() {}

    /**
     * The stream of one purpose, from its beginning: the same numbers each time.
     *
     * @param seed seed of the run
     * @param sensor name of the sensor
     * @param drone name of the drone; empty if no drone is concerned
     * @param look index of the look, from 0
     * @param purpose what is drawn, such as {@code detection}
     */
    public static RandomGenerator stream(long seed, String sensor, String drone, long look, String purpose) {
        long pair = mix(mix(seed, hash(sensor)), hash(drone));
        return new SplittableRandom(mix(mix(pair, look), hash(purpose)));
    }

    /**
     * The seed of one of several runs or replications: the given seed for the first, and the upper 53 bits of
     * {@code mix(mix(seed, hash(of)), number)} for the others.
     *
     * @param of the kind of thing that is numbered, such as {@code run}
     * @param number its number, from 0
     */
    public static long derivedSeed(long seed, String of, long number) {
        return number == 0 ? seed : mix(mix(seed, hash(of)), number) >>> Long.SIZE - SEED_BITS;
    }

    /** FNV-1a of a name's UTF-8 bytes. */
    static long hash(String name) {
        long hash = FNV_BASIS;
        for (byte b : name.getBytes(StandardCharsets.UTF_8)) {
            hash = (hash ^ (b & 0xFF)) * FNV_PRIME;
        }
        return hash;
    }

    /** Mixes two numbers into one, every bit of which depends on all bits of both. */
    public static long mix(long a, long b) {
        long z = a * 0x9E3779B97F4A7C15L + b + 0x632BE59BD9B4E019L;
        z = (z ^ z >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }
}
