package org.dronewatch.sensor.camera;

import java.util.Map;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.SensorDescription;
import org.dronewatch.sensor.Thresholded;
import org.dronewatch.sensor.alarm.FalseAlarms;
import org.dronewatch.sensor.optics.FieldOfView;
import org.dronewatch.sensor.optics.Lens;
import org.dronewatch.sensor.optics.PictureSensorSettings;
import org.dronewatch.sensor.optics.Projection;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.Light;
import org.dronewatch.world.World;

/**
 * A camera, on a fixed mount or on a positioner.
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
 * @param rate frames per second, above 0, Hz
 * @param detection detection function: how a detection is decided
 * @param positioner the positioner that turns it; omit it for a fixed mount
 * @param falseAlarms how often it mistakes something else for a drone; unless set, the rate is unknown, and no false
 *     alarms are simulated
 */
public record CameraSettings(
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
        DetectionFunction detection,
        Optional<PositionerSettings> positioner,
        @Minor Optional<FalseAlarms> falseAlarms)
        implements PictureSensorSettings<CameraSettings, CameraSensor>, Thresholded {
    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public CameraSettings {
        Limits.check(
                CameraSettings.class,
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
                detection,
                positioner,
                falseAlarms);
        aim.from(position);
        PictureSensorSettings.checkPixels(width, height);
        PictureSensorSettings.checkZoom(fov, positioner);
        falseAlarms.ifPresent(known -> known.rate(rate));
    }

    /**
     * A full HD camera with a vertical field of view of 0.6918 rad (39.6 degrees), which takes 10 frames per second and
     * detects a drone at 12 pixels and above.
     */
    @Defaults("position")
    public static CameraSettings at(Position position) {
        return new CameraSettings(
                position,
                Aim.Direction.DEFAULT,
                0.0,
                1920,
                1080,
                0.6918,
                FieldOfView.VERTICAL,
                Projection.DEFAULT,
                Optional.empty(),
                Lens.GREEN,
                10.0,
                PixelThreshold.DEFAULT,
                Optional.empty(),
                Optional.empty());
    }

    /** These settings with another image size in pixels. */
    public CameraSettings withResolution(int pixelsWide, int pixelsHigh) {
        return SettingsForm.with(this, Map.of("width", pixelsWide, "height", pixelsHigh));
    }

    /** These settings with another vertical field of view, rad. */
    public CameraSettings withVerticalFov(double angle) {
        return SettingsForm.with(this, Map.of("fov", angle, "fovAxis", FieldOfView.VERTICAL));
    }

    /** These settings with another detection function. */
    public CameraSettings withDetection(DetectionFunction function) {
        return SettingsForm.with(this, "detection", function);
    }

    /** {@inheritDoc} Only a camera that counts pixels is {@link Thresholded}. */
    @Override
    public <C> Optional<C> as(Class<C> capability) {
        boolean isMissing = capability == Thresholded.class && !(detection instanceof PixelThreshold);
        return isMissing ? Optional.empty() : PictureSensorSettings.super.as(capability);
    }

    /** {@inheritDoc} The values are whole numbers of pixels. */
    @Override
    public Scale thresholdScale() {
        return new Scale("detection.pixels", Quantity.PIXELS, 1.0, (double) width * height, 1.0);
    }

    @Override
    public CameraSettings withThreshold(double pixels) {
        return withDetection(new PixelThreshold(pixels));
    }

    /** {@inheritDoc} The value is exactly at the threshold. */
    @Override
    public Reading falseReading(World world, double excess) {
        return new Reading(detection.threshold(), detection.threshold(), detection.unit());
    }

    @Override
    public SensorDescription description() {
        String decision = detection
                        .probability(new DroneView(1, 1.0, 1.0, 0.0, Light.DAY, 1.0))
                        .isPresent()
                ? "Detection by cameras depends on an assumed contrast of the drone; clutter behind it and"
                        + " compression are left out."
                : "A camera that counts pixels takes no account of contrast, haze, light or compression.";
        return PictureSensorSettings.describe(
                        detection.unit().isEmpty() ? "probability" : "pixels of the drone", decision, positioner)
                .withWeakness("too small or too faint")
                .withIgnoredConditions(detection.ignoredConditions());
    }

    @Override
    public String kind() {
        return "camera";
    }

    @Override
    public Chance chance() {
        return detection.chance();
    }

    @Override
    public CameraSensor create() {
        return new CameraSensor(this);
    }
}
