package org.dronewatch.report.html.run;

import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.Page;
import org.dronewatch.report.html.SensorTables;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.advice.ConditionAdvice;

/**
 * A self-contained HTML file for a browser or for printing: the verdict over all runs, which sensor detected which
 * drone and when, what was missed and why, the site, the settings, the limitations of the model, and the provenance of
 * the results. It loads no external resources. The bytes depend only on the results and the provenance.
 */
public final class HtmlReport {
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
        /** The site of a run, with images of it. */
        RunView of(RunResult run) throws IOException;
    }

    /**
     * A report of a finished scene.
     *
     * @param looks the looks recorded in all runs
     * @param views provides the site and the images of each run; called for one run after another
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
        Page page = new Page(target, result.scene() + ": detection report", result.scene());
        writeRuns(page);
        if (!plots.isEmpty()) {
            page.section("Measured values", "");
            for (Figure plot : plots) {
                page.add(Html.figure(plot.png(), plot.caption()));
            }
        }
        SettingTables settings = new SettingTables(result);
        SensorTables sensors = new SensorTables(result.runs().get(0).settings());
        page.section("Sensors", sensors.sensors());
        page.section("Sources of the settings", sensors.sources());
        page.section("Drones", settings.drones());
        page.section("Site", settings.site() + notes());
        page.section("Limitations of the model", settings.limits());
        if (!provenance.isEmpty()) {
            page.section("Provenance", Html.definitions(provenance));
        }
        page.end();
    }

    private String notes() {
        return siteNotes.stream().map(note -> Html.plain("p", note)).collect(Collectors.joining());
    }

    private void writeRuns(Page page) throws IOException {
        List<RunResult> runs = result.runs();
        boolean sweeps = runs.size() > 1;
        String cut = result.complete() ? "" : " The run was stopped early.";
        String verdict = sweeps ? new SweepVerdict(runs).inWords() : new Verdict(runs.get(0)).inWords();
        page.verdict(verdict + cut);
        for (String line :
                ConditionAdvice.of(runs.stream().map(RunResult::settings).toList())) {
            page.warning(line);
        }
        page.add(new SettingTables(result).rule());
        if (!sweeps) {
            page.add(sections(runs.get(0), "h2").html());
            return;
        }
        RunResult worst = new SweepVerdict(runs).worst();
        page.section("All runs", Html.plain("p", rowsAndFolds()) + new RunsTable(runs).html());
        page.section("Run by run", "");
        for (RunResult run : runs) {
            if (looks.ofRun(run.run()).isPresent()) {
                page.add(sections(run, "h3").fold(run.run() == worst.run()));
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
                : "The first run and the " + (folds == 2 ? "" : (folds - 1) + " ") + "worst of all "
                        + result.runs().size()
                        + " are detailed below, with the worst one expanded; the others are listed in this table only.";
        return (which + " " + SweepVerdict.note(result.runs().get(0))).strip();
    }
}
