package org.dronewatch.viewer;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronewatch.geometry.Hit;
import org.dronewatch.scene.Stage;
import org.dronewatch.sensor.camera.CameraSensor;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.DronePixels;
import org.dronewatch.world.World;

/** One camera of a run, for looking through at any time. For one thread at a time, except {@link #tell}. */
final class CameraEye {
    private final String id;
    private final CameraSettings settings;
    private final Stage stage;
    private final CameraSensor sensor;
    private BufferedImage background;

    CameraEye(String id, CameraSettings settings, Stage stage) {
        this.id = id;
        this.settings = settings;
        this.stage = stage;
        this.sensor = settings.create();
    }

    String id() {
        return id;
    }

    CameraSettings settings() {
        return settings;
    }

    /** When its last frame up to a time was, s. */
    double frameTime(double time) {
        return Math.floor(time * settings.rate() + 1e-6) / settings.rate();
    }

    /** Its last frame up to a time, the background in at most so many pixels. */
    CameraShot look(double time, int width, int height) {
        double frame = frameTime(time);
        int columns = Math.max(1, Math.min(settings.width(), width));
        int rows = Math.max(1, Math.min(settings.height(), height));
        if (background == null || background.getWidth() != columns || background.getHeight() != rows) {
            CameraSettings shown = settings.withVerticalFov(
                            2.0 * Math.atan(0.5 * settings.height() / settings.focalLength()))
                    .withResolution(columns, rows);
            background = shown.create().depthImage(stage.world(), List.of()).toImage();
        }
        return new CameraShot(background, frame, sensor.pixels(stage.world(), stage.dronesAt(frame)));
    }

    /** What a pixel shows, in words: how far it is, and what. */
    String tell(CameraShot shot, int column, int row) {
        for (DronePixels drone : shot.drones()) {
            if (drone.isHit(column, row)) {
                return String.format(Locale.ROOT, "%s, %.2f m", drone.drone(), drone.distance(column, row));
            }
        }
        World world = stage.world();
        Optional<Hit> hit = world.closestHit(sensor.camera().ray(column, row));
        return hit.map(found -> String.format(
                        Locale.ROOT,
                        "%s, %.2f m",
                        world.mesh().materialNames().get(world.mesh().material(found.triangle())),
                        found.distance()))
                .orElse("sky");
    }
}
