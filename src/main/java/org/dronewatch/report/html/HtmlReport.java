package org.dronewatch.report.html;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.dronewatch.geometry.Position;
import org.dronewatch.scene.DetectionEvent;
import org.dronewatch.scene.PairResult;
import org.dronewatch.scene.RunResult;
import org.dronewatch.scene.SceneResult;
import org.dronewatch.scene.SceneSettings;
import org.dronewatch.scene.Stage;
import org.dronewatch.sensor.SensorSettings;

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
            td:last-child { overflow-wrap: anywhere; }
            th { background: #f3f5f7; }
            figure { margin: 1em 0; break-inside: avoid; } img, svg { max-width: 100%; height: auto; }
            figcaption { color: #555f69; font-size: .92em; } svg text { font: 12px system-ui, sans-serif; fill: #20262e; }
            tr, h2 { break-inside: avoid; } h2 { break-after: avoid; }
            @media print { body { margin: 0; max-width: none; font-size: 9.5pt; } img { max-height: 95mm; } }
            """;

    /** Of more drones than these, as in a large swarm, only the table tells. */
    private static final int MOST_SENTENCES = 20;

    private final SceneResult result;
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
        this.looks = looks;
        this.stage = stage;
        this.site = List.copyOf(site);
        this.plots = List.copyOf(plots);
    }

    private SceneSettings settings() {
        return result.runs().get(0).settings();
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
        page.append("<p class=\"verdict\">").append(Html.text(verdict())).append("</p>\n");
        site.forEach(figure -> page.append(Html.figure(figure.png(), figure.caption())));
        page.append(detections());
        page.append(Html.plain("h2", "Over time"))
                .append(Html.plain("p", "A bar where a sensor detects a drone" + ofFirstRun() + "."))
                .append(new TimelineSvg(result.runs().get(0)).draw());
        page.append(misses());
        if (!plots.isEmpty()) {
            page.append(Html.plain("h2", "What they measured"));
            plots.forEach(figure -> page.append(Html.figure(figure.png(), figure.caption())));
        }
        page.append(parameters());
        page.append(limits());
        page.append("</body>\n</html>\n");
        target.write(page.toString().getBytes(StandardCharsets.UTF_8));
    }

    private String ofFirstRun() {
        return result.runs().size() > 1 ? ", in the first of " + result.runs().size() + " runs" : "";
    }

    /** One sentence a drone: who detects it first, how far away, how early. */
    private String verdict() {
        List<String> sentences = new ArrayList<>();
        List<String> drones = List.copyOf(settings().fliers().keySet());
        RunResult run = result.runs().get(0);
        for (String drone : drones.subList(0, Math.min(drones.size(), MOST_SENTENCES))) {
            Optional<PairResult> first = run.pairs().stream()
                    .filter(pair ->
                            pair.drone().equals(drone) && pair.firstDetected().isPresent())
                    .min(Comparator.comparingDouble(pair -> pair.firstDetected().getAsDouble()));
            long missing = run.pairs().stream()
                    .filter(pair ->
                            pair.drone().equals(drone) && pair.firstDetected().isEmpty())
                    .count();
            sentences.add(first.map(pair -> format(
                            "'%s' is first detected by '%s' (%s), %s m away, %s s after the start; %s.",
                            drone,
                            pair.sensor(),
                            pair.kind(),
                            Reasons.number(pair.range().orElseThrow()),
                            Reasons.number(pair.firstDetected().getAsDouble()),
                            missing == 0
                                    ? "all sensors detect it"
                                    : missing + " of " + settings().sensors().size() + " sensors never detect it"))
                    .orElse("'" + drone + "' is not detected by any sensor."));
        }
        if (drones.size() > MOST_SENTENCES) {
            sentences.add("The table tells of " + (drones.size() - MOST_SENTENCES) + " more drones.");
        }
        String note = result.complete() ? "" : " The run was cut short.";
        return String.join(" ", sentences) + note;
    }

    private String detections() {
        boolean sweeps = result.runs().size() > 1;
        List<String> head = new ArrayList<>(List.of(
                "sensor",
                "kind",
                "drone",
                "first detected [s]",
                "at [m]",
                "last [s]",
                "farthest [m]",
                "looks that detect"));
        if (sweeps) {
            head.add(0, "run");
        }
        List<List<String>> rows = new ArrayList<>();
        for (PairResult pair : result.pairs()) {
            List<String> row = new ArrayList<>(List.of(
                    pair.sensor(),
                    pair.kind(),
                    pair.drone(),
                    number(pair.firstDetected()),
                    number(pair.range()),
                    last(pair),
                    number(pair.maxRange()),
                    format("%.0f %%", 100.0 * looks.share(pair.run(), pair.sensor(), pair.drone()))));
            if (sweeps) {
                row.add(0, withSwept(pair.run()));
            }
            rows.add(row);
        }
        return Html.plain("h2", "Who detects what") + Html.table(head, rows);
    }

    /** Until when a sensor detects a drone: when it loses it for the last time. */
    private String last(PairResult pair) {
        RunResult run = result.runs().get(pair.run());
        String last = "never";
        for (DetectionEvent event : run.events()) {
            if (event.observation().sensor().equals(pair.sensor())
                    && event.observation().drone().equals(pair.drone())) {
                last = event.gained()
                        ? "to the end"
                        : format("%.1f", event.observation().arrival());
            }
        }
        return last;
    }

    private String withSwept(int run) {
        SceneSettings settings = result.runs().get(run).settings();
        return run
                + settings.sweep()
                        .map(sweep -> ": "
                                + sweep.parameter().substring(sweep.parameter().lastIndexOf('.') + 1) + " "
                                + shortNumber(sweep.valueIn(settings)))
                        .orElse("");
    }

    private static String shortNumber(Object value) {
        return value instanceof Double number ? format("%.4g", number) : value.toString();
    }

    private String misses() {
        Reasons reasons = new Reasons(settings(), stage);
        List<List<String>> rows = new ArrayList<>();
        for (PairResult pair : result.runs().get(0).pairs()) {
            if (pair.firstDetected().isEmpty()) {
                String why = reasons.of(pair.sensor(), pair.drone(), looks.best(0, pair.sensor(), pair.drone()));
                rows.add(List.of(pair.sensor(), pair.kind(), pair.drone(), why));
            }
        }
        String head = Html.plain("h2", "What was missed, and why");
        return rows.isEmpty()
                ? head + Html.plain("p", "Nothing: every sensor detects every drone" + ofFirstRun() + ".")
                : head + Html.table(List.of("sensor", "kind", "drone", "why"), rows);
    }

    private String parameters() {
        List<List<String>> sensors = new ArrayList<>();
        settings()
                .sensors()
                .forEach((id, sensor) -> sensors.add(List.of(
                        id,
                        sensor.kind(),
                        place(sensor.position()),
                        format("%s Hz", Reasons.number(sensor.rate())),
                        name(sensor))));
        return Html.plain("h2", "Sensors")
                + Html.table(List.of("sensor", "kind", "east, north, up [m]", "looks", "settings"), sensors)
                + Html.plain("h2", "Drones")
                + DroneRows.table(settings().fliers())
                + Html.plain("h2", "Site")
                + Html.table(
                        List.of("models", "background noise", "visibility", "rain", "simulated", "seed"),
                        List.of(List.of(
                                String.join(
                                        ", ",
                                        settings().world().models().stream()
                                                .map(model -> model.file())
                                                .toList()),
                                format(
                                        "%s dB(A)",
                                        Reasons.number(settings().world().backgroundNoise())),
                                format(
                                        "%s m",
                                        Reasons.number(
                                                settings().world().light().visibility())),
                                format(
                                        "%s mm/h",
                                        Reasons.number(settings().world().rain())),
                                format("%s s", Reasons.number(result.simulated())),
                                Long.toString(result.seed()))));
    }

    private static String name(SensorSettings<?> sensor) {
        return sensor instanceof Record settings
                ? Described.of(settings, Set.of("position", "rate"))
                : sensor.toString();
    }

    private static String place(Position at) {
        return format("%.1f, %.1f, %.1f", at.x(), at.y(), at.z());
    }

    private static String limits() {
        return Html.plain("h2", "What not to believe")
                + Html.element(
                        "ul",
                        List.of(
                                        "Ranges are those of the models and settings above: a real sensor's have to be measured.",
                                        "A camera that counts pixels knows no contrast, haze, light or compression.",
                                        "A radar here knows no clutter, no birds and no rotor Doppler.",
                                        "Sound by the level model is calibrated, not physical; wind and interference are left out.",
                                        "Nothing here gives a false alarm.",
                                        "A flight is one of many: other bearings, heights and times give other results.")
                                .stream()
                                .map(item -> Html.plain("li", item))
                                .reduce("", String::concat));
    }

    private static String number(OptionalDouble value) {
        return value.isPresent() ? format("%.1f", value.getAsDouble()) : "never";
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
