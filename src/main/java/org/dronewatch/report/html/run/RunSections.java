package org.dronewatch.report.html.run;

import java.util.stream.Collectors;
import org.dronewatch.report.html.Html;
import org.dronewatch.run.RunResult;

/** The part of the report on one run: images, alert, detections, time line, missed detections. */
final class RunSections {
    private final RunResult run;
    private final RunLooks looks;
    private final RunView view;
    private final String level;

    /**
     * The sections of a run.
     *
     * @param level the headings' element: {@code h2}, or {@code h3} inside a collapsible section
     */
    RunSections(RunResult run, RunLooks looks, RunView view, String level) {
        this.run = run;
        this.looks = looks;
        this.view = view;
        this.level = level;
    }

    /** The run as a collapsible section of a sweep, with the verdict on this run. */
    String fold(boolean open) {
        String verdict = Html.plain("p", new Verdict(run).inWords());
        return Html.fold(SweepVerdict.title(run), verdict + html(), open);
    }

    String html() {
        Reasons reasons = new Reasons(run.settings(), view.stage(), looks.pointings(), run.simulated());
        return pictures()
                + section("Alert", new AlertTable(run).html() + new FalseAlarmTables(run).html())
                + section("Detections by sensor", new DetectionTables(run, looks).detections())
                + section(
                        "Detections over time",
                        Html.plain("p", "Bars show when each sensor detects at least one drone.")
                                + new TimelineSvg(run).draw())
                + section("Missed detections and reasons", new Misses(run, looks, reasons).tables());
    }

    private String pictures() {
        return view.pictures().stream()
                .map(figure -> Html.figure(figure.png(), figure.caption()))
                .collect(Collectors.joining());
    }

    private String section(String title, String content) {
        return Html.plain(level, title) + content;
    }
}
