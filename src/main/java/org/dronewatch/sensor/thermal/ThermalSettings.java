package org.dronewatch.sensor.thermal;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Condition;
import org.dronewatch.sensor.Discrimination;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.SensorDescription;
import org.dronewatch.sensor.alarm.FalseAlarmRate;
import org.dronewatch.sensor.alarm.FalseAlarms;
import org.dronewatch.sensor.optics.FieldOfView;
import org.dronewatch.sensor.optics.PictureSensorSettings;
import org.dronewatch.sensor.optics.Projection;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.Weather;
import org.dronewatch.world.World;

/**
 * A thermal camera, on a fixed mount or on a positioner.
 *
 * @param position its centre of projection, m
 * @param aim aim of its axis
 * @param roll rotation about its axis, right side down, from a level horizon, -4 pi to 4 pi, rad
 * @param width pixels per row, 1 to 16384; at most 67,108,864 in the image
 * @param height rows of pixels, 1 to 16384
 * @param fov field of view, pi/18000 to 3.124 rad (0.01 to 179 degrees)
 * @param fovAxis the axis of the image along which the field of view is measured
 * @param projection position of its axis in the image, and its near and far planes
 * @param aperture diameter of the entrance pupil of its lens, which determines the blur due to diffraction, 1e-4 to
 *     10 m; omit it for a lens without diffraction
 * @param wavelength wavelength at which it operates, which determines the blur due to the lens and the air, 1e-7 to
 *     3e-5 m
 * @param rate looks per second, above 0, Hz: the rate of the frames shown to an observer; a program examines frames at
 *     the separate rate in {@code pointTargets}
 * @param netd noise-equivalent temperature difference (NETD), 1e-6 to 100 K
 * @param transmission transmittance of a kilometre of air in its band and in the weather of the scene, 1e-6 to 1
 * @param minSnr signal-to-noise ratio below which nothing is resolved, as a ratio, not in dB, above 0 and at most 1000
 * @param exposure integration time of a frame, or time constant of an uncooled detector: motion blur in this time
 *     reduces the resolution, but not the signal of point targets, 0 to 1 s
 * @param task the task that the image must support
 * @param probability probability at and above which the task counts as accomplished, above 0 and below 1; not used with
 *     {@code byChance}
 * @param byChance whether detection is random instead: one draw per encounter determines whether the observer can
 *     perform the task at all, and a capable observer then needs time to find the drone; with {@code pointTargets}, the
 *     noise of each frame is drawn
 * @param pointTargets detection, by a program, of drones that are too small for an observer; omit it for the observer
 *     model, which needs a resolved shape. It replaces the task, which must be detection
 * @param positioner the positioner that turns it; omit it for a fixed mount
 * @param falseAlarms how often it mistakes something else for a drone, whatever the cause; unless set, false alarms are
 *     those that noise causes with pointTargets; without pointTargets, the rate is unknown and none are simulated
 */
public record ThermalSettings(
        Position position,
        Aim aim,
        @Minor @In(value = Quantity.ANGLE, from = -In.TWO_TURNS, to = In.TWO_TURNS) double roll,
        @In(value = Quantity.PIXELS, from = 1, to = 16_384) int width,
        @In(value = Quantity.PIXELS, from = 1, to = 16_384) int height,
        @In(value = Quantity.ANGLE, from = In.NARROWEST, to = In.WIDEST_PICTURE) double fov,
        FieldOfView fovAxis,
        @Minor Projection projection,
        @Minor @In(value = Quantity.LENGTH, from = 1e-4, to = 10) Optional<Double> aperture,
        @Minor @In(value = Quantity.LENGTH, from = 1e-7, to = 3e-5) double wavelength,
        @In(value = Quantity.FREQUENCY, above = 0, to = 10_000) double rate,
        @In(value = Quantity.TEMPERATURE_DIFFERENCE, from = 1e-6, to = 100) @Formerly("noise") double netd,
        @In(value = Quantity.RATIO, from = 1e-6, to = 1) double transmission,
        @In(value = Quantity.NUMBER, above = 0, to = 1000) @Formerly("leastSignal") double minSnr,
        @In(value = Quantity.DURATION, from = 0, to = 1) double exposure,
        Discrimination task,
        @In(value = Quantity.RATIO, above = 0, below = 1) double probability,
        boolean byChance,
        @Minor Optional<PointTargets> pointTargets,
        Optional<PositionerSettings> positioner,
        @Minor Optional<FalseAlarms> falseAlarms)
        implements PictureSensorSettings<ThermalSettings, ThermalSensor> {
    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public ThermalSettings {
        Limits.check(
                ThermalSettings.class,
                position,
                aim,
                roll,
                width,
                height,
                fov,
                fovAxis,
                projection,
                aperture,
                wavelength,
                rate,
                netd,
                transmission,
                minSnr,
                exposure,
                task,
                probability,
                byChance,
                pointTargets,
                positioner,
                falseAlarms);
        if (pointTargets.isPresent() && task != Discrimination.DETECTION) {
            throw new IllegalArgumentException("task " + task.name().toLowerCase(Locale.ROOT)
                    + " with pointTargets: a spot can be detected, but has no shape by which it could be recognised");
        }
        aim.from(position);
        PictureSensorSettings.checkPixels(width, height);
        PictureSensorSettings.checkZoom(fov, positioner);
        double looks = rate;
        pointTargets.ifPresent(rule -> rule.checkFrames(looks));
        falseAlarms.ifPresentOrElse(
                known -> known.rate(looks), () -> pointTargets.ifPresent(rule -> rule.checkRate(looks)));
    }

    /**
     * 640 x 512 pixels over 24 degrees horizontally, 25 frames per second, NETD 50 mK, transmittance 85 % per
     * kilometre, minimum signal-to-noise ratio 2; detects at a probability of 0.5.
     */
    @Defaults("position")
    public static ThermalSettings at(Position position) {
        return new ThermalSettings(
                position,
                Aim.Direction.DEFAULT,
                0.0,
                640,
                512,
                Math.toRadians(24.0),
                FieldOfView.HORIZONTAL,
                Projection.DEFAULT,
                Optional.empty(),
                4e-6,
                25.0,
                0.05,
                0.85,
                2.0,
                0.01,
                Discrimination.DETECTION,
                0.5,
                false,
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }

    /** These settings with another noise-equivalent temperature difference, K. */
    public ThermalSettings withNetd(double kelvins) {
        return SettingsForm.with(this, "netd", kelvins);
    }

    /** These settings with another transmittance of a kilometre of air, 1e-6 to 1. */
    public ThermalSettings withTransmission(double perKilometre) {
        return SettingsForm.with(this, "transmission", perKilometre);
    }

    /** These settings with another exposure, s. */
    public ThermalSettings withExposure(double seconds) {
        return SettingsForm.with(this, "exposure", seconds);
    }

    /** These settings for another task. */
    public ThermalSettings withTask(Discrimination other) {
        return SettingsForm.with(this, "task", other);
    }

    /** These settings with {@code byChance} set or not. */
    public ThermalSettings withChance(boolean drawn) {
        return SettingsForm.with(this, "byChance", drawn);
    }

    /** These settings with a program that detects drones as spots. */
    public ThermalSettings withPointTargets(PointTargets rule) {
        return SettingsForm.with(this, "pointTargets", Optional.of(rule));
    }

    /**
     * {@inheritDoc} If {@code falseAlarms} is not set, the rate with point targets is that of noise; without them it is
     * not known.
     */
    @Override
    public Optional<FalseAlarmRate> falseAlarmRate() {
        return falseAlarms.map(known -> known.rate(rate)).or(this::rateOfNoise);
    }

    @Override
    public Optional<FalseAlarmRate> falseAlarmRate(Weather weather) {
        return falseAlarms.map(known -> known.in(weather).rate(rate)).or(this::rateOfNoise);
    }

    private Optional<FalseAlarmRate> rateOfNoise() {
        return pointTargets.map(rule -> rule.rate(pixels(), rate));
    }

    /** {@inheritDoc} The value is exactly at the threshold. */
    @Override
    public Reading falseReading(World world, double excess) {
        return new Reading(probability, probability, Quantity.RATIO.unit());
    }

    @Override
    public SensorDescription description() {
        // The absorption by the air is a setting of the camera, whatever the site's weather.
        String own = "set its 'transmission' for such weather";
        return PictureSensorSettings.describe(
                        "probability",
                        "For thermal cameras, the whole drone has a single temperature difference, whatever its"
                                + " background.",
                        positioner)
                .withWeakness("too small or too cool")
                .withIgnoredConditions(Map.of(Condition.VISIBILITY, own, Condition.RAIN, own, Condition.AIR, own));
    }

    /** {@inheritDoc} False: a thermal camera's pictures show thermal radiation. */
    @Override
    public boolean seesColour() {
        return false;
    }

    @Override
    public String kind() {
        return "thermal";
    }

    /**
     * {@inheritDoc} With {@code byChance}, once per encounter for an observer, who either can perform the task or
     * cannot, and needs time for it; in each frame for point targets, because of noise.
     */
    @Override
    public Chance chance() {
        return byChance && pointTargets.isEmpty() ? Chance.PER_ENCOUNTER : Chance.PER_LOOK;
    }

    @Override
    public ThermalSensor create() {
        return new ThermalSensor(this);
    }
}
