package org.dronewatch.scenario;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * The duration of a scene's run and the seed of its random numbers.
 *
 * @param duration simulated time, above 0 and at most a million seconds
 * @param seed seed of all random numbers
 */
public record RunSettings(@In(value = Quantity.DURATION, above = 0, to = 1e6) double duration, long seed) {
    /** A run of one minute, with seed 1. */
    @Defaults
    public static final RunSettings DEFAULT = new RunSettings(60.0, 1L);

    /** Checks the limits. */
    public RunSettings {
        Limits.check(RunSettings.class, duration, seed);
    }

    /** These settings with another duration, s. */
    public RunSettings withDuration(double seconds) {
        return SettingsForm.with(this, "duration", seconds);
    }

    /** These settings with another seed. */
    public RunSettings withSeed(long number) {
        return SettingsForm.with(this, "seed", number);
    }
}
