package org.dronewatch.report.html;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.scene.DetectionEvent;
import org.dronewatch.scene.PairResult;
import org.dronewatch.scene.RunResult;
import org.dronewatch.scene.SceneResult;
import org.dronewatch.scene.Stage;
import org.dronewatch.sensor.Observation;

/**
 * One file for a browser or for paper: who was detected when and by whom, what was missed and why, the site, the settings,
 * and what not to believe. Everything is in it; it asks for nothing from anywhere. The same results give the same bytes.
 */
public final class HtmlReport {
    private static final String STYLE =
            """
            body { font: 15px/1.45 system-ui, "DejaVu Sans", sans-serif; color: #20262e; max-width: 960px;
              margin: 2em auto; padding: 0 1em; }
            h1 { font-size: 1.7em; margin: 0 0 .2em; } h2 { font-size: 1.2em; margin: 1.8em 0 .5em; }
            .verdict { font-size: 1.1em; background: #f3f5f7; border-left: 5px solid #1f5fbf; padding: .7em 1em; }
            table { border-collapse: collapse; width: 100%; margin: .5em 0; }
            th, td { text-align: left; padding: .28em .55em; border-bottom: 1px solid #dfe3e7; vertical-align: top; }
            td { overflow-wrap: break-word; } td.n { white-space: nowrap; }
            th { background: #f3f5f7; }
            .wide { overflow-x: auto; }
            figure { margin: 1em 0; break-inside: avoid; } img, svg { max-width: 100%; height: auto; }
            figcaption { color: #555f69; font-size: .92em; } svg text { font: 12px system-ui, sans-serif; fill: #20262e; }
            tr, h2 { break-inside: avoid; } h2, h2 + p { break-after: avoid; } svg { break-inside: avoid; }
            @media print { body { margin: 0; max-width: none; font-size: 9.5pt; } img { max-height: 95mm; } }
            """;

    private final SceneResult result;
    private final RunResult run;
    private final Looks looks;
    private final Stage stage;
    private final List<Figure> site;
    private final List<Figure> plots;

    /**
     * A report of a finished run.
     *
     * @param looks what listened to it
     * @param stage the site of its first run
     * @param site pictures of the site
     * @param plots what the sensors measured
     */
    public HtmlReport(SceneResult result, Looks looks, Stage stage, List<Figure> site, List<Figure> plots) {
        this.result = result;
        this.run = result.runs().get(0);
        this.looks = looks;
        this.stage = stage;
        this.site = List.copyOf(site);
        this.plots = List.copyOf(plots);
    }

    /** Writes the file. */
    public void write(OutputStream target) throws IOException {
        StringBuilder page = new StringBuilder();
        page.append("<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n")
                .append("<meta charset=\"utf-8\"/>\n")
                .append("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n")
                .append(Html.plain("title", result.scene() + ": what the sensors detect"))
                .append(Html.element("style", STYLE))
                .append("</head>\n<body>\n");
        page.append(Html.plain("h1", result.scene()));
        String cut = result.complete() ? "" : " The run was cut short.";
        page.append("<p class=\"verdict\">")
                .append(Html.text(new Verdict(run).inWords() + cut))
                .append("</p>\n");
        figures(page, site);
        ResultTables tables = new ResultTables(result, looks);
        SettingTables settings = new SettingTables(result);
        section(page, "Alert", tables.alerts() + settings.rule());
        section(page, "Who detects what", tables.detections());
        section(
                page,
                "Over time",
                Html.plain("p", "A bar where a sensor detects a drone" + ofFirstRun() + ".")
                        + new TimelineSvg(run).draw());
        Reasons reasons = new Reasons(run.settings(), stage, looks.pointings(), run.simulated());
        section(page, "What was missed, and why", misses(reasons) + losses(reasons));
        if (!plots.isEmpty()) {
            section(page, "What they measured", "");
            figures(page, plots);
        }
        section(page, "Sensors", settings.sensors());
        section(page, "Where the settings come from", settings.sources());
        section(page, "Drones", settings.drones());
        section(page, "Site", settings.site());
        section(page, "What not to believe", settings.limits());
        page.append("</body>\n</html>\n");
        target.write(page.toString().getBytes(StandardCharsets.UTF_8));
    }

    private static void section(StringBuilder page, String title, String content) {
        page.append(Html.plain("h2", title)).append(content);
    }

    private static void figures(StringBuilder page, List<Figure> figures) {
        figures.forEach(figure -> page.append(Html.figure(figure.png(), figure.caption())));
    }

    private String ofFirstRun() {
        return result.runs().size() > 1 ? ", in the first of " + result.runs().size() + " runs" : "";
    }

    /** Sensors that lost a drone for the rest of the run. */
    private String losses(Reasons reasons) {
        Map<List<String>, Observation> lost = new LinkedHashMap<>();
        for (DetectionEvent event : run.events()) {
            Observation o = event.observation();
            if (event.gained()) {
                lost.remove(List.of(o.sensor(), o.drone()));
            } else {
                lost.put(List.of(o.sensor(), o.drone()), o);
            }
        }
        List<List<String>> rows = lost.values().stream()
                .limit(ResultTables.MOST_ROWS)
                .map(o -> List.of(
                        o.sensor(),
                        o.kind(),
                        o.drone(),
                        Numbers.format("%.1f", o.arrival()),
                        Numbers.format("%.1f", o.range()),
                        reasons.afterLoss(o.sensor(), o.drone(), o.arrival())))
                .toList();
        return rows.isEmpty()
                ? ""
                : Html.table(List.of("sensor", "kind", "drone", "lost at [s]", "at [m]", "from then on"), rows);
    }

    private String misses(Reasons reasons) {
        List<List<String>> rows = new ArrayList<>();
        int left = 0;
        for (PairResult pair : run.pairs()) {
            if (pair.firstDetected().isEmpty() && rows.size() == ResultTables.MOST_ROWS) {
                left++;
            } else if (pair.firstDetected().isEmpty()) {
                String why = reasons.of(pair.sensor(), pair.drone(), looks.best(0, pair.sensor(), pair.drone()));
                rows.add(List.of(pair.sensor(), pair.kind(), pair.drone(), why));
            }
        }
        return rows.isEmpty()
                ? Html.plain("p", "Nothing: every sensor detects every drone" + ofFirstRun() + ".")
                : Html.table(List.of("sensor", "kind", "drone", "why"), rows)
                        + (left > 0 ? Html.plain("p", "And " + left + " pairs of sensor and drone more.") : "");
    }
}
