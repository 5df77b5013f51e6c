package org.dronewatch.report.html.run;

import static org.dronewatch.report.html.ReadableNumbers.format;
import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.dronewatch.buildings.BuildingSettings;
import org.dronewatch.fusion.AlertRule;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.FalseAlertRate;
import org.dronewatch.fusion.ProtectedArea;
import org.dronewatch.geo.Origin;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.ReadableNumbers;
import org.dronewatch.report.html.SensorTables;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.input.PackagedSite;
import org.dronewatch.sound.Wind;
import org.dronewatch.world.WorldSettings;

/**
 * The settings of the simulation: drones, the site, the alert rule, and the limitations of the model; those of the
 * sensors are in {@link SensorTables}.
 */
final class SettingTables {
    private final SceneResult result;
    private final SceneSettings settings;

    SettingTables(SceneResult result) {
        this.result = result;
        this.settings = result.runs().get(0).settings();
    }

    /** {@code 50.08000 deg N, 14.42000 deg E, 250 m above sea level}. */
    private static String coordinates(Origin origin) {
        double latitude = Math.toDegrees(origin.latitude());
        double longitude = Math.toDegrees(origin.longitude());
        return format(
                        "%.5f\u00b0 %s, %.5f\u00b0 %s, ",
                        Math.abs(latitude),
                        latitude < 0.0 ? "S" : "N",
                        Math.abs(longitude),
                        longitude < 0.0 ? "W" : "E")
                + origin.height()
                        .map(height -> format("%.1f m above sea level", height))
                        .orElse("altitude unknown");
    }

    String drones() {
        return DroneRows.table(settings);
    }

    String site() {
        WorldSettings world = settings.world();
        List<String> head = new ArrayList<>(
                List.of("models", "background noise", "visibility", "illuminance", "rain", "simulated time", "seed"));
        List<String> row = new ArrayList<>(List.of(
                String.join(
                        ", ", world.models().stream().map(model -> model.file()).toList()),
                number(world.backgroundNoise()) + " dB(A)",
                number(world.light().visibility()) + " m",
                number(world.light().illuminance()) + " lx",
                number(world.rain()) + " mm/h",
                number(result.simulated()) + " s",
                Long.toString(result.seed())));
        world.terrain().ifPresent(terrain -> {
            head.add("terrain");
            row.add(terrain.allFiles().stream().map(PackagedSite::plain).collect(Collectors.joining(", ")));
        });
        world.buildings().flatMap(BuildingSettings::file).ifPresent(map -> {
            head.add("buildings");
            row.add(PackagedSite.plain(map));
        });
        Wind wind = world.atmosphere().wind();
        if (wind.speed() > 0.0) {
            head.add("wind");
            row.add(number(wind.speed()) + " m/s from " + number(Quantity.ANGLE.displayed(wind.from())) + "°");
        }
        world.origin().ifPresent(origin -> {
            head.add("origin");
            row.add(coordinates(origin));
        });
        return Html.table(head, List.of(row));
    }

    /** The alert rule and the protected zone, in a sentence. */
    String rule() {
        AlertSettings alert = settings.alert();
        String needs = alert.response() > 0.0
                ? " The response takes " + number(alert.response()) + " " + Quantity.DURATION.unit() + "."
                : "";
        String confirmed = alert.confirm().looks() == 1
                ? ""
                : " in at least " + alert.confirm().hits() + " of its last "
                        + alert.confirm().looks() + " looks";
        StringBuilder zone = new StringBuilder();
        alert.protect().ifPresent(ball -> zone.append(" Protected zone: everything within ")
                .append(number(ball.radius()))
                .append(" m of (")
                .append(SensorTables.coordinates(ball.centre()))
                .append(") m."));
        alert.zones().forEach((name, area) -> zone.append(" Protected area '")
                .append(name)
                .append("': ")
                .append(outline(area))
                .append(", from ")
                .append(number(area.floor()))
                .append(" to ")
                .append(number(area.height()))
                .append(" m above the ground."));
        if (alert.isProtecting()) {
            zone.append(" Warning time is the straight-line flight time to the "
                            + (alert.zones().isEmpty() ? "zone" : "nearest zone")
                            + " at the drone's cruise speed.")
                    .append(needs);
        }
        return Html.plain("p", "Alert rule: " + rule(alert.rule(), confirmed) + "." + zone);
    }

    private static String outline(ProtectedArea area) {
        return area.area().isEmpty()
                ? "a circle of radius " + number(area.radius().orElseThrow()) + " m about ("
                        + number(area.centre().orElseThrow().x()) + ", "
                        + number(area.centre().orElseThrow().y()) + ") m"
                : "a polygon with " + area.area().size() + " corners";
    }

    private static String rule(AlertRule rule, String confirmed) {
        if (rule instanceof AlertRule.SeveralSensors several) {
            return format(
                    "as soon as %d sensors detect a drone within %s s%s",
                    several.count(), number(several.within()), confirmed.isEmpty() ? "" : ", each" + confirmed);
        }
        if (rule instanceof AlertRule.UnionOfProbabilities union) {
            return format(
                    "as soon as the combined probability of detection over the last %s s reaches %s, assuming that sensors"
                            + " miss independently (a forecast, not a rule that a real system could apply: looks that"
                            + " detect nothing also count)",
                    number(union.within()), ReadableNumbers.measured(union.probability(), ""));
        }
        return "as soon as any sensor detects a drone" + confirmed;
    }

    private String falseAlarms() {
        FalseAlertRate rate = result.runs().get(0).falseAlertRate();
        String rest = rate.unknown().isEmpty()
                ? ""
                : " For the other sensors, whose rates are unknown, no false alarms are simulated.";
        boolean hasBirds =
                result.runs().stream().anyMatch(run -> !run.settings().birds().isEmpty());
        String ofBirds = hasBirds ? " Birds that sensors detect are false alarms, too." : "";
        if (!rate.isUnknown()) {
            return "Sensors whose rate of false alarms is stated raise them at that rate, which depends on weather and light"
                    + " only if a rate is stated for these conditions, and not on the site." + rest + ofBirds;
        }
        return hasBirds
                ? "Birds that sensors detect are the only false alarms: no sensor's false-alarm rate is known."
                : "False alarms are not modelled: no sensor's false-alarm rate is known.";
    }

    /** The limitations of the model, for the kinds of sensors in the scene. */
    String limits() {
        List<String> items = new ArrayList<>();
        items.add("Ranges follow from the models and settings above; the ranges of real sensors must be measured.");
        items.addAll(new SensorTables(settings).omissions());
        items.add(falseAlarms());
        items.add(
                "Each result holds for these flight paths only; other bearings, altitudes and times give other results.");
        return Html.element(
                "ul", items.stream().map(item -> Html.plain("li", item)).reduce("", String::concat));
    }
}
