package org.dronewatch.sensor.rf;

import java.util.Map;
import java.util.Optional;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.SensorDescription;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.Thresholded;
import org.dronewatch.sensor.radio.Polarisation;
import org.dronewatch.sensor.radio.ReflectingGround;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * An omnidirectional radio receiver.
 *
 * @param position where its antenna is, m
 * @param rate looks per second, above 0, Hz
 * @param minFrequency lowest frequency that it receives, 1 MHz to 100 GHz, Hz
 * @param maxFrequency highest frequency that it receives, Hz
 * @param gain gain of its antenna, -50 to 60 dBi
 * @param bandwidth noise bandwidth, 1 to 1e10 Hz
 * @param noiseFigure noise figure of its electronics, 0 to 50 dB
 * @param clutter excess path loss from ground, plants and buildings that the site's models do not show, plus local
 *     noise, 0 to 100 dB
 * @param threshold signal-to-noise ratio at and above which a signal is detected, -50 to 100 dB
 * @param polarisation of the signals; it matters only where the ground reflects
 * @param groundReflection ground whose reflection interferes with the direct wave; none unless set
 * @param clutterIncludesEdges whether {@code clutter} is an allowance for everything in the way, the edges of the
 *     site's models included: then the greater of the two losses counts, otherwise their sum
 */
public record RfSettings(
        Position position,
        @In(value = Quantity.FREQUENCY, above = 0, to = 1000) double rate,
        @In(value = Quantity.FREQUENCY, from = 1e6, to = 1e11) @Formerly("lowest") double minFrequency,
        @In(value = Quantity.FREQUENCY, from = 1e6, to = 1e11) @Formerly("highest") double maxFrequency,
        @In(value = Quantity.LEVEL, from = -50, to = 60) double gain,
        @In(value = Quantity.FREQUENCY, from = 1, to = 1e10) double bandwidth,
        @In(value = Quantity.LEVEL, from = 0, to = 50) double noiseFigure,
        @In(value = Quantity.LEVEL, from = 0, to = 100) double clutter,
        @In(value = Quantity.LEVEL, from = -50, to = 100) double threshold,
        @Minor Polarisation polarisation,
        @Minor Optional<ReflectingGround> groundReflection,
        @Minor boolean clutterIncludesEdges)
        implements SensorSettings<RfSensor>, Thresholded {
    /** Power of thermal noise in 1 Hz at 290 K, dBm: 10 lg(k 290 K / 1 mW). */
    private static final double THERMAL = 10.0 * Math.log10(1.380649e-23 * 290.0 * 1000.0);

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public RfSettings {
        Limits.check(
                RfSettings.class,
                position,
                rate,
                minFrequency,
                maxFrequency,
                gain,
                bandwidth,
                noiseFigure,
                clutter,
                threshold,
                polarisation,
                groundReflection,
                clutterIncludesEdges);
        if (minFrequency >= maxFrequency) {
            throw new IllegalArgumentException(
                    "minFrequency " + minFrequency + " Hz must be below maxFrequency " + maxFrequency + " Hz");
        }
    }

    /**
     * A receiver of 400 MHz to 6 GHz, one look a second, antenna gain 0 dBi, bandwidth 10 MHz, noise figure 6 dB, no
     * clutter, threshold 6 dB, vertical polarisation.
     */
    @Defaults("position")
    public static RfSettings at(Position position) {
        return new RfSettings(
                position, 1.0, 400e6, 6e9, 0.0, 10e6, 6.0, 0.0, 6.0, Polarisation.VERTICAL, Optional.empty(), false);
    }

    @Override
    public RfSettings withPosition(Position other) {
        return SettingsForm.with(this, "position", other);
    }

    /** These settings for other frequencies, Hz. */
    public RfSettings withFrequencies(double from, double to) {
        return SettingsForm.with(this, Map.of("minFrequency", from, "maxFrequency", to));
    }

    /** These settings with another antenna, dBi. */
    public RfSettings withGain(double dbi) {
        return SettingsForm.with(this, "gain", dbi);
    }

    /** These settings with another loss by the surroundings, dB. */
    public RfSettings withClutter(double decibels) {
        return SettingsForm.with(this, "clutter", decibels);
    }

    /**
     * These settings with a clutter that includes the loss at the edges of the site's models, or comes on top of it.
     */
    public RfSettings withClutterIncludingEdges(boolean included) {
        return SettingsForm.with(this, "clutterIncludesEdges", included);
    }

    /** These settings with a ground that reflects waves of a polarisation. */
    public RfSettings withGroundReflection(ReflectingGround ground, Polarisation other) {
        return SettingsForm.with(this, Map.of("groundReflection", Optional.of(ground), "polarisation", other));
    }

    /** These settings with another threshold, dB. */
    @Override
    public RfSettings withThreshold(double decibels) {
        return SettingsForm.with(this, "threshold", decibels);
    }

    @Override
    public Scale thresholdScale() {
        return new Scale("threshold", Quantity.LEVEL, -50.0, 100.0, Scale.FINE);
    }

    /** Whether a link transmits on a frequency that this receiver receives. */
    boolean hears(RadioLink link) {
        return link.emits() && link.frequency() >= minFrequency && link.frequency() <= maxFrequency;
    }

    /** Power of the noise in the receiver, dBm. */
    public double noise() {
        return THERMAL + 10.0 * Math.log10(bandwidth) + noiseFigure;
    }

    @Override
    public SensorDescription description() {
        return SensorDescription.measuring("signal-to-noise ratio")
                .withWeakness("signal too weak")
                .withLeavesOut(
                        "Radio propagation: free-space loss plus knife-edge diffraction at the edges of the site; reflections from walls"
                                + " and interference by other emitters are not modelled.");
    }

    @Override
    public String kind() {
        return "rf";
    }

    @Override
    public RfSensor create() {
        return new RfSensor(this);
    }
}
