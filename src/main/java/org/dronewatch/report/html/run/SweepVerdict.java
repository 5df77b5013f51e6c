package org.dronewatch.report.html.run;

import static org.dronewatch.report.html.ReadableNumbers.format;
import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.run.AlertResult;
import org.dronewatch.run.RunResult;
import org.dronewatch.scenario.SweepSettings;
import org.dronewatch.scenario.SweptValue;
import org.dronewatch.setting.PlainText;

/**
 * The result of a sweep: in how many runs an alert was raised, in how many in time, and the verdict of the worst run.
 */
final class SweepVerdict {
    /** Maximum number of runs listed in a sentence; of more, only the number is given. */
    private static final int MAX_LISTED = 12;

    private final List<RunResult> runs;
    private final List<RunRank.Ranked> ranked;
    private final RunResult worst;

    SweepVerdict(List<RunResult> runs) {
        this.runs = List.copyOf(runs);
        this.ranked = runs.stream().map(RunRank.Ranked::new).toList();
        this.worst = ranked.stream().min(RunRank.WORST_FIRST).orElseThrow().run();
    }

    /** The worst run; the first of several equally bad ones. */
    RunResult worst() {
        return worst;
    }

    String inWords() {
        List<String> sentences = new ArrayList<>();
        AlertSettings alert = runs.get(0).settings().alert();
        boolean timed = runs.stream().anyMatch(run -> alerts(run).stream()
                .anyMatch(one -> one.inTime().isPresent()));
        boolean others =
                runs.stream().anyMatch(run -> alerts(run).size() < run.alerts().size());
        String drones = others ? "every attacking drone" : "every drone";
        sentences.add(fraction(
                rank -> rank.missed() == 0,
                alert.equals(AlertSettings.DEFAULT) ? drones + " is detected" : "an alert is raised for " + drones));
        if (timed) {
            sentences.add(fraction(
                    rank -> rank.late() == 0,
                    format(
                            "the alert is in time, at least %s s before the drone can reach the protected zone",
                            number(alert.response()))));
        }
        if (others) {
            sentences.add("Only attacking drones are counted.");
        }
        sentences.add("The worst run is run " + worst.run() + with(worst) + ": " + new Verdict(worst).inWords());
        return String.join(" ", sentences);
    }

    private static List<AlertResult> alerts(RunResult run) {
        return run.attackAlerts();
    }

    private String fraction(Predicate<RunRank> good, String what) {
        List<RunResult> bad = ranked.stream()
                .filter(one -> !good.test(one.rank()))
                .map(RunRank.Ranked::run)
                .toList();
        int count = runs.size() - bad.size();
        String all = bad.isEmpty()
                ? "In all " + runs.size() + " runs "
                : count == 0
                        ? "Among the " + runs.size() + " runs, there is none in which "
                        : "In " + count + " of " + runs.size() + " runs ";
        boolean listed = count > 0 && !bad.isEmpty() && bad.size() <= MAX_LISTED;
        return all + what + (listed ? " (not for " + values(bad) + ")" : "") + ".";
    }

    /** {@code bearing 60 deg, 90 deg and 120 deg}. */
    private static String values(List<RunResult> some) {
        List<String> texts = some.stream()
                .map(run -> run.settings()
                        .sweep()
                        .map(sweep -> new SweptValue(run.settings(), sweep).value())
                        .orElse(""))
                .toList();
        String name = value(some.get(0)).replaceFirst(" .*", "") + " ";
        return name + PlainText.list(texts);
    }

    private static String with(RunResult run) {
        String value = value(run);
        return value.isEmpty() ? "" : " (" + value + ")";
    }

    /** The swept setting with its value in a run: {@code bearing 60 deg}. */
    static String value(RunResult run) {
        return run.settings()
                .sweep()
                .map(sweep -> new SweptValue(run.settings(), sweep).shortText())
                .orElse("");
    }

    /** The sense in which a swept direction is measured; empty for other settings. */
    static String note(RunResult run) {
        String parameter = run.settings().sweep().map(SweepSettings::parameter).orElse("");
        boolean compass = parameter.toLowerCase(Locale.ROOT).matches(".*(bearing|azimuth|heading)");
        return compass ? "Bearings, azimuths and headings are measured clockwise from north." : "";
    }

    /** A heading for a run. */
    static String title(RunResult run) {
        return "Run " + run.run() + with(run);
    }
}
