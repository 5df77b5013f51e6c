package org.dronewatch.scene;

import org.dronewatch.setting.Check;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Quantity;

/**
 * How long a scene runs and with which random numbers.
 *
 * @param duration simulated time, above 0 and at most a million seconds
 * @param seed seed of all random numbers
 */
public record RunSettings(@In(Quantity.DURATION) double duration, long seed) {
    /** One minute with seed 1. */
    public static final RunSettings DEFAULT = new RunSettings(60.0, 1L);

    private static final double MAX_DURATION = 1e6;

    /** Checks the limits. */
    public RunSettings {
        Check.positive("duration", duration, Quantity.DURATION);
        Check.between("duration", duration, 0.0, MAX_DURATION, Quantity.DURATION);
    }

    /** These settings with another duration, s. */
    public RunSettings withDuration(double seconds) {
        return new RunSettings(seconds, seed);
    }

    /** These settings with another seed. */
    public RunSettings withSeed(long number) {
        return new RunSettings(duration, number);
    }
}
