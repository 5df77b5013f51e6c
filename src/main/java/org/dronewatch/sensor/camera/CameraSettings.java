package org.dronewatch.sensor.camera;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Quantity;

/**
 * A camera that stands still.
 *
 * @param position where its centre of projection is, m
 * @param lookAt a point on its axis, m; not the position
 * @param width pixels in a row, 1 to 16384
 * @param height rows, 1 to 16384
 * @param fov field of view, above 0 and below pi, rad
 * @param fovAxis the side of the picture that the field of view spans
 * @param rate frames a second, above 0, Hz
 * @param detection decides whether the drone's pixels are enough
 */
public record CameraSettings(
        Position position,
        Position lookAt,
        @In(Quantity.PIXELS) int width,
        @In(Quantity.PIXELS) int height,
        @In(Quantity.ANGLE) double fov,
        FieldOfView fovAxis,
        @In(Quantity.FREQUENCY) double rate,
        DetectionFunction detection)
        implements SensorSettings<CameraSensor> {
    private static final int MAX_SIDE = 16384;
    private static final double MAX_RATE = 10_000.0;

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException when one does not hold
     */
    public CameraSettings {
        Check.present("position", position);
        Check.present("lookAt", lookAt);
        Check.positive("distance from 'position' to 'lookAt'", position.distance(lookAt), Quantity.LENGTH);
        Check.between("width", width, 1, MAX_SIDE, Quantity.PIXELS);
        Check.between("height", height, 1, MAX_SIDE, Quantity.PIXELS);
        Check.inside("fov", fov, 0.0, Math.PI, Quantity.ANGLE);
        Check.present("fovAxis", fovAxis);
        Check.positive("rate", rate, Quantity.FREQUENCY);
        Check.between("rate", rate, 0.0, MAX_RATE, Quantity.FREQUENCY);
        Check.present("detection", detection);
    }

    /** A full HD camera, 0.6918 rad (39.6 degrees) vertically, 10 frames a second, detecting from 12 pixels on. */
    public static CameraSettings at(Position position) {
        Position north = position.plus(new Position(0, 1, 0));
        return new CameraSettings(
                position, north, 1920, 1080, 0.6918, FieldOfView.VERTICAL, 10.0, PixelThreshold.DEFAULT);
    }

    /** These settings at another place; the camera keeps looking at the same point. */
    public CameraSettings withPosition(Position place) {
        return new CameraSettings(place, lookAt, width, height, fov, fovAxis, rate, detection);
    }

    /** These settings looking at another point, m. */
    public CameraSettings withLookAt(Position point) {
        return new CameraSettings(position, point, width, height, fov, fovAxis, rate, detection);
    }

    /** These settings with another picture size in pixels. */
    public CameraSettings withResolution(int pixelsWide, int pixelsHigh) {
        return new CameraSettings(position, lookAt, pixelsWide, pixelsHigh, fov, fovAxis, rate, detection);
    }

    /** These settings with another vertical field of view, rad. */
    public CameraSettings withVerticalFov(double angle) {
        return new CameraSettings(position, lookAt, width, height, angle, FieldOfView.VERTICAL, rate, detection);
    }

    /** These settings with another horizontal field of view, rad. */
    public CameraSettings withHorizontalFov(double angle) {
        return new CameraSettings(position, lookAt, width, height, angle, FieldOfView.HORIZONTAL, rate, detection);
    }

    /** These settings with another number of frames a second, Hz. */
    public CameraSettings withRate(double framesPerSecond) {
        return new CameraSettings(position, lookAt, width, height, fov, fovAxis, framesPerSecond, detection);
    }

    /** These settings with another way to decide. */
    public CameraSettings withDetection(DetectionFunction function) {
        return new CameraSettings(position, lookAt, width, height, fov, fovAxis, rate, function);
    }

    /** Focal length in pixels, the same for both axes: {@code (h/2) / tan(fovy/2)}. */
    public double focalLength() {
        double side = fovAxis == FieldOfView.VERTICAL ? height : width;
        return 0.5 * side / Math.tan(0.5 * fov);
    }

    @Override
    public String kind() {
        return "camera";
    }

    @Override
    public CameraSensor create() {
        return new CameraSensor(this);
    }
}
