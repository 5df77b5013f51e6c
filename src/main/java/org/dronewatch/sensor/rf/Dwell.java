package org.dronewatch.sensor.rf;

import org.dronewatch.drone.Bursts;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * The dwell of a receiver: the time in each look during which the receiver listens to as many of a transmitter's
 * channels as fit into the receiver's bandwidth.
 *
 * @param time duration of one dwell, 1e-6 to 1000 s
 * @param overlap time by which a burst must overlap a dwell to be received, 0 to 1000 s
 * @param count number of dwells per look on the transmitter's channels, at independent times, 1 to 10,000
 */
public record Dwell(
        @In(value = Quantity.DURATION, from = 1e-6, to = 1000) double time,
        @In(value = Quantity.DURATION, from = 0, to = 1000) double overlap,
        @In(value = Quantity.NUMBER, from = 1, to = 10_000) int count) {
    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public Dwell {
        Limits.check(Dwell.class, time, overlap, count);
        if (overlap > time) {
            throw new IllegalArgumentException("overlap " + overlap + " s must be at most time " + time + " s");
        }
    }

    /** One dwell per look, of the given duration, s, in which any part of a burst suffices. */
    @Defaults("time")
    public static Dwell of(double time) {
        return new Dwell(time, 0.0, 1);
    }

    /** This dwell with another required overlap, s. */
    public Dwell withOverlap(double seconds) {
        return SettingsForm.with(this, "overlap", seconds);
    }

    /** This dwell with another number of dwells per look. */
    public Dwell withCount(int dwells) {
        return SettingsForm.with(this, "count", dwells);
    }

    /**
     * The probability that a look intercepts at least one burst: with the burst's duration b, the time T from one to
     * the next, the dwell D and the overlap t, bursts that begin within {@code D + b - 2 t} overlap enough. There are
     * {@code n = floor((D + b - 2 t) / T)} such bursts, and one more with the probability e, which is the remainder;
     * each of them is on a channel that the receiver hears with the probability p, which is the receiver's bandwidth
     * divided by the span of the channels. The probability that none is received is {@code (1 - p)^n (1 - p e)}, to the
     * power of the number of dwells.
     *
     * @param bandwidth bandwidth of the receiver, Hz
     */
    double probability(Bursts bursts, double bandwidth) {
        double heard = bursts.channels() == 1
                ? 1.0
                : Math.min(1.0, Math.max(1.0 / bursts.channels(), bandwidth / bursts.span()));
        if (bursts.dutyCycle() == 1.0 && heard == 1.0) {
            return 1.0;
        }
        double duration = bursts.dutyCycle() / bursts.rate();
        double window = time + duration - 2.0 * overlap;
        if (duration < overlap || window <= 0.0) {
            return 0.0;
        }
        double mean = window * bursts.rate();
        double whole = Math.floor(mean);
        double none = Math.pow(1.0 - heard, whole) * (1.0 - heard * (mean - whole));
        return 1.0 - Math.pow(none, count);
    }
}
