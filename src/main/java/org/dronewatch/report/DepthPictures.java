package org.dronewatch.report;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.dronewatch.render.DroneFrame;
import org.dronewatch.report.html.Figure;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.Pointings;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DronePicture;
import org.dronewatch.sensor.optics.DronePixels;
import org.dronewatch.sensor.optics.PictureSettings;

/**
 * What individual cameras saw when they first detected a drone, as in the thesis, figure 7.1: distances in blues, and
 * the pixels that show a drone.
 */
final class DepthPictures {
    /** Maximum number of cameras with a picture, whatever the scene has. */
    private static final int MOST_CAMERAS = 4;

    /** Largest width and height of a picture, in pixels. */
    private static final int LARGEST = 640;

    /** Smallest side of the frame around a drone, in pixels of the picture. */
    private static final double SMALLEST_FRAME = 14.0;

    private static final int DRONE = 0xff6a00;

    private final RunResult run;
    private final Stage stage;
    private final Pointings pointings;

    /** The pictures of a run. */
    DepthPictures(RunResult run, Stage stage, Pointings pointings) {
        this.run = run;
        this.stage = stage;
        this.pointings = pointings;
    }

    /** The pictures, in the order of the first detections. */
    List<Figure> draw() throws IOException {
        List<Figure> figures = new ArrayList<>();
        Set<String> seen = new HashSet<>();
        for (DetectionEvent event : run.events()) {
            Observation first = event.observation();
            SensorSettings<?> sensor = run.settings().sensors().get(first.sensor());
            if (figures.size() < MOST_CAMERAS
                    && event.gained()
                    && sensor.as(PictureSettings.class).isPresent()
                    && seen.add(first.sensor())) {
                figures.add(picture(first, sensor));
            }
        }
        return figures;
    }

    private Figure picture(Observation seen, SensorSettings<?> sensor) throws IOException {
        PictureSettings pointed = Mounted.pointed(sensor, pointings.at(seen.sensor(), seen.arrival()))
                .as(PictureSettings.class)
                .orElseThrow();
        CameraObject camera = new CameraObject(pointed);
        double scale = Math.min(1.0, (double) LARGEST / Math.max(camera.width(), camera.height()));
        int columns = Math.max(1, (int) Math.round(scale * camera.width()));
        int rows = Math.max(1, (int) Math.round(scale * camera.height()));
        BufferedImage image = new DronePicture(camera.withPixels(columns, rows))
                .depthImage(stage.world(), List.of())
                .toImage();
        int pixels = 0;
        for (DronePixels drone : new DronePicture(camera).pixels(stage.world(), stage.dronesAt(seen.arrival()))) {
            mark(image, camera, drone);
            pixels += drone.drone().equals(seen.drone()) ? drone.count() : 0;
        }
        return Figure.of(
                String.format(
                        Locale.ROOT,
                        "Picture taken by '%s' when it first detected '%s', %.1f s after the start, at a range of %.1f"
                                + " m: nearer surfaces are darker, the sky is pale, and the drone (%d of %d x %d"
                                + " pixels) is orange.",
                        seen.sensor(),
                        seen.drone(),
                        seen.arrival(),
                        seen.range(),
                        pixels,
                        camera.width(),
                        camera.height()),
                image);
    }

    /** Marks the drone's pixels in a smaller picture, without losing any, and draws a frame around them. */
    private static void mark(BufferedImage image, CameraObject camera, DronePixels drone) {
        if (drone.count() == 0) {
            return;
        }
        double sx = (double) image.getWidth() / camera.width();
        double sy = (double) image.getHeight() / camera.height();
        for (int row = drone.top(); row < drone.top() + drone.rows(); row++) {
            for (int column = drone.left(); column < drone.left() + drone.columns(); column++) {
                if (drone.isHit(column, row)) {
                    image.setRGB((int) ((column + 0.5) * sx), (int) ((row + 0.5) * sy), DRONE);
                }
            }
        }
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(Color.WHITE);
        g.setStroke(new BasicStroke(1.5f));
        Rectangle whole = new Rectangle(image.getWidth(), image.getHeight());
        g.draw(DroneFrame.about(drone, camera.width(), camera.height(), whole, SMALLEST_FRAME));
        g.dispose();
    }
}
