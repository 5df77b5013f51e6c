package org.dronewatch.report.html;

import static org.dronewatch.report.html.ReadableNumbers.format;
import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.CatalogEntry;
import org.dronewatch.fusion.AlertRule;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.WorldSettings;

/** What was simulated: sensors with what they cost, drones, the site, the rule of alert, and the limits of the model. */
final class SettingTables {
    private final SceneResult result;
    private final SceneSettings settings;

    SettingTables(SceneResult result) {
        this.result = result;
        this.settings = result.runs().get(0).settings();
    }

    String sensors() {
        Map<String, Double> prices = settings.prices().sensors();
        boolean priced = !prices.isEmpty();
        List<String> head =
                new ArrayList<>(List.of("sensor", "kind", "east, north, up [m]", "looks per second", "settings"));
        if (priced) {
            head.add(4, "cost [" + settings.prices().currency() + "]");
        }
        List<List<String>> rows = new ArrayList<>();
        settings.sensors().forEach((id, sensor) -> {
            boolean enabled = settings.isEnabled(id);
            String looks = enabled ? number(sensor.rate()) : "switched off";
            List<String> row = new ArrayList<>(
                    List.of(id, sensor.kind(), coordinates(sensor.position()), looks, described(sensor)));
            if (priced) {
                String known = prices.containsKey(id) ? money(prices.get(id)) : "not known";
                row.add(4, enabled ? known : "not installed");
            }
            rows.add(row);
        });
        if (priced) {
            Set<String> installed = settings.enabledSensors().keySet();
            double sum = installed.stream()
                    .mapToDouble(id -> prices.getOrDefault(id, 0.0))
                    .sum();
            long unknown =
                    installed.stream().filter(id -> !prices.containsKey(id)).count();
            String rest = unknown == 0 ? "" : "without " + unknown + " of unknown price";
            rows.add(List.of("all", "", "", "", money(sum), rest));
        }
        return Html.table(head, rows)
                + (priced ? "" : Html.plain("p", "No prices are known; a scene states them under 'prices'."));
    }

    private static String money(double amount) {
        return format("%,.0f", amount).replace(',', '\u202f');
    }

    private static String described(SensorSettings<?> sensor) {
        return sensor instanceof Record parts ? Described.of(parts, Set.of("position", "rate")) : sensor.toString();
    }

    private static String coordinates(Position at) {
        return format("%.1f, %.1f, %.1f", at.x(), at.y(), at.z());
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
                        .orElse("height not known");
    }

    /** Where the settings of sensors come from: a row for each entry of the catalogue, and one for all that is in none. */
    String sources() {
        Map<String, List<String>> users = new LinkedHashMap<>();
        settings.sensors().forEach((id, sensor) -> users.computeIfAbsent(
                        Catalog.nameOf(sensor).orElse(""), name -> new ArrayList<>())
                .add(id));
        List<List<String>> rows = new ArrayList<>();
        users.forEach((name, ids) -> {
            Optional<CatalogEntry> entry = Catalog.packaged().entry(name);
            rows.add(List.of(
                    String.join(", ", ids),
                    entry.map(CatalogEntry::title).orElse("defined in the scene"),
                    entry.map(known -> Choices.name(known.basis().name())).orElse("not stated"),
                    entry.map(known -> known.source() + ". " + known.note()).orElse("The scene names no source.")));
        });
        return Html.table(List.of("sensor", "model", "basis of its ranges", "source and assumptions"), rows);
    }

    String drones() {
        return DroneRows.table(settings);
    }

    String site() {
        WorldSettings world = settings.world();
        List<String> head = new ArrayList<>(
                List.of("models", "background noise", "visibility", "illuminance", "rain", "simulated", "seed"));
        List<String> row = new ArrayList<>(List.of(
                String.join(
                        ", ", world.models().stream().map(model -> model.file()).toList()),
                number(world.backgroundNoise()) + " dB(A)",
                number(world.light().visibility()) + " m",
                number(world.light().illuminance()) + " lx",
                number(world.rain()) + " mm/h",
                number(result.simulated()) + " s",
                Long.toString(result.seed())));
        world.origin().ifPresent(origin -> {
            head.add("origin");
            row.add(coordinates(origin));
        });
        return Html.table(head, List.of(row));
    }

    /** The rule of alert and what it protects, in a sentence. */
    String rule() {
        AlertSettings alert = settings.alert();
        String needs = alert.response() > 0.0
                ? " " + number(alert.response()) + " " + Quantity.DURATION.unit()
                        + " are needed between the alert and the drone's arrival."
                : "";
        String confirmed = alert.confirm().looks() == 1
                ? ""
                : ", each by " + alert.confirm().hits() + " of its last "
                        + alert.confirm().looks() + " looks";
        String zone = alert.protect()
                .map(ball -> " Protected zone: everything within " + number(ball.radius()) + " m of ("
                        + coordinates(ball.centre())
                        + ") m. The warning time is that of the straight flight to the zone at the drone's cruise speed."
                        + needs)
                .orElse("");
        return Html.plain("p", "Alert rule: " + rule(alert.rule(), confirmed) + "." + zone);
    }

    private static String rule(AlertRule rule, String confirmed) {
        if (rule instanceof AlertRule.SeveralSensors several) {
            return format(
                    "as soon as %d sensors detect a drone within %s s%s",
                    several.count(), number(several.within()), confirmed);
        }
        if (rule instanceof AlertRule.UnionOfProbabilities union) {
            return format(
                    "as soon as the looks of the last %s s together make detection %s likely, if the sensors miss"
                            + " independently of one another",
                    number(union.within()), ReadableNumbers.measured(union.probability(), ""));
        }
        return "as soon as any sensor detects a drone" + confirmed;
    }

    /** The limits of the model, of the kinds of sensors that there are. */
    String limits() {
        List<String> items = new ArrayList<>();
        items.add("Ranges follow from the models and settings above; those of a real sensor have to be measured.");
        Set<String> leftOut = new LinkedHashSet<>();
        settings.enabledSensors()
                .values()
                .forEach(sensor -> leftOut.addAll(sensor.description().leavesOut()));
        items.addAll(leftOut);
        items.add("False alarms are not modelled.");
        items.add("Each flight is one of many: other bearings, heights and times give other results.");
        return Html.element(
                "ul", items.stream().map(item -> Html.plain("li", item)).reduce("", String::concat));
    }
}
