package org.dronewatch.app;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.app.option.SceneChoice;
import org.dronewatch.fusion.AlertRule;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.Confirmation;
import org.dronewatch.fusion.FalseAlertRate;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.alarm.FalseAlarmRate;
import org.dronewatch.sensor.alarm.FalseAlarming;
import org.dronewatch.sensor.alarm.NoiseAlarming;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.Spelling;
import org.dronewatch.world.Weather;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Prints how many false alerts the alert rule of a scene lets through. */
@Command(
        name = "alarms",
        mixinStandardHelpOptions = true,
        description =
                "Prints the false-alarm rate of each sensor in a scene, and the number of false alerts per day that"
                        + " result from the scene's alert rule, with its own M-of-N confirmation and with other common"
                        + " M-of-N rules. The scene is not run. With --sensor and --per-hour, prints the false-alarm"
                        + " probability that yields the desired number of false alarms for a radar.",
        footer = {
            "",
            "Examples:",
            "  dronewatch alarms scenes/false-alarms.yaml",
            "  dronewatch alarms scenes/false-alarms.yaml --sensor radar --per-hour 20"
        })
final class AlarmsCommand implements Callable<Integer> {
    private static final List<Confirmation> TRIED = List.of(
            new Confirmation(1, 1),
            new Confirmation(2, 2),
            new Confirmation(2, 3),
            new Confirmation(3, 4),
            new Confirmation(3, 5),
            new Confirmation(5, 8));
    static final double EVEN = 0.5;
    static final double LIKELY = 0.9;
    private static final double MOST_PER_HOUR = 1e7;

    @Mixin
    private SceneChoice choice;

    @Option(
            names = "--run",
            defaultValue = "0",
            paramLabel = "N",
            description = "Index of the run of a sweep, counted from 0; 0 by default.")
    private int run;

    @Option(names = "--sensor", paramLabel = "ID", description = "Radar to which --per-hour applies.")
    private String sensor;

    @Option(
            names = "--per-hour",
            paramLabel = "N",
            description = "Desired number of false alarms per hour, above 0 and at most 1e7.")
    private Double perHour;

    @Mixin
    private JsonOption json = new JsonOption();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        if ((sensor == null) != (perHour == null)) {
            throw new InputException("--sensor and --per-hour belong together: give both or neither");
        }
        SceneRunner runner = choice.runner(choice.create());
        runner.notes(Notes.of(spec));
        SceneSettings settings = SceneChoice.settingsOfRun(runner, run);
        if (sensor != null) {
            Map.Entry<String, String> wanted = wanted(settings);
            json.print(() -> AlarmsJson.of(wanted), out -> out.println(wanted.getKey() + "=" + wanted.getValue()));
            return 0;
        }
        json.print(() -> AlarmsJson.of(settings, rules(settings.alert())), out -> {
            printSensors(settings, out);
            printRules(settings, out);
        });
        return 0;
    }

    /**
     * The confirmations whose false alerts are stated: common ones, and at the end that of the scene if it is not one
     * of them.
     */
    private static List<Confirmation> rules(AlertSettings alert) {
        List<Confirmation> rules = new ArrayList<>(TRIED);
        if (!rules.contains(alert.confirm())) {
            rules.add(alert.confirm());
        }
        return rules;
    }

    private static void printSensors(SceneSettings settings, PrintWriter out) {
        out.printf(
                "%-16s %-9s %12s %12s %12s %17s%n",
                "sensor", "kind", "per hour", "per look", "cells", "duration [looks]");
        settings.enabledSensors().forEach((id, one) -> {
            Optional<FalseAlarmRate> known = rate(one, settings.world().weather());
            out.printf(
                    "%-16s %-9s %12s %12s %12s %17s%n",
                    id,
                    one.kind(),
                    known.map(rate -> FalseAlertRate.brief(rate.perHour())).orElse("unknown"),
                    known.map(rate -> FalseAlertRate.brief(rate.perLook())).orElse("-"),
                    known.map(rate -> Long.toString(rate.cells())).orElse("-"),
                    known.map(rate -> Integer.toString(rate.looks())).orElse("-"));
        });
    }

    private static void printRules(SceneSettings settings, PrintWriter out) {
        AlertSettings alert = settings.alert();
        out.println();
        if (alert.rule() instanceof AlertRule.UnionOfProbabilities) {
            out.println("false alerts: " + rate(alert, settings).inWords());
            return;
        }
        out.println("probability that a drone is confirmed if each look detects it with a probability of 50 % or 90 %,"
                + " and rate of false alerts:");
        out.printf("%-8s %18s %18s   %s%n", "confirm", "50 %", "90 %", "false alerts");
        rules(alert).forEach(confirm -> printRule(settings, confirm, out));
    }

    private static void printRule(SceneSettings settings, Confirmation confirm, PrintWriter out) {
        AlertSettings changed = settings.alert().withConfirmation(confirm.hits(), confirm.looks());
        boolean isOwn = confirm.equals(settings.alert().confirm());
        out.printf(
                Locale.ROOT,
                "%-8s %17.3f%% %17.3f%%   %s%n",
                confirm.hits() + " of " + confirm.looks(),
                100.0 * confirm.probability(EVEN),
                100.0 * confirm.probability(LIKELY),
                rate(changed, settings).inWords() + (isOwn ? "  <- this scene" : ""));
    }

    /** The rate of false alerts with another rule. */
    static FalseAlertRate rate(AlertSettings alert, SceneSettings settings) {
        return FalseAlertRate.of(
                alert, settings.enabledSensors(), settings.world().weather());
    }

    /** The setting that yields the desired number of false alarms, and its value. */
    private Map.Entry<String, String> wanted(SceneSettings settings) {
        if (!(perHour > 0.0 && perHour <= MOST_PER_HOUR)) {
            throw new InputException(
                    "--per-hour " + Quantity.NUMBER.inWords(perHour) + ": must be above 0 and at most 1e7");
        }
        SensorSettings<?> named = settings.sensors().get(sensor);
        String given = "--sensor " + PlainText.value(sensor) + ": ";
        if (named == null) {
            throw new InputException(given + "no such sensor; "
                    + Spelling.closestMatches(sensor, settings.sensors().keySet()));
        }
        NoiseAlarming noisy = named.as(NoiseAlarming.class)
                .orElseThrow(() -> new InputException(given + "is of kind " + named.kind()
                        + ", whose rate is set, not computed: only a radar has a false-alarm probability"));
        double probability;
        try {
            probability = noisy.falseAlarmProbability(perHour);
        } catch (IllegalArgumentException e) {
            throw new InputException(given + e.getMessage(), e);
        }
        String setting = "sensors." + sensor + "." + noisy.falseAlarmSetting();
        String value = String.format(Locale.ROOT, "%.3e", probability);
        checkSettable(setting, value);
        return Map.entry(setting, value);
    }

    /** Refuses a probability that {@code --set} would refuse, with its limit. */
    private void checkSettable(String setting, String value) {
        try {
            choice.runner(choice.create()).set(setting, value).settingsOfRuns();
        } catch (InputException e) {
            throw new InputException(
                    "--per-hour " + Quantity.NUMBER.inWords(perHour) + " needs "
                            + e.getMessage().replaceFirst("^--set ", ""),
                    e);
        }
    }

    /** The false-alarm rate of a sensor, if it has one. */
    static Optional<FalseAlarmRate> rate(SensorSettings<?> sensor, Weather weather) {
        return sensor.as(FalseAlarming.class).flatMap(capability -> capability.falseAlarmRate(weather));
    }
}
