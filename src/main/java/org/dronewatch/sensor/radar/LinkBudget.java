package org.dronewatch.sensor.radar;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleBinaryOperator;
import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * The link budget of a radar, which gives the signal-to-noise ratio of an echo: from the parameters of its hardware, or
 * from its manufacturer's data sheet.
 */
public sealed interface LinkBudget {
    /** Speed of light, m/s. */
    double LIGHT = 299_792_458.0;

    /**
     * Signal-to-noise ratio of an echo after coherent processing, dB, in clear air.
     *
     * @param frequency carrier frequency, Hz
     * @param crossSection radar cross-section, m2
     * @param range distance of the target, above 0, m
     */
    default double signalToNoise(double frequency, double crossSection, double range) {
        return echo(frequency, 1).applyAsDouble(crossSection, range);
    }

    /**
     * The signal-to-noise ratio of each of a number of pulses, after coherent processing, dB, in clear air: a function
     * of radar cross-section, m2, and range, m, above 0.
     *
     * @param frequency carrier frequency, Hz
     * @param pulses number of pulses of a look that are integrated non-coherently, 1 to 1000
     */
    DoubleBinaryOperator echo(double frequency, int pulses);

    /**
     * The lower of the gains of the radar's antennas, dBi; empty if it is not stated. The beams of the antenna with the
     * higher gain are narrower, and several of them fit into one beam of the other antenna, so the lower gain
     * determines the number of beam positions.
     */
    OptionalDouble lowerGain();

    /**
     * The coherent integration time, s: of one pulse, or of the coherent burst that counts as one; empty if it is not
     * stated. A beam dwells on each position for this time multiplied by the number of pulses that a look integrates.
     */
    OptionalDouble dwell();

    /** The radial speed above which an echo leaves its range cell during integration, m/s; infinity if unknown. */
    default double migrationSpeed() {
        return Double.POSITIVE_INFINITY;
    }

    /**
     * The radar equation: {@code SNR = P Gt Gr lambda^2 sigma / ((4 pi)^3 r^4 k T0 B F L)} with T0 = 290 K (Skolnik,
     * Radar Handbook). P is the transmitted power, Gt and Gr are the gains of the antennas, lambda is the wavelength,
     * sigma the radar cross-section, r the range, k Boltzmann's constant, and F and L are the noise figure and the
     * losses as ratios. B is the noise bandwidth after coherent processing, one over the integration time, not that of
     * the sweep. A radar with a known system temperature T instead of a noise figure has the noise figure
     * {@code 10 lg(T / 290 K)} dB.
     *
     * @param power transmitted power, 1e-9 to 1e9 W
     * @param gain gain Gt of the antenna, for transmission and, unless stated otherwise, reception, -20 to 80 dBi
     * @param integrationTime coherent integration time, 1e-9 to 10 s: that of a pulse, or of a coherent burst that
     *     counts as one
     * @param sweepBandwidth bandwidth of the transmitted signal, 1 to 1e12 Hz
     * @param noiseFigure noise figure of the receiver, -20 to 60 dB
     * @param losses total system losses, 0 to 60 dB
     * @param receiveGain gain Gr of the receiving antenna if it is a separate one, -20 to 80 dBi
     */
    record Hardware(
            @In(value = Quantity.POWER, from = 1e-9, to = 1e9) double power,
            @In(value = Quantity.LEVEL, from = -20, to = 80) double gain,
            @In(value = Quantity.DURATION, from = 1e-9, to = 10) double integrationTime,
            @In(value = Quantity.FREQUENCY, from = 1, to = 1e12) double sweepBandwidth,
            @In(value = Quantity.LEVEL, from = -20, to = 60) double noiseFigure,
            @In(value = Quantity.LEVEL, from = 0, to = 60) double losses,
            @Minor @In(value = Quantity.LEVEL, from = -20, to = 80) Optional<Double> receiveGain)
            implements LinkBudget {
        private static final double BOLTZMANN = 1.380649e-23;
        private static final double ROOM_TEMPERATURE = 290.0;

        /** Checks the limits. */
        public Hardware {
            Limits.check(
                    Hardware.class, power, gain, integrationTime, sweepBandwidth, noiseFigure, losses, receiveGain);
        }

        /** Hardware with one antenna. */
        public Hardware(
                double power,
                double gain,
                double integrationTime,
                double sweepBandwidth,
                double noiseFigure,
                double losses) {
            this(power, gain, integrationTime, sweepBandwidth, noiseFigure, losses, Optional.empty());
        }

        /**
         * Hardware with a noise figure of 5 dB (M. A. Richards, Fundamentals of Radar Signal Processing, section 2.3: 2
         * or 3 dB to 10 dB or more), losses of 6 dB (rounded) and a sweep of 10 MHz. The losses are those of scanning
         * and processing alone: a beam-shape loss of 2.5 dB, since a scanned beam rarely points straight at the drone
         * (a Gaussian beam in two dimensions: D. K. Barton, Radar System Analysis and Modeling), 1.3 dB each for
         * Hamming weighting in range and in speed (F. J. Harris, Proc. IEEE 66, 1978), and a CFAR loss of 1.0 dB, since
         * the threshold is estimated from 32 cells (H. M. Finn and R. S. Johnson, RCA Review 29, 1968). Losses in lines
         * and radome are not included.
         */
        @Defaults({"power", "gain", "integrationTime"})
        public static Hardware of(double power, double gain, double integrationTime) {
            return new Hardware(power, gain, integrationTime, 10e6, 5.0, 6.0);
        }

        /** {@inheritDoc} The ratio does not depend on the number of pulses. */
        @Override
        public DoubleBinaryOperator echo(double frequency, int pulses) {
            return (crossSection, range) -> ofPulse(frequency, crossSection, range);
        }

        private double ofPulse(double frequency, double crossSection, double range) {
            double wavelength = LIGHT / frequency;
            double received = power
                    * wavelength
                    * wavelength
                    * crossSection
                    / (Math.pow(4.0 * Math.PI, 3) * range * range * range * range);
            double noise = BOLTZMANN * ROOM_TEMPERATURE / integrationTime;
            return 10.0 * Math.log10(received / noise) + (gain + receiveGain.orElse(gain)) - noiseFigure - losses;
        }

        /** This hardware with a separate antenna of the given gain for reception, dBi. */
        public Hardware withReceiveGain(double decibels) {
            return SettingsForm.with(this, "receiveGain", Optional.of(decibels));
        }

        /** {@inheritDoc} */
        @Override
        public OptionalDouble lowerGain() {
            return OptionalDouble.of(Math.min(gain, receiveGain.orElse(gain)));
        }

        @Override
        public OptionalDouble dwell() {
            return OptionalDouble.of(integrationTime);
        }

        @Override
        public double migrationSpeed() {
            return LIGHT / (2.0 * sweepBandwidth * integrationTime);
        }
    }

    /**
     * A link budget from a data sheet: the range at which a target is detected with a stated probability. This range
     * determines the overall gain, including that from integrating pulses; the echo then falls with the fourth power of
     * the range.
     *
     * @param range range at which the target is detected, 0.1 to 1,000,000 m
     * @param crossSection radar cross-section of that target, 1e-9 to 1e6 m2
     * @param probability probability of detection, 0.1 to 0.99
     * @param falseAlarm probability of a false alarm, 1e-12 to 0.01
     * @param fluctuation fluctuation of that target
     * @param gain gain of the radar's antenna, -20 to 80 dBi; with {@code integrationTime}, it serves only to check
     *     that the radar has time for its scan, since the stated range already accounts for it
     * @param integrationTime coherent integration time, 1e-9 to 10 s, for the same check: that of a pulse, or of a
     *     coherent burst that counts as one
     */
    record DataSheet(
            @In(value = Quantity.LENGTH, from = 0.1, to = 1e6) double range,
            @In(value = Quantity.AREA, from = 1e-9, to = 1e6) double crossSection,
            @In(value = Quantity.RATIO, from = 0.1, to = 0.99) double probability,
            @In(value = Quantity.NUMBER, from = 1e-12, to = 0.01) double falseAlarm,
            Fluctuation fluctuation,
            @Minor @In(value = Quantity.LEVEL, from = -20, to = 80) Optional<Double> gain,
            @Minor @In(value = Quantity.DURATION, from = 1e-9, to = 10) Optional<Double> integrationTime)
            implements LinkBudget {
        /** Checks the limits. */
        public DataSheet {
            Limits.check(
                    DataSheet.class, range, crossSection, probability, falseAlarm, fluctuation, gain, integrationTime);
        }

        /** A data sheet that states neither gain nor integration time. */
        public DataSheet(
                double range, double crossSection, double probability, double falseAlarm, Fluctuation fluctuation) {
            this(range, crossSection, probability, falseAlarm, fluctuation, Optional.empty(), Optional.empty());
        }

        /**
         * A data sheet with a probability of detection of 90 % for a steady target, and a probability of false alarm of
         * one in a million. At the stated range, the target has a signal-to-noise ratio of 13.18 dB: a radar with a
         * higher fixed threshold, such as the default of 15 dB, does not reach it.
         */
        @Defaults({"range", "crossSection"})
        public static DataSheet of(double range, double crossSection) {
            return new DataSheet(range, crossSection, 0.9, 1e-6, Fluctuation.STEADY);
        }

        /** This data sheet with the gain of the antenna, dBi. */
        public DataSheet withGain(double decibels) {
            return SettingsForm.with(this, "gain", Optional.of(decibels));
        }

        /** This data sheet with another coherent integration time, s. */
        public DataSheet withIntegrationTime(double seconds) {
            return SettingsForm.with(this, "integrationTime", Optional.of(seconds));
        }

        @Override
        public OptionalDouble lowerGain() {
            return gain.map(OptionalDouble::of).orElseGet(OptionalDouble::empty);
        }

        @Override
        public OptionalDouble dwell() {
            return integrationTime.map(OptionalDouble::of).orElseGet(OptionalDouble::empty);
        }

        /** The signal-to-noise ratio of each of several pulses from the target at the range, dB. */
        double required(int pulses) {
            return Detectability.required(probability, falseAlarm, fluctuation, pulses);
        }

        /**
         * {@inheritDoc} The range in the data sheet includes all processing: at that range, each pulse from the target
         * of the data sheet has the ratio that is required with that number of pulses.
         */
        @Override
        public DoubleBinaryOperator echo(double frequency, int pulses) {
            double promised = required(pulses);
            return (area, distance) ->
                    promised + 10.0 * Math.log10(area / crossSection) - 40.0 * Math.log10(distance / range);
        }
    }

    /**
     * The range at which an echo has a given signal-to-noise ratio, in clear air, m.
     *
     * @param frequency carrier frequency, Hz
     * @param crossSection radar cross-section, m2
     * @param signalToNoise the given signal-to-noise ratio, dB
     */
    default double range(double frequency, double crossSection, double signalToNoise) {
        Check.positive("crossSection", crossSection, Quantity.AREA);
        double atOneMetre = signalToNoise(frequency, crossSection, 1.0);
        return Math.pow(10.0, (atOneMetre - signalToNoise) / 40.0);
    }
}
