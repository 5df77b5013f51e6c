package org.dronewatch.sensor.radar;

import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A Doppler filter that rejects stationary echoes, and with them those of slow and of crossing drones: its response as
 * a function of radial speed, relative to that at the speeds that it passes best.
 */
public sealed interface DopplerFilter {
    /**
     * The fraction of an echo's power that passes, 0 to 1.
     *
     * @param radialSpeed radial speed of the drone, m/s, of either sign
     */
    double response(double radialSpeed);

    /**
     * The reason for missing a drone whose echo would be strong enough if all of it passed the filter.
     *
     * @param radialSpeed its radial speed, m/s
     * @param needed the response that it requires, above 0 and at most 1
     */
    Explanation miss(double radialSpeed, double needed);

    /**
     * A high-pass filter with the Butterworth power response {@code 1 / (1 + (w / v)^(2 n))} at the radial speed v, for
     * a radar with so long a dwell, or so varied a pulse repetition frequency, that it has no blind speeds. Source: A.
     * V. Oppenheim, R. W. Schafer, Discrete-Time Signal Processing, appendix B.
     *
     * @param halfPowerSpeed the radial speed w at which half of the power passes, above 0 and at most 1000 m/s
     * @param order the order n, 1 to 20: far below that speed, the response falls by 6 n dB each time the speed is
     *     halved
     */
    record HighPass(
            @In(value = Quantity.SPEED, above = 0, to = 1000) double halfPowerSpeed,
            @In(value = Quantity.NUMBER, from = 1, to = 20) int order)
            implements DopplerFilter {
        /**
         * Checks the limits.
         *
         * @throws IllegalArgumentException if a value is out of range
         */
        public HighPass {
            Limits.check(HighPass.class, halfPowerSpeed, order);
        }

        /** A second-order filter with the given half-power speed, m/s; the order is an assumption. */
        @Defaults("halfPowerSpeed")
        public static HighPass of(double halfPowerSpeed) {
            return new HighPass(halfPowerSpeed, 2);
        }

        @Override
        public double response(double radialSpeed) {
            double ratio = Math.abs(radialSpeed) / halfPowerSpeed;
            return 1.0 / (1.0 + Math.pow(ratio, -2.0 * order));
        }

        @Override
        public Explanation miss(double radialSpeed, double needed) {
            double least = halfPowerSpeed * Math.pow(1.0 / needed - 1.0, -0.5 / order);
            return Double.isFinite(least) ? Explanation.beyond(Cause.TOO_SLOW, least) : Explanation.of(Cause.TOO_SLOW);
        }
    }

    /**
     * An N-pulse canceller with binomial weights, which is also blind at every multiple of the speed b: its power
     * response at the radial speed v is {@code |sin(pi v / b)|^(2 (N - 1))}. Source: M. A. Richards, Fundamentals of
     * Radar Signal Processing, section 5.2.
     *
     * @param pulses the number of pulses N, 2 to 10
     * @param blindSpeed the first blind speed b, half the wavelength times the pulse repetition frequency, above 0 and
     *     at most 100,000 m/s
     */
    record Canceller(
            @In(value = Quantity.NUMBER, from = 2, to = 10) int pulses,
            @In(value = Quantity.SPEED, above = 0, to = 100_000) double blindSpeed)
            implements DopplerFilter {
        /**
         * Checks the limits.
         *
         * @throws IllegalArgumentException if a value is out of range
         */
        public Canceller {
            Limits.check(Canceller.class, pulses, blindSpeed);
        }

        @Override
        public double response(double radialSpeed) {
            double sine = Math.sin(Math.PI * Math.IEEEremainder(radialSpeed, blindSpeed) / blindSpeed);
            return Math.pow(sine * sine, pulses - 1.0);
        }

        @Override
        public Explanation miss(double radialSpeed, double needed) {
            double least = blindSpeed / Math.PI * Math.asin(Math.pow(needed, 0.5 / (pulses - 1.0)));
            double blind = blindSpeed * Math.rint(Math.abs(radialSpeed) / blindSpeed);
            return blind == 0.0
                    ? Explanation.beyond(Cause.TOO_SLOW, least)
                    : Explanation.beyond(Cause.TOO_FAST, blind - least);
        }
    }
}
