package org.dronewatch.report;

import java.awt.image.BufferedImage;
import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.imageio.ImageIO;
import org.dronewatch.parallel.Workers;
import org.dronewatch.picture.Backdrop;
import org.dronewatch.picture.Fineness;
import org.dronewatch.picture.Orbit;
import org.dronewatch.picture.SitePicture;
import org.dronewatch.picture.SiteState;
import org.dronewatch.picture.SiteStyle;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.html.HtmlReport;
import org.dronewatch.report.html.Looks;
import org.dronewatch.scene.AlertResult;
import org.dronewatch.scene.DetectionEvent;
import org.dronewatch.scene.RunResult;
import org.dronewatch.scene.SceneResult;
import org.dronewatch.scene.Stage;

/** Writes {@code report.html}: draws the site at the first detection and gathers the plots. */
final class SiteReport {
    static final String FILE = "report.html";

    /** How the names of plots of single sensors begin. */
    static final String VALUES = "value-over-range-";

    private static final int WIDTH = 1000;
    private static final int HEIGHT = 600;

    /** Of a great site the plots of the first sensors are in it. */
    private static final int MOST_PLOTS = 20;

    private final SceneResult result;
    private final Looks looks;
    private final Stage stage;
    private final Map<String, String> captions;

    /**
     * A report of a finished run.
     *
     * @param captions what each plot shows, by the name of its file
     */
    SiteReport(SceneResult result, Looks looks, Stage stage, Map<String, String> captions) {
        this.captions = Map.copyOf(captions);
        this.result = result;
        this.looks = looks;
        this.stage = stage;
    }

    void write(OutputDirectory directory) throws IOException {
        List<Figure> site;
        try (Workers workers = new Workers(result.threads())) {
            site = workers.call(this::drawSite);
        }
        List<Figure> plots = new ArrayList<>();
        for (Path plot : directory.filesIn("plots")) {
            String file = String.valueOf(plot.getFileName());
            String name = file.replace(".png", "");
            boolean blank = name.startsWith(VALUES) && !looks.hasReadings(name.substring(VALUES.length()));
            if (!blank && plots.size() < MOST_PLOTS) {
                plots.add(new Figure(captions.getOrDefault(file, name), Files.readAllBytes(plot)));
            }
        }
        try (OutputStream stream = new BufferedOutputStream(Files.newOutputStream(directory.file(FILE)))) {
            new HtmlReport(result, looks, stage, site, plots).write(stream);
        }
    }

    private List<Figure> drawSite() throws IOException {
        RunResult run = result.runs().get(0);
        SitePicture picture = new SitePicture(run.settings(), stage);
        Optional<DetectionEvent> first = run.events().stream().findFirst();
        OptionalDouble alert = run.alerts().stream()
                .map(AlertResult::time)
                .filter(OptionalDouble::isPresent)
                .mapToDouble(OptionalDouble::getAsDouble)
                .min();
        double time =
                alert.orElse(first.map(event -> event.observation().arrival()).orElse(0.0));
        SiteState state = picture.state(
                result.scene(),
                time,
                (sensor, drone) -> isDetected(run, sensor, drone, time),
                sensor -> looks.pointings().at(sensor, time),
                Optional.empty(),
                Optional.empty());
        String when = alert.isPresent()
                ? String.format(Locale.ROOT, "at the first alert, %.1f s after the start", time)
                : first.isPresent()
                        ? String.format(
                                Locale.ROOT, "when the first sensor detects a drone, %.1f s after the start", time)
                        : "at the start";
        double aspect = (double) WIDTH / HEIGHT;
        return List.of(
                figure(
                        picture,
                        Orbit.about(picture.frame(), aspect),
                        state,
                        "The site " + when + "; fields of view are drawn shortened"),
                figure(picture, Orbit.top(picture.frame(), aspect), state, "The same from above, north up"));
    }

    private static boolean isDetected(RunResult run, String sensor, String drone, double time) {
        boolean detected = false;
        for (DetectionEvent event : run.events()) {
            boolean same = event.observation().sensor().equals(sensor)
                    && event.observation().drone().equals(drone)
                    && event.observation().arrival() <= time;
            detected = same ? event.gained() : detected;
        }
        return detected;
    }

    private static Figure figure(SitePicture picture, Orbit orbit, SiteState state, String caption) throws IOException {
        Backdrop backdrop =
                picture.backdrop(orbit, WIDTH, HEIGHT, picture.openRoof(state.time()), Fineness.FINE, () -> false);
        BufferedImage image = picture.draw(backdrop, state, SiteStyle.DEFAULT);
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(image, "png", png);
        return new Figure(caption, png.toByteArray());
    }
}
