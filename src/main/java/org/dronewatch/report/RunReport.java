package org.dronewatch.report;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.report.html.Looks;
import org.dronewatch.report.map.SiteMap;
import org.dronewatch.scene.DetectionEvent;
import org.dronewatch.scene.Frame;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneListener;
import org.dronewatch.scene.SceneResult;
import org.dronewatch.scene.Stage;
import org.dronewatch.sensor.Curve;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.style.markers.SeriesMarkers;

/**
 * Writes the files of a run: {@code detections.csv} and, when asked for, {@code observations.csv} while it goes on,
 * {@code summary.json}, {@code report.html}, {@code plots/} and, of a scene with an origin on earth, {@code map.geojson} and
 * {@code map.kml} at its end. They appear in the directory together, once all is done.
 */
public final class RunReport implements SceneListener, AutoCloseable {
    private static final String DETECTIONS = "detections.csv";
    private static final String OBSERVATIONS = "observations.csv";

    private final Scene scene;
    private final OutputDirectory directory;
    private final Table detections;
    private final Table observations;
    private final Map<String, String> captions = new LinkedHashMap<>();
    private final RangePlots rangePlots = new RangePlots();
    private final Looks looks = new Looks();
    private Stage stage;

    /**
     * Opens the report.
     *
     * @param scene what will be run
     * @param target the directory in which the files will appear
     * @param withObservations whether to write every single observation too
     * @throws org.dronewatch.setting.InputException when the directory cannot be written
     */
    public RunReport(Scene scene, Path target, boolean withObservations) {
        this.scene = scene;
        this.directory = new OutputDirectory(target);
        try {
            this.detections = new Table(
                    directory.file(DETECTIONS),
                    "run",
                    "time_s",
                    "event",
                    "sensor",
                    "kind",
                    "drone",
                    "range_m",
                    "value",
                    "threshold",
                    "unit",
                    "heard_s");
            this.observations = withObservations
                    ? new Table(
                            directory.file(OBSERVATIONS),
                            "run",
                            "time_s",
                            "sample",
                            "sensor",
                            "kind",
                            "drone",
                            "range_m",
                            "value",
                            "threshold",
                            "unit",
                            "detected",
                            "heard_s",
                            "figures")
                    : null;
        } catch (IOException e) {
            directory.close();
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void observed(Frame frame) {
        rangePlots.add(frame);
        looks.observed(frame);
        if (observations == null) {
            return;
        }
        for (Observation o : frame.observations()) {
            observations.row(
                    Integer.toString(frame.run()),
                    Numbers.text(o.time()),
                    Long.toString(o.sample()),
                    o.sensor(),
                    o.kind(),
                    o.drone(),
                    Numbers.text(o.range()),
                    Numbers.text(o.value()),
                    Numbers.text(o.threshold()),
                    o.unit(),
                    Boolean.toString(o.isDetected()),
                    Numbers.text(o.arrival()),
                    text(o.figures()));
        }
    }

    private static String text(Map<String, Double> figures) {
        return figures.entrySet().stream()
                .map(figure -> figure.getKey() + "=" + Numbers.text(figure.getValue()))
                .collect(Collectors.joining(" "));
    }

    @Override
    public void detectionChanged(DetectionEvent event) {
        Observation o = event.observation();
        detections.row(
                Integer.toString(event.run()),
                Numbers.text(o.time()),
                event.gained() ? "gained" : "lost",
                o.sensor(),
                o.kind(),
                o.drone(),
                Numbers.text(o.range()),
                Numbers.text(o.value()),
                Numbers.text(o.threshold()),
                o.unit(),
                Numbers.text(o.arrival()));
    }

    /** Draws a curve of a sensor; it appears with the other plots. */
    public void draw(String sensor, Curve curve) {
        XYChart chart = Charts.chart(sensor + ": " + curve.title(), curve.xTitle(), curve.yTitle());
        chart.addSeries(sensor, curve.x(), curve.y()).setMarker(SeriesMarkers.NONE);
        chart.getStyler().setYAxisMin(Collections.min(curve.y()));
        chart.getStyler().setLegendVisible(false);
        Charts.write(chart, plotFile(curve.name() + "-" + sensor, sensor + ": " + curve.title()));
    }

    /** Takes the site of the first run: only with it there are a {@code report.html} and maps. */
    public void site(Stage ofFirstRun) {
        stage = ofFirstRun;
    }

    /** Writes summary, plots, maps and the report for people, and moves everything into place. */
    public void finish(SceneResult result) throws IOException {
        closeTables();
        new Summary(result).write(directory.file("summary.json"));
        SweepPlot.of(scene, result)
                .ifPresent(plot -> plot.write(plotFile("range-over-" + plot.fileName(), plot.caption())));
        rangePlots.write(result, name -> plotFile(SiteReport.VALUES + name, valueCaption(result, name)));
        if (stage != null) {
            new SiteReport(result, looks, stage, captions).write(directory);
        }
        List<String> obsolete = new ArrayList<>();
        if (stage == null) {
            obsolete.add(SiteReport.FILE);
            obsolete.addAll(SiteMap.FILES);
        } else {
            obsolete.addAll(writeMaps(result));
        }
        if (observations == null) {
            obsolete.add(OBSERVATIONS);
        }
        directory.publish(obsolete);
    }

    /** Writes the maps if the scene has an origin on earth, or tells what must not stay of an earlier run. */
    private List<String> writeMaps(SceneResult result) throws IOException {
        Optional<SiteMap> map = SiteMap.of(result, stage);
        if (map.isEmpty()) {
            return SiteMap.FILES;
        }
        map.get().writeGeoJson(directory.file(SiteMap.GEO_JSON));
        map.get().writeKml(directory.file(SiteMap.KML));
        return List.of();
    }

    private static String valueCaption(SceneResult result, String sensor) {
        SensorSettings<?> settings = result.runs().get(0).settings().sensors().get(sensor);
        return "What '" + sensor + "' (" + settings.kind()
                + ") measured, over the distance of the drone, and the threshold that it had to reach.";
    }

    private Path plotFile(String name, String caption) {
        captions.put(name + ".png", caption);
        try {
            return directory.file("plots/" + name + ".png");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void closeTables() {
        detections.close();
        if (observations != null) {
            observations.close();
        }
    }

    /** Ends the report; what was not finished leaves nothing behind. */
    @Override
    public void close() {
        try {
            closeTables();
        } finally {
            directory.close();
        }
    }
}
