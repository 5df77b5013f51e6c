package org.dronewatch.drone;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * A transmission in bursts, each on a channel chosen at random, as in frequency hopping; with a single channel, it
 * merely has a duty cycle.
 *
 * @param rate number of bursts per second, 0.001 to 1e6 Hz
 * @param dutyCycle fraction of the time during which the transmitter is on, above 0 and at most 1
 * @param channels number of channels among which the transmitter hops, 1 to 1,000,000
 * @param span total width of all channels, 1 to 1e10 Hz; it has no effect with a single channel
 */
public record Bursts(
        @In(value = Quantity.FREQUENCY, from = 1e-3, to = 1e6) double rate,
        @In(value = Quantity.RATIO, above = 0, to = 1) double dutyCycle,
        @In(value = Quantity.NUMBER, from = 1, to = 1e6) int channels,
        @In(value = Quantity.FREQUENCY, from = 1, to = 1e10) double span) {
    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public Bursts {
        Limits.check(Bursts.class, rate, dutyCycle, channels, span);
    }

    /** A transmission without pauses on one channel of 1 MHz. */
    @Defaults("rate")
    public static Bursts of(double rate) {
        return new Bursts(rate, 1.0, 1, 1e6);
    }

    /** These bursts with another duty cycle. */
    public Bursts withDutyCycle(double fraction) {
        return SettingsForm.with(this, "dutyCycle", fraction);
    }

    /** These bursts on a number of channels, with the total width of all of them, Hz. */
    public Bursts withChannels(int count, double all) {
        return SettingsForm.with(this, java.util.Map.of("channels", count, "span", all));
    }
}
