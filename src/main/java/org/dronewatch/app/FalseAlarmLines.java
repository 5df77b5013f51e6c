package org.dronewatch.app;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.run.FalseAlarmResult;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneResult;

/** The lines about false alerts that a run prints. */
final class FalseAlarmLines {
    private FalseAlarmLines() {}

    /** The rate of false alerts, if the scene states an alert rule or the false-alarm rate of a sensor. */
    static void print(SceneResult result, PrintWriter target) {
        for (RunResult run : result.runs()) {
            FalseAlarmResult counted = run.falseAlarms();
            boolean isUnknown = run.falseAlertRate().isUnknown();
            if (counted.count() > 0 || !isUnknown || !run.settings().alert().equals(AlertSettings.DEFAULT)) {
                String which = result.runs().size() == 1 ? "" : "run " + run.run() + ": ";
                String why = isUnknown && counted.count() == 0 ? ", since no sensor sets 'falseAlarms'" : "";
                String here = isUnknown && counted.count() == 0
                        ? ""
                        : "; in this run: " + counted.alertCount() + " (" + bySensor(counted) + ")";
                target.println(which + "false alerts: " + run.falseAlertRate().inWords() + why + here);
                counted.birds()
                        .forEach((bird, alert) -> target.printf(
                                Locale.ROOT,
                                "%sthe alert at %.2f s, raised by %s, was caused by a bird: %s%n",
                                which,
                                alert.time(),
                                String.join(", ", alert.sensors()),
                                bird));
            }
        }
    }

    /** {@code false alarms: radar 51 (48 caused by birds), radio 2 (all caused by birds), camera 3}. */
    private static String bySensor(FalseAlarmResult result) {
        return result.counted().isEmpty()
                ? "no false alarms"
                : "false alarms: "
                        + result.counted().entrySet().stream()
                                .map(one -> one.getKey() + " " + one.getValue()
                                        + birds(one.getValue(), result.ofBirds().getOrDefault(one.getKey(), 0L)))
                                .collect(Collectors.joining(", "));
    }

    private static String birds(long count, long birds) {
        if (birds == 0) {
            return "";
        }
        return birds < count
                ? " (" + birds + " caused by " + (birds == 1 ? "a bird)" : "birds)")
                : count == 1 ? " (caused by a bird)" : " (all caused by birds)";
    }
}
