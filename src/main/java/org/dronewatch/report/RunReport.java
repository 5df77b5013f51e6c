package org.dronewatch.report;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.flight.FlightsFile;
import org.dronewatch.report.file.JsonFile;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.file.OutputDirectory;
import org.dronewatch.report.file.Table;
import org.dronewatch.report.html.run.Looks;
import org.dronewatch.report.html.run.RunLooks;
import org.dronewatch.report.labels.LabelPlan;
import org.dronewatch.report.labels.Labels;
import org.dronewatch.report.map.SiteMap;
import org.dronewatch.report.provenance.Provenance;
import org.dronewatch.report.provenance.ProvenanceFile;
import org.dronewatch.report.provenance.ResultKind;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.InputFiles;
import org.dronewatch.scene.Scene;
import org.dronewatch.sensor.Curve;
import org.dronewatch.sensor.Observation;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.style.markers.SeriesMarkers;

/**
 * Writes the files of a run: {@code detections.csv}, {@code flights.csv} and, on request, {@code observations.csv}
 * during the run; {@code result.json}, {@code summary.json}, {@code provenance.json} and {@code plots/} at its end;
 * and, if it was not cut short, {@code report.html} and, for a scene with a geographic origin, {@code map.geojson} and
 * {@code map.kml}. The files appear in the directory together, once all of them are complete.
 */
public final class RunReport implements SceneListener, AutoCloseable {
    private static final String DETECTIONS = "detections.csv";
    private static final String FLIGHTS = "flights.csv";
    private static final String OBSERVATIONS = "observations.csv";

    private static final String OBSERVATION_COLUMNS =
            "run,time_s,sample,sensor,kind,drone,range_m,value,threshold,unit,detected,heard_s,figures";

    private final Scene scene;
    private final OutputDirectory directory;
    private final Table detections;
    private final DetectionTable detectionRows;
    private final Table observations;
    private final FlightTable flights;
    private final Map<String, String> captions = new LinkedHashMap<>();
    private final RangePlots rangePlots = new RangePlots();
    private final Looks looks = new Looks();
    private final Instant started = Instant.now();
    private Optional<Labels> labels = Optional.empty();
    private List<String> command = List.of();
    private Optional<InputFiles> inputs = Optional.empty();

    /**
     * Opens the report.
     *
     * @param scene the scene to be run
     * @param target the directory in which the files will appear
     * @param withObservations whether to write every observation, to {@code observations.csv}
     * @throws org.dronewatch.setting.InputException when the directory cannot be written, or holds the results of
     *     another command
     */
    public RunReport(Scene scene, Path target, boolean withObservations) {
        ResultKind.RUN.checkAlone(target);
        this.scene = scene;
        this.directory = new OutputDirectory(target);
        Table opened = null;
        Table flown = null;
        try {
            opened = new Table(directory.file(DETECTIONS), DetectionTable.COLUMNS.split(","));
            this.detections = opened;
            this.detectionRows = new DetectionTable(opened);
            flown = new Table(directory.file(FLIGHTS), FlightsFile.COLUMNS.toArray(String[]::new));
            this.flights = new FlightTable(flown);
            this.observations =
                    withObservations ? new Table(directory.file(OBSERVATIONS), OBSERVATION_COLUMNS.split(",")) : null;
        } catch (IOException | RuntimeException e) {
            close(opened);
            close(flown);
            directory.close();
            throw directory.refusal(e);
        }
    }

    /** Discards a table of an aborted report. */
    private static void close(Table table) {
        if (table != null) {
            try {
                table.close();
            } catch (UncheckedIOException e) {
                // Another write error has already been reported.
                return;
            }
        }
    }

    /** Adds the pictures that some cameras take, with labels of the drones in them; to be called before the run. */
    public void label(LabelPlan plan) {
        labels = Optional.of(new Labels(plan, directory::file));
    }

    @Override
    public void runStarted(RunInfo run, Stage stage) {
        looks.runStarted(run, stage);
        flights.runStarted(run, stage);
        labels.ifPresent(written -> directory.write(() -> written.runStarted(run, stage)));
    }

    /** @throws org.dronewatch.setting.InputException when the rows cannot be written */
    @Override
    public void runEnded(RunResult result) {
        looks.runEnded(result);
        directory.write(() -> flights.runEnded(result));
    }

    /** @throws org.dronewatch.setting.InputException when the rows cannot be written */
    @Override
    public void observed(Frame frame) {
        rangePlots.add(frame);
        looks.observed(frame);
        directory.write(() -> detectionRows.addFalseAlarms(frame));
        if (observations != null) {
            directory.write(() -> writeRows(frame));
        }
        labels.ifPresent(written -> directory.write(() -> written.observed(frame)));
    }

    private void writeRows(Frame frame) {
        for (Observation o : frame.observations()) {
            observations.row(
                    Integer.toString(frame.run()),
                    Numbers.text(o.time()),
                    Long.toString(o.look().index()),
                    o.sensor(),
                    o.kind(),
                    o.drone(),
                    o.isFalse() ? "" : Numbers.text(o.range()),
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

    /** @throws org.dronewatch.setting.InputException if the row cannot be written */
    @Override
    public void detectionChanged(DetectionEvent event) {
        directory.write(() -> detectionRows.add(event));
    }

    private void draw(String sensor, Curve curve) {
        XYChart chart = Charts.chart(sensor + ": " + curve.title(), curve.xTitle(), curve.yTitle());
        chart.addSeries(sensor, curve.x(), curve.y()).setMarker(SeriesMarkers.NONE);
        chart.getStyler().setYAxisMin(Collections.min(curve.y()));
        chart.getStyler().setLegendVisible(false);
        Charts.write(chart, plotFile(curve.name() + "-" + sensor, sensor + ": " + curve.title()));
    }

    /** Records the command line in {@code provenance.json} and in the report; a run started from Java code has none. */
    public void command(List<String> arguments) {
        command = List.copyOf(arguments);
    }

    /**
     * Records the inputs of the run, with the hashes of their files, as {@code SceneRunner.inputs()} returns them after
     * the run.
     */
    public void inputs(InputFiles files) {
        inputs = Optional.of(files);
    }

    /**
     * Writes summary, plots, maps and the HTML report, and moves everything into place.
     *
     * @throws org.dronewatch.setting.InputException if writing fails; the directory is then unchanged
     */
    public void finish(SceneResult result) {
        directory.write(() -> writeAll(result));
    }

    private void writeAll(SceneResult result) throws IOException {
        closeTables();
        Provenance provenance = new Provenance(
                started,
                command,
                inputs.orElseGet(() -> InputFiles.of(result.runs().get(0).settings())));
        JsonFile.write(directory.file(ResultKind.RUN.sign()), new ResultFile(result).toJson());
        JsonFile.write(directory.file("summary.json"), new Summary(result).toJson());
        JsonFile.write(directory.file("provenance.json"), ProvenanceFile.of(provenance, result));
        SweepPlot.of(scene, result)
                .ifPresent(plot -> plot.write(plotFile("range-over-" + plot.fileName(), plot.caption())));
        rangePlots.write(result, (name, caption) -> plotFile(SiteReport.VALUES + name, caption));
        List<String> obsolete = new ArrayList<>();
        Optional<Stage> site = site(result);
        if (site.isPresent()) {
            site.get().draw(0.0, this::draw);
            new SiteReport(result, looks, captions).write(directory, provenance);
            obsolete.addAll(writeMaps(result, site.get()));
        } else {
            obsolete.add(SiteReport.FILE);
            obsolete.addAll(SiteMap.FILES);
        }
        if (observations == null) {
            obsolete.add(OBSERVATIONS);
        }
        if (labels.isPresent()) {
            labels.get().finish(result.scene());
        }
        obsolete.addAll(directory.formerLabels());
        directory.publish(obsolete);
    }

    /** The stage of the first run; empty when the scene was cut short, or this report did not listen to it. */
    private Optional<Stage> site(SceneResult result) {
        return result.complete() ? looks.ofRun(result.runs().get(0).run()).map(RunLooks::stage) : Optional.empty();
    }

    /** Writes the maps if the scene has a geographic origin; returns stale files of an earlier run. */
    private List<String> writeMaps(SceneResult result, Stage stage) throws IOException {
        Optional<SiteMap> map = SiteMap.of(result, stage);
        if (map.isEmpty()) {
            return SiteMap.FILES;
        }
        map.get().writeGeoJson(directory.file(SiteMap.GEO_JSON));
        map.get().writeKml(directory.file(SiteMap.KML));
        return List.of();
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
        try {
            detections.close();
        } finally {
            try {
                flights.close();
            } finally {
                if (observations != null) {
                    observations.close();
                }
            }
        }
    }

    /** Closes the report; an unfinished one leaves no files behind. */
    @Override
    public void close() {
        try {
            labels.ifPresent(Labels::close);
        } finally {
            try {
                closeTables();
            } finally {
                directory.close();
            }
        }
    }
}
