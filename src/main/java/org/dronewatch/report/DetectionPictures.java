package org.dronewatch.report;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.dronewatch.geometry.AABB;
import org.dronewatch.render.Fineness;
import org.dronewatch.render.Orbit;
import org.dronewatch.render.RayCollector;
import org.dronewatch.render.RecordedRays;
import org.dronewatch.render.SitePicture;
import org.dronewatch.render.SiteState;
import org.dronewatch.render.SiteStyle;
import org.dronewatch.report.html.Figure;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.Pointings;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.SoundTracing;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DronePicture;
import org.dronewatch.sensor.optics.DronePixels;
import org.dronewatch.sensor.optics.PictureSettings;

/**
 * What single sensors perceived when they first detected a drone: depth pictures of cameras, and the rays to microphones that show
 * them. Their number and size are limited, whatever the scene has.
 */
final class DetectionPictures {
    /** Cameras with a picture, in the order of their first detections. */
    static final int MOST_CAMERAS = 4;

    /** Sensors with a picture of their rays. */
    static final int MOST_RAYS = 2;

    /** Largest width and height of a depth picture, in pixels. */
    private static final int LARGEST = 640;

    /** Smallest side of the frame about a drone, in pixels of the picture. */
    private static final double SMALLEST_FRAME = 14.0;

    private static final int DRONE = 0xff6a00;
    private static final int MARGIN = 2;

    private final RunResult run;
    private final Stage stage;
    private final Pointings pointings;
    private final int width;

    /**
     * Of a run.
     *
     * @param width columns of the pictures of the site
     */
    DetectionPictures(RunResult run, Stage stage, Pointings pointings, int width) {
        this.run = run;
        this.stage = stage;
        this.pointings = pointings;
        this.width = width;
    }

    /** The pictures: cameras first. */
    List<Figure> draw(String title) throws IOException {
        List<Figure> figures = new ArrayList<>();
        for (DetectionEvent event : run.events()) {
            Observation seen = event.observation();
            SensorSettings<?> sensor = run.settings().sensors().get(seen.sensor());
            if (figures.size() < MOST_CAMERAS
                    && first(seen.sensor()).equals(Optional.of(seen))
                    && sensor.as(PictureSettings.class).isPresent()) {
                figures.add(depth(seen, sensor));
            }
        }
        int drawn = 0;
        for (Map.Entry<String, SensorSettings<?>> entry :
                run.settings().enabledSensors().entrySet()) {
            boolean shown = entry.getValue()
                    .as(SoundTracing.class)
                    .filter(SoundTracing::drawRays)
                    .isPresent();
            if (shown && drawn < MOST_RAYS && stage.raySensors().contains(entry.getKey())) {
                Optional<Figure> figure = rays(entry.getKey(), title);
                if (figure.isPresent()) {
                    figures.add(figure.get());
                    drawn++;
                }
            }
        }
        return figures;
    }

    private Optional<Observation> first(String sensor) {
        return run.events().stream()
                .filter(event -> event.gained() && event.observation().sensor().equals(sensor))
                .map(DetectionEvent::observation)
                .findFirst();
    }

    /** As in the thesis, figure 7.1: distances in blues, and the pixels that show a drone. */
    private Figure depth(Observation seen, SensorSettings<?> sensor) throws IOException {
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
        return new Figure(
                String.format(
                        Locale.ROOT,
                        "What '%s' saw when it first detected '%s', %.1f s after the start at %.1f m: the nearer, the darker;"
                                + " the sky pale; in orange the drone's %d of %d x %d pixels.",
                        seen.sensor(),
                        seen.drone(),
                        seen.arrival(),
                        seen.range(),
                        pixels,
                        camera.width(),
                        camera.height()),
                png(image));
    }

    /** The drone's pixels at their places in a smaller picture, in a frame that is never too small to be seen. */
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
        double w = Math.max(SMALLEST_FRAME, (drone.columns() + 2 * MARGIN) * sx);
        double h = Math.max(SMALLEST_FRAME, (drone.rows() + 2 * MARGIN) * sy);
        double x = (drone.left() + 0.5 * drone.columns()) * sx - 0.5 * w;
        double y = (drone.top() + 0.5 * drone.rows()) * sy - 0.5 * h;
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(Color.WHITE);
        g.setStroke(new BasicStroke(1.5f));
        g.draw(new Rectangle2D.Double(x, y, w, h));
        g.dispose();
    }

    /** As in the thesis, figures 7.2 and 7.3: all rays from a drone to a microphone. */
    private Optional<Figure> rays(String sensor, String title) throws IOException {
        Optional<Observation> heard = first(sensor);
        double emitted = heard.map(Observation::time).orElse(0.0);
        String drone = heard.map(Observation::drone)
                .orElseGet(() ->
                        run.settings().fliers().keySet().stream().findFirst().orElse(""));
        RayCollector collector = new RayCollector(sensor, drone, emitted);
        if (!stage.traceRays(emitted, sensor, drone, collector)) {
            return Optional.empty();
        }
        RecordedRays rays = collector.toRays();
        SitePicture picture = new SitePicture(run.settings(), stage);
        AABB frame = picture.frame();
        int height = width * 3 / 5;
        SiteState state = picture.state(
                title,
                emitted,
                (one, other) -> heard.isPresent() && one.equals(sensor) && other.equals(drone),
                one -> pointings.at(one, emitted),
                Optional.of(sensor),
                Optional.of(rays));
        BufferedImage image = picture.draw(
                picture.backdrop(
                        Orbit.about(frame, (double) width / height),
                        width,
                        height,
                        picture.openRoof(emitted),
                        Fineness.FINE,
                        () -> false),
                state,
                SiteStyle.DEFAULT);
        String when = heard.map(one -> String.format(Locale.ROOT, "when it was first detected, at %.1f m", one.range()))
                .orElse("at the start; it was never detected");
        String more = rays.leftOut() == 0 ? "" : String.format(Locale.ROOT, " of %,d", rays.count() + rays.leftOut());
        return Optional.of(new Figure(
                String.format(
                        Locale.ROOT,
                        "The sound rays from '%s' to '%s' %s: %,d%s segments, coloured by level.",
                        drone,
                        sensor,
                        when,
                        rays.count(),
                        more),
                png(image)));
    }

    private static byte[] png(BufferedImage image) throws IOException {
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(image, "png", png);
        return png.toByteArray();
    }
}
