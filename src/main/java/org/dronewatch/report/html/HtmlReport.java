package org.dronewatch.report.html;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.ConditionAdvice;

/**
 * A self-contained HTML file for a browser or for printing: the verdict over all runs, which sensor detected which
 * drone and when, what was missed and why, the site, the settings, the limitations of the model, and the provenance of
 * the results. It loads no external resources. The bytes depend only on the results and the provenance.
 */
public final class HtmlReport {
    /**
     * Expands every section for printing and collapses it again afterwards; without scripts, the style sheet does it.
     */
    private static final String FOR_PRINT = " onbeforeprint=\"document.querySelectorAll('details:not([open])')"
            + ".forEach(function(d){d.open=true;d.dataset.shut='';})\""
            + " onafterprint=\"document.querySelectorAll('details[data-shut]')"
            + ".forEach(function(d){d.open=false;delete d.dataset.shut;})\"";

    private final SceneResult result;
    private final Looks looks;
    private final Views views;
    private final List<Figure> plots;
    private final Map<String, String> provenance;

    /** What is known of a real place, from the last run that was shown. */
    private List<String> siteNotes = List.of();

    /** Provides the site of a run when the report needs it. */
    @FunctionalInterface
    public interface Views {
        /** The site of a run and its images. */
        RunView of(RunResult run) throws IOException;
    }

    /**
     * A report of a finished scene.
     *
     * @param looks the looks recorded in all runs
     * @param views called for each run in turn
     * @param plots plots of the measured values
     * @param provenance origin of the results, as names and values; empty to omit this section
     */
    public HtmlReport(
            SceneResult result, Looks looks, Views views, List<Figure> plots, Map<String, String> provenance) {
        this.result = result;
        this.looks = looks;
        this.views = views;
        this.plots = List.copyOf(plots);
        this.provenance = provenance;
    }

    /** Writes the file, run by run. */
    public void write(OutputStream target) throws IOException {
        Writer page = new BufferedWriter(new OutputStreamWriter(target, StandardCharsets.UTF_8));
        page.append("<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n")
                .append("<meta charset=\"utf-8\"/>\n")
                .append("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n")
                .append(Html.plain("title", result.scene() + ": detection report"))
                .append(Html.element("style", style()))
                .append("</head>\n<body" + FOR_PRINT + ">\n")
                .append(Html.plain("h1", result.scene()));
        writeRuns(page);
        if (!plots.isEmpty()) {
            section(page, "Measured values", "");
            for (Figure plot : plots) {
                page.append(Html.figure(plot.png(), plot.caption()));
            }
        }
        SettingTables settings = new SettingTables(result);
        section(page, "Sensors", settings.sensors());
        section(page, "Sources of the settings", settings.sources());
        section(page, "Drones", settings.drones());
        section(page, "Site", settings.site() + notes());
        section(page, "Limitations of the model", settings.limits());
        if (!provenance.isEmpty()) {
            section(page, "Provenance", Html.definitions(provenance));
        }
        page.append("</body>\n</html>\n");
        page.flush();
    }

    private String notes() {
        return siteNotes.stream().map(note -> Html.plain("p", note)).collect(Collectors.joining());
    }

    private static String style() throws IOException {
        try (InputStream in = HtmlReport.class.getResourceAsStream("report.css")) {
            if (in == null) {
                throw new IllegalStateException("resource report.css is missing");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).replace("\r\n", "\n");
        }
    }

    private void writeRuns(Writer page) throws IOException {
        List<RunResult> runs = result.runs();
        boolean sweeps = runs.size() > 1;
        String cut = result.complete() ? "" : " The run was stopped early.";
        String verdict = sweeps ? new SweepVerdict(runs).inWords() : new Verdict(runs.get(0)).inWords();
        page.append("<p class=\"verdict\">").append(Html.text(verdict + cut)).append("</p>\n");
        for (String line :
                ConditionAdvice.of(runs.stream().map(RunResult::settings).toList())) {
            page.append("<p class=\"warning\">")
                    .append(Html.text("Warning: " + line + "."))
                    .append("</p>\n");
        }
        page.append(new SettingTables(result).rule());
        if (!sweeps) {
            page.append(sections(runs.get(0), "h2").html());
            return;
        }
        RunResult worst = new SweepVerdict(runs).worst();
        section(page, "All runs", Html.plain("p", rowsAndFolds()) + new RunsTable(runs).html());
        section(page, "Run by run", "");
        for (RunResult run : runs) {
            if (looks.ofRun(run.run()).isPresent()) {
                page.append(sections(run, "h3").fold(run.run() == worst.run()));
            }
        }
    }

    private RunSections sections(RunResult run, String level) throws IOException {
        RunView view = views.of(run);
        siteNotes = view.stage().siteNotes();
        return new RunSections(run, looks.ofRun(run.run()).orElseThrow(), view, level);
    }

    /** Explains the table of all runs and which of them are detailed below. */
    private String rowsAndFolds() {
        long folds = result.runs().stream()
                .map(run -> looks.ofRun(run.run()))
                .filter(Optional::isPresent)
                .count();
        String which = folds == result.runs().size()
                ? "Each run is detailed below, with the worst one expanded."
                : "The first run and the " + (folds - 1) + " worst of all "
                        + result.runs().size()
                        + " are detailed below, with the worst one expanded; the others are listed in this table only.";
        return (which + " " + SweepVerdict.note(result.runs().get(0))).strip();
    }

    private static void section(Writer page, String title, String content) throws IOException {
        page.append(Html.plain("h2", title)).append(content);
    }
}
