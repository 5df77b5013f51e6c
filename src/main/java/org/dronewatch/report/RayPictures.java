package org.dronewatch.report;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.render.RayCollector;
import org.dronewatch.render.RecordedRays;
import org.dronewatch.report.html.Figure;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.SoundTracing;

/**
 * The rays from a drone to each microphone whose settings ask for them, as in the thesis, figures 7.2 and 7.3: those of
 * the first detection, or of the start.
 */
final class RayPictures {
    /** Maximum number of sensors with a picture, whatever the scene has. */
    private static final int MOST_SENSORS = 2;

    private final RunResult run;
    private final Stage stage;
    private final SitePictures site;

    /**
     * The pictures of a run.
     *
     * @param site its site, over which the rays are drawn
     */
    RayPictures(RunResult run, Stage stage, SitePictures site) {
        this.run = run;
        this.stage = stage;
        this.site = site;
    }

    /** The pictures, in the order of the scene. */
    List<Figure> draw(String title) throws IOException {
        List<Figure> figures = new ArrayList<>();
        for (Map.Entry<String, SensorSettings<?>> sensor :
                run.settings().enabledSensors().entrySet()) {
            boolean isShown = sensor.getValue()
                    .as(SoundTracing.class)
                    .filter(SoundTracing::drawRays)
                    .isPresent();
            if (isShown && figures.size() < MOST_SENSORS && stage.raySensors().contains(sensor.getKey())) {
                picture(sensor.getKey(), title).ifPresent(figures::add);
            }
        }
        return figures;
    }

    private Optional<Figure> picture(String sensor, String title) throws IOException {
        Optional<Observation> heard = run.firstDetection(sensor);
        double emitted = heard.map(Observation::time).orElse(0.0);
        String drone = heard.map(Observation::drone).orElseGet(() -> run.settings().individualDrones().keySet().stream()
                .findFirst()
                .orElse(""));
        RayCollector collector = new RayCollector(sensor, drone, emitted);
        if (!stage.traceRays(emitted, sensor, drone, collector)) {
            return Optional.empty();
        }
        RecordedRays rays = collector.toRays();
        String when = heard.map(one -> String.format(
                        Locale.ROOT, "when the drone was first detected, at a range of %.1f m", one.range()))
                .orElse("at the start, since the drone was never detected");
        String more = rays.leftOut() == 0 ? "" : String.format(Locale.ROOT, " of %,d", rays.count() + rays.leftOut());
        String caption = String.format(
                Locale.ROOT,
                "The sound rays from '%s' to '%s' %s: %,d%s %s, coloured by level.",
                drone,
                sensor,
                when,
                rays.count(),
                more,
                rays.count() + rays.leftOut() == 1 ? "segment" : "segments");
        return Optional.of(site.ofRays(title, sensor, drone, emitted, heard.isPresent(), rays, caption));
    }
}
