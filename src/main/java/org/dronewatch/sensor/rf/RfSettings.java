package org.dronewatch.sensor.rf;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.RadioReceiving;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.SensorDescription;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.Thresholded;
import org.dronewatch.sensor.alarm.FalseAlarming;
import org.dronewatch.sensor.alarm.FalseAlarms;
import org.dronewatch.sensor.radio.AntennaPattern;
import org.dronewatch.sensor.radio.GroundReflecting;
import org.dronewatch.sensor.radio.LinearPolarisation;
import org.dronewatch.sensor.radio.ReflectingGround;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.World;

/**
 * A radio receiver. Without a {@code beam}, it is omnidirectional.
 *
 * @param position position of its antenna, m
 * @param rate looks per second, above 0, Hz
 * @param minFrequency lowest frequency that it receives, 1e6 to 1e11 Hz (1 MHz to 100 GHz)
 * @param maxFrequency highest frequency that it receives, above the lowest and at most 1e11 Hz
 * @param gain gain of its antenna, in all directions or on the axis of its beam, -50 to 60 dBi
 * @param bandwidth noise bandwidth, 1 to 1e10 Hz
 * @param noiseFigure noise figure of its electronics, 0 to 50 dB
 * @param clutter excess path loss caused by ground, vegetation and buildings that are not in the site's models, 0 to
 *     100 dB
 * @param threshold signal-to-noise ratio at and above which a signal is detected, -50 to 100 dB
 * @param polarisation polarisation of the signals; it only affects reflection from the ground
 * @param groundReflection ground whose reflection interferes with the direct wave; none unless set
 * @param clutterIncludesEdges whether {@code clutter} includes the loss by diffraction at the edges of the site's
 *     models: if so, the greater of the two losses counts, otherwise their sum
 * @param environment surroundings, which determine the man-made noise; omit it for thermal noise alone
 * @param occupied bands in which other transmitters are on intermittently, by name; the bands must not overlap
 * @param recognised types of emission that it can recognise as a drone's
 * @param dwell time for which it listens when a transmission comes in bursts; omit it for a receiver that receives
 *     every burst
 * @param falseAlarms how often it mistakes something else for a drone; unless set, the rate is unknown, and no false
 *     alarms are simulated
 * @param beam pattern of its antenna; omit it for an omnidirectional one
 * @param aim where the axis of its beam points; it has no effect without a beam
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
        @Minor LinearPolarisation polarisation,
        @Minor Optional<ReflectingGround> groundReflection,
        @Minor boolean clutterIncludesEdges,
        @Minor Optional<ManMadeNoise> environment,
        @Minor Map<String, OccupiedBand> occupied,
        @Minor @Formerly("attributes") List<RadioLink.Emission> recognised,
        @Minor Optional<Dwell> dwell,
        @Minor Optional<FalseAlarms> falseAlarms,
        @Minor Optional<AntennaPattern> beam,
        @Minor Aim aim)
        implements SensorSettings<RfSensor>,
                Aimed,
                Thresholded,
                FalseAlarming.Stated,
                GroundReflecting,
                RadioReceiving {
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
                clutterIncludesEdges,
                environment,
                occupied,
                recognised,
                dwell,
                falseAlarms,
                beam,
                aim);
        aim.from(position);
        falseAlarms.ifPresent(known -> known.rate(rate));
        occupied = Collections.unmodifiableMap(new LinkedHashMap<>(occupied));
        recognised = List.copyOf(recognised);
        checkApart(occupied);
        if (minFrequency >= maxFrequency) {
            throw new IllegalArgumentException(
                    "minFrequency " + minFrequency + " Hz must be below maxFrequency " + maxFrequency + " Hz");
        }
    }

    private static void checkApart(Map<String, OccupiedBand> bands) {
        bands.forEach((name, band) -> bands.forEach((other, next) -> {
            if (name.compareTo(other) < 0 && band.overlaps(next)) {
                throw new IllegalArgumentException("occupied bands '" + name + "' and '" + other + "' overlap");
            }
        }));
    }

    /**
     * A receiver for 400 MHz to 6 GHz, one look per second, antenna gain 0 dBi, bandwidth 10 MHz, noise figure 6 dB, no
     * clutter, threshold 6 dB, vertical polarisation, thermal noise alone; it distinguishes the emissions of drones
     * from those of phones.
     */
    @Defaults("position")
    public static RfSettings at(Position position) {
        return new RfSettings(
                position,
                1.0,
                400e6,
                6e9,
                0.0,
                10e6,
                6.0,
                0.0,
                6.0,
                LinearPolarisation.VERTICAL,
                Optional.empty(),
                false,
                Optional.empty(),
                Map.of(),
                List.of(RadioLink.Emission.DEDICATED, RadioLink.Emission.WLAN),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Aim.Direction.DEFAULT);
    }

    @Override
    public RfSettings withPosition(Position other) {
        return SettingsForm.with(this, "position", other);
    }

    /** {@inheritDoc} True only with a beam. */
    @Override
    public boolean isDirectional() {
        return beam.isPresent();
    }

    @Override
    public RfSettings withAim(Aim other) {
        return SettingsForm.with(this, "aim", other);
    }

    /** These settings with a directional antenna. */
    public RfSettings withBeam(AntennaPattern pattern) {
        return SettingsForm.with(this, "beam", Optional.of(pattern));
    }

    /** These settings with another lowest and highest frequency, Hz. */
    public RfSettings withFrequencies(double from, double to) {
        return SettingsForm.with(this, Map.of("minFrequency", from, "maxFrequency", to));
    }

    /** These settings with another antenna gain, dBi. */
    public RfSettings withGain(double dbi) {
        return SettingsForm.with(this, "gain", dbi);
    }

    /** These settings with another excess path loss, dB. */
    public RfSettings withClutter(double decibels) {
        return SettingsForm.with(this, "clutter", decibels);
    }

    /**
     * These settings with an excess path loss that includes the loss at the edges of the site's models, or is added to
     * it.
     */
    public RfSettings withClutterIncludingEdges(boolean included) {
        return SettingsForm.with(this, "clutterIncludesEdges", included);
    }

    /** These settings with reflecting ground and another polarisation. */
    public RfSettings withGroundReflection(ReflectingGround ground, LinearPolarisation other) {
        return SettingsForm.with(this, Map.of("groundReflection", Optional.of(ground), "polarisation", other));
    }

    /** These settings with the man-made noise of a type of surroundings. */
    public RfSettings withEnvironment(ManMadeNoise noise) {
        return SettingsForm.with(this, "environment", Optional.of(noise));
    }

    /** These settings with one more band that other transmitters occupy. */
    public RfSettings withOccupied(String name, OccupiedBand band) {
        Map<String, OccupiedBand> more = new LinkedHashMap<>(occupied);
        more.put(name, band);
        return SettingsForm.with(this, "occupied", more);
    }

    /** These settings with other types of emission that the receiver can recognise as a drone's. */
    public RfSettings withRecognised(List<RadioLink.Emission> kinds) {
        return SettingsForm.with(this, "recognised", kinds);
    }

    /** These settings with dwells. */
    public RfSettings withDwell(Dwell other) {
        return SettingsForm.with(this, "dwell", Optional.of(other));
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

    /** Whether a link transmits what this receiver can recognise as a drone's, on a frequency that it receives. */
    boolean hears(RadioLink link) {
        return link.emits() && recognised.contains(link.emission()) && receives(link.frequency());
    }

    private boolean receives(double frequency) {
        return frequency >= minFrequency && frequency <= maxFrequency;
    }

    /**
     * Why this receiver does not hear a link: it transmits nothing, or nothing that can be recognised as a drone's, or
     * it transmits on a frequency that is not received; in the last case, the explanation states the limit of the
     * frequencies that are.
     */
    Explanation silence(RadioLink link) {
        if (!link.emits() || receives(link.frequency())) {
            return Explanation.of(Cause.SILENT);
        }
        return Explanation.beyond(Cause.SILENT, link.frequency() < minFrequency ? minFrequency : maxFrequency);
    }

    /** Power of the noise of the receiver alone, dBm. */
    public double noise() {
        return THERMAL + 10.0 * Math.log10(bandwidth) + noiseFigure;
    }

    /**
     * Power of the noise at a frequency, dBm: {@code 10 lg(k T0 B (fa + fr - 1) / 1 mW)}, where k is Boltzmann's
     * constant, T0 = 290 K, B the bandwidth, fa the external noise factor and fr the receiver's noise factor (ITU-R
     * P.372); without an environment, the noise of the receiver alone.
     *
     * @param frequency the frequency, Hz
     */
    public double noise(double frequency) {
        double external = environment.map(noise -> noise.ratio(frequency)).orElse(1.0);
        if (external == 1.0) {
            return noise();
        }
        double factor = external + Math.pow(10.0, 0.1 * noiseFigure) - 1.0;
        return THERMAL + 10.0 * Math.log10(bandwidth) + 10.0 * Math.log10(factor);
    }

    /** The occupied band at a frequency, Hz, with its name; at most one. */
    Optional<Map.Entry<String, OccupiedBand>> occupiedAt(double frequency) {
        return occupied.entrySet().stream()
                .filter(named -> named.getValue().contains(frequency))
                .findFirst();
    }

    /** The rise of the noise at a frequency, Hz, while others transmit there, dB; 0 where nobody does. */
    double rise(double frequency) {
        double noise = noise(frequency);
        return occupiedAt(frequency)
                .map(named -> 10.0
                        * Math.log10(
                                1.0 + Math.pow(10.0, 0.1 * (named.getValue().power(bandwidth) - noise))))
                .orElse(0.0);
    }

    /** The probability that a look intercepts a link at all. */
    double interception(RadioLink link) {
        return dwell.isPresent() && link.bursts().isPresent()
                ? dwell.get().probability(link.bursts().get(), bandwidth)
                : 1.0;
    }

    /**
     * Gain in a direction relative to that on the axis of the beam, dB; 0 without a beam.
     *
     * @param towards the direction, of any length above 0
     */
    double beamGain(Position towards) {
        return beam.isEmpty() ? 0.0 : beam.get().gain(aim.from(position), towards);
    }

    /** {@inheritDoc} The warnings concern settings that conflict, or have no effect. */
    @Override
    public List<String> advice() {
        return RfAdvice.on(this);
    }

    /** These settings with false alarms. */
    public RfSettings withFalseAlarms(FalseAlarms others) {
        return SettingsForm.with(this, "falseAlarms", Optional.of(others));
    }

    /** {@inheritDoc} The value is that of a signal that just reaches the threshold. */
    @Override
    public Reading falseReading(World world, double excess) {
        return new Reading(threshold, threshold, Quantity.LEVEL.unit());
    }

    @Override
    public SensorDescription description() {
        return SensorDescription.measuring("signal-to-noise ratio")
                .withWeakness("signal too weak")
                .withLeavesOut(
                        "Radio propagation consists of free-space loss and knife-edge diffraction at edges of terrain and"
                                + " buildings; reflections from walls are not modelled, and other emitters interfere only in occupied bands.");
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
