package org.dronewatch.render;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleFunction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.render.photo.ColourCamera;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DepthImage;
import org.dronewatch.sensor.optics.DronePicture;
import org.dronewatch.sensor.optics.PictureSettings;

/**
 * Draws the view of a camera during a run. On a positioner, the camera points as it did at its last look, according to
 * the run's history; a camera on a fixed mount needs no history. Not thread-safe.
 */
public final class CameraView {
    /**
     * Times that differ by less than this fraction of the interval between looks, as by rounding, belong to one look.
     */
    private static final double SAME = 1e-6;

    private final SensorSettings<?> sensor;
    private final Stage stage;
    private final DoubleFunction<Optional<Pointing>> pointings;
    private Optional<Pointing> pointing = Optional.empty();
    private DronePicture picture;
    private Optional<ColourCamera> colour = Optional.empty();

    /**
     * The view of a camera.
     *
     * @param id id of the camera in its scene
     * @param sensor settings of an imaging sensor
     * @param history history of the run, at least up to the times to be drawn
     * @throws IllegalArgumentException if the sensor takes no pictures
     */
    public CameraView(String id, SensorSettings<?> sensor, Stage stage, RunHistory history) {
        this(id, sensor, stage, time -> history.pointing(id, time));
    }

    /**
     * The view of a camera.
     *
     * @param id id of the camera in its scene
     * @param sensor settings of an imaging sensor
     * @param pointings returns the pointing of the camera's positioner at a time, s since the start of the run; an
     *     empty result for a camera on a fixed mount
     * @throws IllegalArgumentException if the sensor takes no pictures
     */
    public CameraView(String id, SensorSettings<?> sensor, Stage stage, DoubleFunction<Optional<Pointing>> pointings) {
        PictureSettings picture = sensor.as(PictureSettings.class)
                .orElseThrow(() -> new IllegalArgumentException("sensor '" + id + "' takes no pictures"));
        this.sensor = sensor;
        this.stage = stage;
        this.pointings = pointings;
        this.picture = new DronePicture(new CameraObject(picture));
    }

    /** The names of the imaging sensors whose images can be drawn, in the given order. */
    public static List<String> cameras(Map<String, SensorSettings<?>> sensors) {
        return sensors.keySet().stream()
                .filter(id -> sensors.get(id).as(PictureSettings.class).isPresent())
                .toList();
    }

    /**
     * The time of a sensor's last look at or before a time.
     *
     * @param time seconds since the start of the run, 0 or more
     */
    public static double lookTime(SensorSettings<?> sensor, double time) {
        return Math.floor(time * sensor.rate() + SAME) / sensor.rate();
    }

    /**
     * The camera's depth image with the drones at a time.
     *
     * @param time seconds since the start of the run; for the picture used in the run, a {@link #lookTime}
     */
    public DepthImage draw(double time) {
        turn(pointings.apply(time));
        return picture.depthImage(stage.world(), stage.dronesAt(time));
    }

    /**
     * A photograph by the camera at a time.
     *
     * @param time seconds since the start of the run; for the picture used in the run, a {@link #lookTime}
     * @param samples each pixel is the mean of samples x samples rays, 1 to {@link ColourCamera#MOST_SAMPLES}
     */
    public BufferedImage photograph(double time, int samples) {
        turn(pointings.apply(time));
        if (colour.isEmpty()) {
            colour = Optional.of(new ColourCamera(picture.camera(), stage, samples));
        }
        return colour.get().picture(stage.dronesAt(time));
    }

    private void turn(Optional<Pointing> next) {
        if (!next.equals(pointing)) {
            pointing = next;
            colour = Optional.empty();
            picture = new DronePicture(new CameraObject(
                    Mounted.pointed(sensor, next).as(PictureSettings.class).orElseThrow()));
        }
    }
}
