package org.dronewatch.report.labels;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.render.photo.ColourCamera;
import org.dronewatch.run.Frame;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DronePicture;
import org.dronewatch.sensor.optics.DronePixels;
import org.dronewatch.sensor.optics.PictureSettings;

/**
 * One camera during a run: which frames are its looks, and what it saw in them, computed by the same code as in its
 * sensor.
 */
final class LabelledCamera {
    private final String id;
    private final SensorSettings<?> sensor;
    private final Stage stage;
    private final int samples;
    private Optional<Pointing> pointing = Optional.empty();
    private DronePicture picture;
    private ColourCamera colours;
    private long nextLook;

    LabelledCamera(String id, SensorSettings<?> sensor, Stage stage, int samples) {
        this.id = id;
        this.sensor = sensor;
        this.stage = stage;
        this.samples = samples;
        turn(Optional.empty());
    }

    private void turn(Optional<Pointing> next) {
        pointing = next;
        CameraObject camera = new CameraObject(
                Mounted.pointed(sensor, next).as(PictureSettings.class).orElseThrow());
        picture = new DronePicture(camera);
        colours = new ColourCamera(camera, stage, samples);
    }

    String id() {
        return id;
    }

    CameraObject camera() {
        return picture.camera();
    }

    /** Index of the look at the time of a frame; negative if there is none. Queried once for each frame. */
    long look(Frame frame) {
        // The index is computed as in a run, with the same numbers.
        if (Double.compare(nextLook / sensor.rate(), frame.time()) != 0) {
            return -1;
        }
        Optional<Pointing> now = Optional.ofNullable(frame.pointings().get(id));
        if (!now.equals(pointing)) {
            turn(now);
        }
        return nextLook++;
    }

    /** The pixels of each drone in a frame, in the order of the frame. */
    List<DronePixels> hits(Frame frame) {
        return picture.pixels(stage.world(), frame.drones());
    }

    /** The photograph that the camera takes in a frame. */
    BufferedImage photo(Frame frame) {
        return colours.picture(frame.drones());
    }
}
