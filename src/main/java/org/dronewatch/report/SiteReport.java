package org.dronewatch.report;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronewatch.parallel.Workers;
import org.dronewatch.report.file.OutputDirectory;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.html.run.HtmlReport;
import org.dronewatch.report.html.run.Looks;
import org.dronewatch.report.html.run.RunLooks;
import org.dronewatch.report.html.run.RunView;
import org.dronewatch.report.provenance.Provenance;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneResult;

/** Writes {@code report.html}: draws the site of each run at its first alert and gathers the plots. */
final class SiteReport {
    static final String FILE = "report.html";

    /** How the names of the plots of individual sensors begin. */
    static final String VALUES = "value-over-range-";

    private static final int WIDTH = 1000;

    /** Image width for one of many runs, which keeps the file small. */
    private static final int WIDTH_OF_MANY = 640;

    /** With this many runs or more, images are smaller. */
    private static final int MANY_RUNS = 4;

    /** Maximum number of sensors whose plots are included. */
    private static final int MOST_PLOTS = 20;

    private final SceneResult result;
    private final Looks looks;
    private final Map<String, String> captions;

    /**
     * A report of a finished run.
     *
     * @param looks the looks recorded in all runs
     * @param captions what each plot shows, by the name of its file
     */
    SiteReport(SceneResult result, Looks looks, Map<String, String> captions) {
        this.captions = Map.copyOf(captions);
        this.result = result;
        this.looks = looks;
    }

    void write(OutputDirectory directory, Provenance provenance) throws IOException {
        List<Figure> plots = new ArrayList<>();
        for (Path plot : directory.filesIn("plots")) {
            String file = String.valueOf(plot.getFileName());
            String name = file.replace(".png", "");
            boolean blank = name.startsWith(VALUES) && !looks.hasReadings(name.substring(VALUES.length()));
            if (!blank && plots.size() < MOST_PLOTS) {
                plots.add(new Figure(captions.getOrDefault(file, name), Files.readAllBytes(plot)));
            }
        }
        try (Workers workers = new Workers(result.threads());
                OutputStream stream = new BufferedOutputStream(Files.newOutputStream(directory.file(FILE)))) {
            new HtmlReport(result, looks, run -> workers.call(() -> view(run)), plots, provenance.inWords(result))
                    .write(stream);
        }
    }

    private RunView view(RunResult run) throws IOException {
        RunLooks itsLooks = looks.ofRun(run.run()).orElseThrow();
        int width = result.runs().size() < MANY_RUNS ? WIDTH : WIDTH_OF_MANY;
        SitePictures pictures = new SitePictures(run, itsLooks.stage(), itsLooks.pointings(), width);
        List<Figure> figures = new ArrayList<>(pictures.draw(result.scene()));
        figures.addAll(new DepthPictures(run, itsLooks.stage(), itsLooks.pointings()).draw());
        figures.addAll(new RayPictures(run, itsLooks.stage(), pictures).draw(result.scene()));
        return new RunView(itsLooks.stage(), figures);
    }
}
