package org.dronewatch.sensor.optics;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.ImageShape;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Positioner;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.DirectionFinding;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.Outlined;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorDescription;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.alarm.AzimuthSpan;
import org.dronewatch.sensor.alarm.FalseAlarming;
import org.dronewatch.sensor.alarm.FalseAlarms;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * Settings of an imaging sensor: its field of view is a frustum, it measures directions, and it may be mounted on a
 * positioner.
 *
 * @param <C> the record that implements this: {@code withRoll} and the like return such a record
 * @param <S> the type of sensor that these settings create
 */
public interface PictureSensorSettings<C extends Record & PictureSensorSettings<C, S>, S extends Sensor>
        extends SensorSettings<S>, PictureSettings, Mounted, Outlined, DirectionFinding, FalseAlarming.Stated {

    @Override
    default C withPosition(Position other) {
        return SettingsForm.with(self(), "position", other);
    }

    @Override
    default C withAim(Aim other) {
        return SettingsForm.with(self(), "aim", other);
    }

    /** These settings aimed at another point, m. */
    default C withLookAt(Position point) {
        return withAim(new Aim.Target(point));
    }

    /** These settings with another roll about the camera's axis, its right side down, rad. */
    default C withRoll(double angle) {
        return SettingsForm.with(self(), "roll", angle);
    }

    /**
     * These settings with the roll about the camera's present axis at which a vector points to the top of the image.
     *
     * @throws IllegalArgumentException when the vector is parallel to that axis
     */
    default C withUp(Position up) {
        return withRoll(CameraAxes.roll(aim().from(position()), up));
    }

    /** These settings with another horizontal field of view, rad. */
    default C withHorizontalFov(double angle) {
        return SettingsForm.with(self(), Map.of("fov", angle, "fovAxis", FieldOfView.HORIZONTAL));
    }

    /** These settings with another frame rate, Hz. */
    default C withRate(double framesPerSecond) {
        return SettingsForm.with(self(), "rate", framesPerSecond);
    }

    /** These settings with a lens with diffraction, given the diameter of its entrance pupil, m. */
    default C withAperture(double diameter) {
        return SettingsForm.with(self(), "aperture", Optional.of(diameter));
    }

    /** These settings at another wavelength, m. */
    default C withWavelength(double metres) {
        return SettingsForm.with(self(), "wavelength", metres);
    }

    /** These settings with another projection. */
    default C withProjection(Projection other) {
        return SettingsForm.with(self(), "projection", other);
    }

    /** These settings on a positioner. */
    default C withPositioner(PositionerSettings positioner) {
        return SettingsForm.with(self(), "positioner", Optional.of(positioner));
    }

    @Override
    default C pointed(Pointing pointing) {
        Aim aim = Aim.Direction.of(pointing.direction());
        return SettingsForm.with(self(), Map.of("aim", aim, "fov", pointing.fov(), "positioner", Optional.empty()));
    }

    @Override
    default Outline outline() {
        return new CameraObject(this).outline();
    }

    @Override
    default Optional<Positioner> createPositioner() {
        return positioner()
                .map(mount -> new Positioner(
                        mount, position(), Direction.of(aim().from(position())), fov(), shape(), 1.0 / rate()));
    }

    private ImageShape shape() {
        double ratio = (double) width() / height();
        return fovAxis() == FieldOfView.HORIZONTAL ? new ImageShape(1.0, 1.0 / ratio) : new ImageShape(ratio, 1.0);
    }

    @Override
    default Optional<Pointing> turnedTo(Position target) {
        return positioner().map(turning -> turning.turnedTo(position(), target, fov()));
    }

    /**
     * The number of pixels on a drone at and above which the positioner follows it even if it is not detected; infinite
     * on a fixed mount.
     */
    default double lockPixels() {
        return positioner().map(PositionerSettings::lockPixels).orElse(Double.POSITIVE_INFINITY);
    }

    /**
     * The sighting of a drone in an image: its direction, to a pixel or better, and its apparent size, but no range.
     *
     * @param drone position of the drone, m
     * @param pixels number of pixels that it covers
     * @param camera the camera that took the image
     */
    default Sighting sighting(Position drone, double pixels, CameraObject camera) {
        double[] view = new double[3];
        camera.toView(drone.x(), drone.y(), drone.z(), view, 0);
        double cosine = view[2] / drone.distance(position());
        // Off the axis, a pixel subtends a solid angle that is smaller by the cube of the cosine.
        double pixel = Math.pow(Math.max(0.0, cosine), 1.5) / camera.focalLength();
        double size = pixel * Math.sqrt(Math.max(1.0, pixels));
        Direction direction = Direction.of(drone.minus(position()));
        return new Sighting(position(), direction, OptionalDouble.empty(), true, pixel, OptionalDouble.of(size));
    }

    /** These settings with false alarms. */
    default C withFalseAlarms(FalseAlarms others) {
        return SettingsForm.with(self(), "falseAlarms", Optional.of(others));
    }

    /** {@inheritDoc} The numbers represent the column and the row of the image. */
    @Override
    default int dimensions() {
        return 2;
    }

    /** {@inheritDoc} All pixels are equally likely, and a false alarm covers one pixel. */
    @Override
    default Optional<Sighting> falseSighting(double u, double v, double w) {
        int column = (int) Math.min(width() - 1.0, u * width());
        int row = (int) Math.min(height() - 1.0, v * height());
        return Optional.of(sighting(position().plus(direction(column, row)), 1.0, new CameraObject(this)));
    }

    private Position direction(int column, int row) {
        double[] direction = new double[3];
        new CameraObject(this).direction(column, row, direction);
        return new Position(direction[0], direction[1], direction[2]);
    }

    /**
     * {@inheritDoc} The bearings extend from the left to the right edge of the image; they are unknown for a camera
     * that is on a positioner, aimed steeply, or rolled.
     */
    @Override
    default Optional<AzimuthSpan> falseBearings() {
        double left = Direction.of(direction(0, height() / 2)).azimuth();
        double right = Direction.of(direction(width() - 1, height() / 2)).azimuth();
        double span = Math.IEEEremainder(right - left, 2.0 * Math.PI);
        double elevation = Direction.of(aim().from(position())).elevation();
        boolean isLevel = Math.abs(elevation) <= STEEP && Math.abs(Math.IEEEremainder(roll(), Math.PI)) <= STEEP;
        return positioner().isPresent() || !isLevel || !(span > 0.0)
                ? Optional.empty()
                : Optional.of(new AzimuthSpan(left + 0.5 * span, span));
    }

    /** Beyond this elevation or roll, the edges of an image do not bound its azimuths, rad. */
    double STEEP = Math.PI / 4;

    /**
     * These settings with the frustum of OpenGL's {@code glFrustum}: its field of view, its shifts and its planes.
     *
     * @param left left edge of the image at the near plane, measured to the right from the axis, m
     * @param right right edge, m
     * @param bottom bottom edge, measured up from the axis, m
     * @param top top edge, m
     * @param near distance of the near plane, above 0, m
     * @param far distance of the far plane, m
     * @throws IllegalArgumentException when the edges are in the wrong order, pixels would not be square to within a
     *     millionth, or a resulting setting is out of range
     */
    default C withFrustum(double left, double right, double bottom, double top, double near, double far) {
        double wide = right - left;
        double high = top - bottom;
        if (!(wide > 0.0 && high > 0.0 && near > 0.0)) {
            throw new IllegalArgumentException(
                    "frustum with left " + left + ", right " + right + ", bottom " + bottom + ", top " + top + ", near "
                            + near + ": left must be less than right, bottom less than top, near above 0");
        }
        double across = wide / width();
        double upwards = high / height();
        if (!(Math.abs(across / upwards - 1.0) <= 1e-6)) {
            throw new IllegalArgumentException("frustum of " + wide + " m x " + high + " m has pixels of " + across
                    + " m x " + upwards + " m in an image of " + width() + " x " + height()
                    + ": pixels must be square");
        }
        Projection projection = new Projection(0.5 * (left + right) / wide, 0.5 * (bottom + top) / high, near, far);
        double fov = 2.0 * Math.atan(0.5 * high / near);
        return SettingsForm.with(self(), Map.of("fov", fov, "fovAxis", FieldOfView.VERTICAL, "projection", projection));
    }

    /** The record itself: every implementation names itself as {@code C}. */
    @SuppressWarnings("unchecked")
    private C self() {
        return (C) this;
    }

    /** Maximum number of pixels of an image: 8192 x 8192. */
    int MOST_PIXELS = 1 << 26;

    /**
     * Checks that an image is not larger than {@link #MOST_PIXELS}.
     *
     * @throws IllegalArgumentException when it is
     */
    static void checkPixels(int width, int height) {
        long pixels = (long) width * height;
        if (pixels > MOST_PIXELS) {
            throw new IllegalArgumentException("width " + width + " px x height " + height + " px = " + pixels
                    + " px must be at most " + MOST_PIXELS + " px");
        }
    }

    /**
     * The texts for reports about a camera, with or without a positioner.
     *
     * @param measures the quantity that its observations measure
     * @param leftOut a sentence about the effects that its model leaves out
     */
    static SensorDescription describe(String measures, String leftOut, Optional<PositionerSettings> positioner) {
        SensorDescription description = SensorDescription.measuring(measures);
        return positioner.isPresent()
                ? description.withLeavesOut(leftOut, PositionerSettings.LEFT_OUT)
                : description.withLeavesOut(leftOut);
    }

    /**
     * Checks that a positioner's lens zooms in, not out.
     *
     * @param fov the camera's own field of view, rad
     * @throws IllegalArgumentException when a field of view of the lens is wider than {@code fov}
     */
    static void checkZoom(double fov, Optional<PositionerSettings> positioner) {
        positioner.flatMap(PositionerSettings::zoom).ifPresent(lens -> {
            double widest = Math.max(lens.cued(), lens.tracked());
            if (widest > fov) {
                throw new IllegalArgumentException("zoom to " + Quantity.ANGLE.inWords(widest)
                        + " must be at most the camera's own field of view, fov " + Quantity.ANGLE.inWords(fov));
            }
        });
    }
}
