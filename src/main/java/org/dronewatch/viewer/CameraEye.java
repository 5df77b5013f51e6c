package org.dronewatch.viewer;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleFunction;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Ray;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.render.CameraView;
import org.dronewatch.render.photo.ColourCamera;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DronePicture;
import org.dronewatch.sensor.optics.DronePixels;
import org.dronewatch.sensor.optics.PictureSettings;
import org.dronewatch.world.World;

/** The view through one of a run's cameras at any time. For one thread at a time, except {@link #describe}. */
final class CameraEye {
    private final String id;
    private final SensorSettings<?> sensor;
    private final PictureSettings settings;
    private final Stage stage;
    private final DoubleFunction<Optional<Pointing>> pointings;
    private Optional<Pointing> pointing = Optional.empty();
    private PictureSettings pointed;
    private volatile DronePicture picture;
    private BufferedImage background;
    private ColourCamera photographer;
    private volatile boolean colour;

    /**
     * An eye that looks through a camera.
     *
     * @param sensor settings of an imaging sensor
     * @param pointings where its positioner points at a time; empty for a fixed camera
     */
    CameraEye(String id, SensorSettings<?> sensor, Stage stage, DoubleFunction<Optional<Pointing>> pointings) {
        this.id = id;
        this.sensor = sensor;
        this.settings = sensor.as(PictureSettings.class).orElseThrow();
        this.stage = stage;
        this.pointings = pointings;
        this.pointed = settings;
        this.picture = new DronePicture(new CameraObject(settings));
    }

    String id() {
        return id;
    }

    PictureSettings settings() {
        return settings;
    }

    /** Shows, from the next look on, what the camera would photograph, or distances in blues; on any thread. */
    void showColour(boolean shown) {
        colour = shown;
    }

    /** The time of its last frame up to a given time, s. */
    double frameTime(double time) {
        return CameraView.lookTime(sensor, time);
    }

    /** Its last frame up to a time, with a limited number of pixels of background. */
    CameraShot look(double time, int width, int height) {
        double frame = frameTime(time);
        turn(pointings.apply(frame + 1e-9));
        int columns = Math.max(1, Math.min(settings.width(), width));
        int rows = Math.max(1, Math.min(settings.height(), height));
        if (colour && settings.seesColour()) {
            if (photographer == null
                    || photographer.camera().width() != columns
                    || photographer.camera().height() != rows) {
                photographer =
                        new ColourCamera(picture.camera().withPixels(columns, rows), stage, ColourCamera.SAMPLES);
            }
            List<Drone> drones = stage.dronesAt(frame);
            return new CameraShot(
                    photographer.picture(drones), frame, picture.pixels(stage.world(), drones), pointing, true);
        }
        if (background == null || background.getWidth() != columns || background.getHeight() != rows) {
            CameraObject shown = picture.camera().withPixels(columns, rows);
            background =
                    new DronePicture(shown).depthImage(stage.world(), List.of()).toImage();
        }
        return new CameraShot(background, frame, picture.pixels(stage.world(), stage.dronesAt(frame)), pointing, false);
    }

    private void turn(Optional<Pointing> next) {
        if (!next.equals(pointing)) {
            pointing = next;
            pointed = Mounted.pointed(sensor, next).as(PictureSettings.class).orElseThrow();
            picture = new DronePicture(new CameraObject(pointed));
            background = null;
            photographer = null;
        }
    }

    /** A description of what a pixel shows, and its distance. */
    String describe(CameraShot shot, int column, int row) {
        for (DronePixels drone : shot.drones()) {
            if (drone.isHit(column, row)) {
                return String.format(Locale.ROOT, "%s, %.2f m", drone.drone(), drone.distance(column, row));
            }
        }
        World world = stage.world();
        Ray ray = picture.camera().seeingRay(column, row);
        return world.closestHit(ray)
                .map(found ->
                        String.format(Locale.ROOT, "%s, %.2f m", world.materialName(ray, found), found.distance()))
                .orElse("sky");
    }
}
