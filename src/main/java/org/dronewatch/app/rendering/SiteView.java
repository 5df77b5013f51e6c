package org.dronewatch.app.rendering;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleFunction;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.Backdrop;
import org.dronewatch.render.Fineness;
import org.dronewatch.render.Orbit;
import org.dronewatch.render.RayCollector;
import org.dronewatch.render.RayFilter;
import org.dronewatch.render.RecordedRays;
import org.dronewatch.render.RunHistory;
import org.dronewatch.render.SitePicture;
import org.dronewatch.render.SiteStyle;
import org.dronewatch.render.canvas.Cut;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;
import picocli.CommandLine.Option;

/** The options of {@code render} for pictures of the whole site. */
public final class SiteView {
    /** The viewpoint of a picture of the whole site. */
    public enum From {
        TOP,
        SIDE,
        ORBIT
    }

    private static final String AUTO = "auto";
    private static final String NONE = "none";
    private static final int LARGEST = 8192;

    @Option(
            names = "--size",
            defaultValue = "1280x800",
            paramLabel = "WxH",
            description = "Size of a picture of the site in pixels; ${DEFAULT-VALUE} by default.")
    private String size;

    @Option(
            names = "--focus",
            paramLabel = "ID",
            description = "Sensor or drone to centre a picture of the site on, zoomed in.")
    private String focus;

    @Option(
            names = "--bearing",
            paramLabel = "ANGLE",
            description = "Direction from which --view side or orbit shows the site, clockwise from north.")
    private String bearing;

    @Option(
            names = "--cut",
            defaultValue = AUTO,
            paramLabel = "HEIGHT",
            description = "Hides everything above this height; 'none' hides nothing. By default, a roof over most"
                    + " sensors and drones is hidden.")
    private String cut;

    @Option(
            names = "--rays",
            description =
                    "In a picture of the site, draws the rays traced by the microphone given by --focus, or by the"
                            + " first one.")
    private boolean rays;

    @Option(names = "--max-order", paramLabel = "N", description = "Draws only rays that have hit at most N surfaces.")
    private Integer maxOrder;

    @Option(names = "--heard-only", description = "Draws only rays that reached the sensor.")
    private boolean heardOnly;

    @Option(
            names = "--scale",
            defaultValue = "1",
            paramLabel = "FACTOR",
            description = "Scale of text and symbols, 0.5 to 8; ${DEFAULT-VALUE} by default.")
    private double scale;

    /** The numbers of columns and rows. */
    private int[] pixels() {
        String[] parts = size.split("x", -1);
        try {
            int width = Integer.parseInt(parts[0].strip());
            int height = Integer.parseInt(parts[parts.length - 1].strip());
            if (parts.length == 2 && width >= 64 && height >= 64 && width <= LARGEST && height <= LARGEST) {
                return new int[] {width, height};
            }
        } catch (NumberFormatException e) {
            throw new InputException("--size " + PlainText.value(size) + ": must be WIDTHxHEIGHT, as in 1280x800", e);
        }
        throw new InputException("--size " + PlainText.value(size)
                + ": must be WIDTHxHEIGHT, as in 1280x800, each from 64 to " + LARGEST);
    }

    /** Rejects options that a film cannot follow. */
    void checkFilm() {
        if (rays) {
            throw new InputException("--rays: rays are traced at a single time; a video does not show them");
        }
        int[] pixels = pixels();
        Rendering.checkFilm("--size " + size, pixels[0], pixels[1]);
    }

    /** Checks what can be checked before anything is loaded. */
    void check(SceneSettings settings) {
        pixels();
        if (!(scale >= 0.5 && scale <= 8.0)) {
            throw new InputException("--scale " + scale + ": must be 0.5 to 8");
        }
        if (maxOrder != null && maxOrder < 0) {
            throw new InputException("--max-order " + maxOrder + ": must be 0 or more");
        }
        if (focus != null
                && !settings.sensors().containsKey(focus)
                && !settings.individualDrones().containsKey(focus)) {
            List<String> known = new ArrayList<>(settings.sensors().keySet());
            known.addAll(settings.individualDrones().keySet());
            throw new InputException("--focus " + PlainText.value(focus) + ": no such sensor or drone; the scene has "
                    + String.join(", ", known));
        }
        if (rays && settings.individualDrones().isEmpty()) {
            throw new InputException("--rays: the scene has no drone");
        }
        if (heardOnly && !rays) {
            throw new InputException("--heard-only: has no effect without --rays");
        }
        if (maxOrder != null && !rays) {
            throw new InputException("--max-order " + maxOrder + ": has no effect without --rays");
        }
        bearing(0.0);
        givenCut();
    }

    private double bearing(double otherwise) {
        try {
            return bearing == null ? otherwise : Quantity.ANGLE.parse(bearing);
        } catch (IllegalArgumentException e) {
            throw new InputException("--bearing " + PlainText.value(bearing) + ": " + e.getMessage(), e);
        }
    }

    private Optional<Cut> givenCut() {
        try {
            return cut.equals(AUTO) || cut.equals(NONE)
                    ? Optional.empty()
                    : Optional.of(Cut.above(Quantity.LENGTH.parse(cut)));
        } catch (IllegalArgumentException e) {
            throw new InputException("--cut " + PlainText.value(cut) + ": " + e.getMessage(), e);
        }
    }

    /** Rejects a cut below everything in the scene, which would leave nothing to see. */
    private void checkCut(Stage stage) {
        double lowest = stage.world().bounds().minZ();
        givenCut().filter(plane -> plane.offset() <= lowest).ifPresent(plane -> {
            throw new InputException(
                    String.format(Locale.ROOT, "--cut %s: must be above the site's lowest point, %.1f m", cut, lowest));
        });
    }

    /**
     * Gives pictures of the site at any time, all seen from where the first is seen.
     *
     * @param first time of the first picture, s
     * @param detections whether to draw which sensor detects which drone, which takes the history of a whole run
     */
    DoubleFunction<BufferedImage> pictures(
            String title,
            SceneSettings settings,
            Stage stage,
            RunHistory history,
            From from,
            double first,
            boolean detections) {
        int[] pixels = pixels();
        SitePicture picture = new SitePicture(settings, stage);
        checkCut(stage);
        Optional<Cut> taken = cut.equals(AUTO) ? picture.openRoof(first) : givenCut();
        double aspect = pixels[0] / (double) pixels[1];
        Orbit orbit = orbit(picture.frame(), settings, stage.dronesAt(first), from, aspect);
        Backdrop backdrop = picture.backdrop(orbit, pixels[0], pixels[1], taken, Fineness.FINE, () -> false);
        RayFilter filter = new RayFilter(0, maxOrder == null ? Integer.MAX_VALUE : maxOrder, heardOnly);
        Optional<RecordedRays> traced = traced(settings, stage, first);
        SiteStyle style = SiteStyle.DEFAULT.withScale(scale).withFilter(filter);
        return time -> picture.draw(
                backdrop,
                picture.state(
                        title,
                        time,
                        (sensor, drone) -> detections && history.isDetected(sensor, drone, time),
                        sensor -> history.pointing(sensor, time),
                        Optional.ofNullable(focus),
                        traced),
                style);
    }

    private Orbit orbit(AABB box, SceneSettings settings, List<Drone> drones, From from, double aspect) {
        boolean deep = box.maxY() - box.minY() > box.maxX() - box.minX();
        Orbit orbit =
                switch (from) {
                    case TOP -> Orbit.top(box, aspect);
                    case SIDE -> Orbit.side(box, aspect, bearing(deep ? 0.5 * Math.PI : Math.PI));
                    case ORBIT -> Orbit.about(box, aspect);
                };
        if (from == From.ORBIT && bearing != null) {
            orbit = orbit.turned(bearing(0.0) - orbit.bearing(), 0.0);
        }
        if (focus == null) {
            return orbit;
        }
        Position centre = settings.sensors().containsKey(focus)
                ? settings.sensors().get(focus).position()
                : drones.stream()
                        .filter(drone -> drone.id().equals(focus))
                        .map(Drone::origin)
                        .findFirst()
                        .orElseThrow();
        return orbit.at(centre).showing(Math.max(4.0, 0.25 * box.diagonal()));
    }

    private Optional<RecordedRays> traced(SceneSettings settings, Stage stage, double time) {
        if (!rays) {
            return Optional.empty();
        }
        boolean isSensorGiven = focus != null && settings.sensors().containsKey(focus);
        String sensor = stage.raySensors().stream()
                .filter(id -> !isSensorGiven || id.equals(focus))
                .findFirst()
                .orElseThrow(() -> new InputException(
                        isSensorGiven
                                ? "--rays: the sensor given by --focus, " + focus + ", traces no rays"
                                : "--rays: no sensor of the scene traces rays"));
        String drone = settings.individualDrones().containsKey(focus)
                ? focus
                : settings.individualDrones().keySet().iterator().next();
        RayCollector collector = new RayCollector(sensor, drone, time);
        stage.traceRays(time, sensor, drone, collector);
        return Optional.of(collector.toRays());
    }
}
