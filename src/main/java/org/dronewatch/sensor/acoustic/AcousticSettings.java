package org.dronewatch.sensor.acoustic;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.Condition;
import org.dronewatch.sensor.DirectionFinding;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.Outlined;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.SensorDescription;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.SoundTracing;
import org.dronewatch.sensor.Thresholded;
import org.dronewatch.sensor.acoustic.array.ArraySettings;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.sensor.acoustic.propagation.Propagation;
import org.dronewatch.sensor.alarm.AzimuthSpan;
import org.dronewatch.sensor.alarm.FalseAlarming;
import org.dronewatch.sensor.alarm.FalseAlarms;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.World;

/**
 * A microphone, or an array of microphones at one position.
 *
 * @param position position of the microphone, or of the array's centre, m
 * @param radius distance within which a ray must pass the microphone to be received, above 0, m; in the energy model
 *     also the distance within which a ray traced from the microphone must pass the drone
 * @param rate looks per second, above 0, Hz
 * @param threshold level above the background that a sound must reach to be detected, dB
 * @param arrayGain gain in signal-to-noise ratio over a single microphone, 0 to 60 dB
 * @param array the microphones of an array; the gain of the array replaces {@code arrayGain}, and in the energy model
 *     the array measures directions, by which other sensors can be cued
 * @param propagation model of sound propagation: {@code level-model}, {@code energy-model}, or a kind that another jar
 *     provides
 * @param drawRays whether the report and the viewer show the sensor's rays; the report shows the rays at the first
 *     detection, or those at the start if there is none
 * @param falseAlarms how often it mistakes something else for a drone; unless set, the rate is unknown, and no false
 *     alarms are simulated
 */
public record AcousticSettings(
        Position position,
        @In(value = Quantity.LENGTH, above = 0, to = 100) double radius,
        @In(value = Quantity.FREQUENCY, above = 0, to = 10_000) double rate,
        @In(value = Quantity.LEVEL, from = -100, to = 100) double threshold,
        @In(value = Quantity.LEVEL, from = 0, to = 60) double arrayGain,
        @Minor Optional<ArraySettings> array,
        Propagation propagation,
        @Minor boolean drawRays,
        @Minor Optional<FalseAlarms> falseAlarms)
        implements SensorSettings<AcousticSensor>,
                Outlined,
                SoundTracing,
                Thresholded,
                DirectionFinding,
                FalseAlarming.Stated {
    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public AcousticSettings {
        Limits.check(
                AcousticSettings.class,
                position,
                radius,
                rate,
                threshold,
                arrayGain,
                array,
                propagation,
                drawRays,
                falseAlarms);
        falseAlarms.ifPresent(known -> known.rate(rate));
        if (array.isPresent() && arrayGain != 0.0) {
            throw new IllegalArgumentException("arrayGain " + Quantity.LEVEL.inWords(arrayGain) + " and an array of "
                    + array.get().microphones()
                    + " microphones: set only one of the two, as the gain of an array follows from its microphones");
        }
    }

    /**
     * A microphone that receives rays within 0.5 m, takes ten looks per second, and detects sound 15 dB above the
     * background. Sound propagates according to the {@linkplain LevelModel level model}, without spreading loss; for
     * physical levels, choose the energy model with {@link #withPropagation}.
     */
    @Defaults("position")
    public static AcousticSettings at(Position position) {
        return new AcousticSettings(
                position, 0.5, 10.0, 15.0, 0.0, Optional.empty(), LevelModel.DEFAULT, false, Optional.empty());
    }

    @Override
    public AcousticSettings withPosition(Position other) {
        return SettingsForm.with(this, "position", other);
    }

    /** These settings with another radius, m. */
    public AcousticSettings withRadius(double metres) {
        return SettingsForm.with(this, "radius", metres);
    }

    /** These settings with another number of looks per second, Hz. */
    public AcousticSettings withRate(double looksPerSecond) {
        return SettingsForm.with(this, "rate", looksPerSecond);
    }

    /** These settings with another threshold above the background, dB. */
    @Override
    public AcousticSettings withThreshold(double decibels) {
        return SettingsForm.with(this, "threshold", decibels);
    }

    @Override
    public Scale thresholdScale() {
        return new Scale("threshold", Quantity.LEVEL, -100.0, 100.0, Scale.FINE);
    }

    /** These settings with another array gain, dB. */
    public AcousticSettings withArrayGain(double decibels) {
        return SettingsForm.with(this, "arrayGain", decibels);
    }

    /** These settings with the microphones of an array. */
    public AcousticSettings withArray(ArraySettings microphones) {
        return SettingsForm.with(this, Map.of("array", Optional.of(microphones), "arrayGain", 0.0));
    }

    /** Gain in signal-to-noise ratio over a single microphone, dB: that of the array, if there is one. */
    public double gain() {
        return array.map(ArraySettings::gain).orElse(arrayGain);
    }

    /** {@inheritDoc} Only an array that finds directions, in a model with bands, is {@link DirectionFinding}. */
    @Override
    public <C> Optional<C> as(Class<C> capability) {
        return capability == DirectionFinding.class && !findsDirections()
                ? Optional.empty()
                : SensorSettings.super.as(capability);
    }

    private boolean findsDirections() {
        return array.map(ArraySettings::findsDirections).orElse(false) && propagation.hasBands();
    }

    /** These settings with another propagation model. */
    public AcousticSettings withPropagation(Propagation model) {
        return SettingsForm.with(this, "propagation", model);
    }

    /** These settings with or without rays in the report and the viewer. */
    public AcousticSettings withDrawRays(boolean drawn) {
        return SettingsForm.with(this, "drawRays", drawn);
    }

    /** These settings with false alarms. */
    public AcousticSettings withFalseAlarms(FalseAlarms others) {
        return SettingsForm.with(this, "falseAlarms", Optional.of(others));
    }

    /**
     * {@inheritDoc} An array that finds directions needs two numbers, for bearing and elevation; a single microphone
     * measures no direction.
     */
    @Override
    public int dimensions() {
        return findsDirections() ? 2 : 0;
    }

    /** {@inheritDoc} All directions above the horizon are equally likely. */
    @Override
    public Optional<Sighting> falseSighting(double u, double v, double w) {
        Direction direction = new Direction((2.0 * u - 1.0) * Math.PI, Math.asin(v));
        return findsDirections()
                ? Optional.of(new Sighting(position, direction, OptionalDouble.empty()))
                : Optional.empty();
    }

    /** {@inheritDoc} The value is that of a sound that just reaches the threshold above the site's background. */
    @Override
    public Reading falseReading(World world, double excess) {
        double least = detectionLevel(world.backgroundNoise().level());
        return new Reading(least, least, Quantity.LEVEL.unit());
    }

    @Override
    public Optional<AzimuthSpan> falseBearings() {
        return findsDirections() ? Optional.of(AzimuthSpan.ALL) : Optional.empty();
    }

    /**
     * The level at and above which a sound is detected over a background noise level, dB with the same reference as the
     * background.
     */
    public double detectionLevel(double background) {
        return background + threshold - gain();
    }

    @Override
    public Outline.Ball outline() {
        return new Outline.Ball(radius);
    }

    @Override
    public List<String> advice() {
        return propagation.advice();
    }

    @Override
    public SensorDescription description() {
        Map<Condition, String> ignored = new EnumMap<>(Condition.class);
        ignored.putAll(propagation.ignoredConditions());
        ignored.put(Condition.RAIN, "raise world.backgroundNoise by the noise of the rain");
        return SensorDescription.measuring(propagation.measures())
                .withWeakness("too quiet")
                .withLeavesOut(propagation.leavesOut())
                .withIgnoredConditions(ignored);
    }

    @Override
    public String kind() {
        return "acoustic";
    }

    @Override
    public double signalSpeed(World world) {
        return propagation.signalSpeed(world);
    }

    @Override
    public AcousticSensor create() {
        return new AcousticSensor(this);
    }
}
