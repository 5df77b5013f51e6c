package org.dronewatch.sensor.optics;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Positioner;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Quantity;

/**
 * Settings of a sensor that takes pictures: what it looks into is a pyramid, a picture tells directions, and a mount may turn
 * it about its aim.
 *
 * @param <S> the sensor that they create
 */
public interface PictureSensorSettings<S extends Sensor> extends SensorSettings<S>, PictureSettings {

    @Override
    default Optional<Outline> outline() {
        return Optional.of(new CameraObject(this).outline());
    }

    @Override
    default long pixels() {
        return (long) width() * height();
    }

    @Override
    default boolean tellsDirection() {
        return true;
    }

    @Override
    default Optional<Positioner> createPositioner() {
        return positioner()
                .map(mount ->
                        new Positioner(mount, position(), Direction.of(aim().from(position())), fov(), 1.0 / rate()));
    }

    @Override
    default Optional<Pointing> turnedTo(Position place) {
        return positioner().map(mount -> mount.turnedTo(position(), place, fov()));
    }

    /** The most pixels of a picture: 8192 x 8192. */
    int MOST_PIXELS = 1 << 26;

    /**
     * Checks that a picture is not larger than {@link #MOST_PIXELS}.
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
     * Checks that a mount's lens zooms in, not out.
     *
     * @param fov the camera's own field of view, rad
     * @throws IllegalArgumentException when it does not
     */
    static void checkZoom(double fov, Optional<PositionerSettings> mount) {
        mount.flatMap(PositionerSettings::zoom).ifPresent(lens -> {
            double widest = Math.max(lens.cued(), lens.tracked());
            if (widest > fov) {
                throw new IllegalArgumentException("zoom to " + Quantity.ANGLE.inWords(widest)
                        + " must be at most the camera's own field of view, fov " + Quantity.ANGLE.inWords(fov));
            }
        });
    }
}
