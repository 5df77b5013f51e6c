package org.dronewatch.report.html;

import static org.dronewatch.report.html.Numbers.format;
import static org.dronewatch.report.html.Numbers.number;

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
import org.dronewatch.geometry.Position;
import org.dronewatch.scene.SceneResult;
import org.dronewatch.scene.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.WorldSettings;

/** What was simulated: sensors with what they cost, drones, the site, the rule of alert, and what not to believe. */
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
        List<String> head = new ArrayList<>(List.of("sensor", "kind", "east, north, up [m]", "looks", "settings"));
        if (priced) {
            head.add(4, "cost [" + settings.prices().currency() + "]");
        }
        List<List<String>> rows = new ArrayList<>();
        settings.sensors().forEach((id, sensor) -> {
            List<String> row = new ArrayList<>(List.of(
                    id, sensor.kind(), place(sensor.position()), number(sensor.rate()) + " Hz", described(sensor)));
            if (priced) {
                row.add(4, prices.containsKey(id) ? money(prices.get(id)) : "not known");
            }
            rows.add(row);
        });
        if (priced) {
            double sum =
                    prices.values().stream().mapToDouble(Double::doubleValue).sum();
            int unknown = settings.sensors().size() - prices.size();
            String rest = unknown == 0 ? "" : "without " + unknown + " of unknown price";
            rows.add(List.of("all", "", "", "", money(sum), rest));
        }
        return Html.table(head, rows)
                + (priced ? "" : Html.plain("p", "No prices are known: 'prices' in the scene takes them."));
    }

    private static String money(double amount) {
        return format("%,.0f", amount).replace(',', '\u202f');
    }

    private static String described(SensorSettings<?> sensor) {
        return sensor instanceof Record parts ? Described.of(parts, Set.of("position", "rate")) : sensor.toString();
    }

    private static String place(Position at) {
        return format("%.1f, %.1f, %.1f", at.x(), at.y(), at.z());
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
                    entry.map(CatalogEntry::title).orElse("as the scene says"),
                    entry.map(known -> Choices.name(known.basis().name())).orElse("the scene's own"),
                    entry.map(known -> known.source() + ". " + known.note()).orElse("The scene names no source.")));
        });
        return Html.table(List.of("sensor", "taken as", "ranges are", "source, and what is assumed"), rows);
    }

    String drones() {
        return DroneRows.table(settings.fliers());
    }

    String site() {
        WorldSettings world = settings.world();
        List<String> head =
                new ArrayList<>(List.of("models", "background noise", "visibility", "rain", "simulated", "seed"));
        List<String> row = new ArrayList<>(List.of(
                String.join(
                        ", ", world.models().stream().map(model -> model.file()).toList()),
                number(world.backgroundNoise()) + " dB(A)",
                number(world.light().visibility()) + " m",
                number(world.rain()) + " mm/h",
                number(result.simulated()) + " s",
                Long.toString(result.seed())));
        world.origin().ifPresent(origin -> {
            head.add("origin");
            row.add(format(
                    "%.5f\u00b0 N, %.5f\u00b0 E",
                    Math.toDegrees(origin.latitude()), Math.toDegrees(origin.longitude())));
        });
        return Html.table(head, List.of(row));
    }

    /** The rule of alert and what it protects, in a sentence. */
    String rule() {
        AlertSettings alert = settings.alert();
        String needs = alert.response() > 0.0
                ? " " + number(alert.response()) + " " + Quantity.DURATION.unit()
                        + " are needed between alert and arrival."
                : "";
        String confirmed = alert.confirm().looks() == 1
                ? ""
                : ", each by " + alert.confirm().hits() + " of its last "
                        + alert.confirm().looks() + " looks";
        String zone = alert.protect()
                .map(ball -> " Protected: all within " + number(ball.radius()) + " m of (" + place(ball.centre())
                        + ") m. Warning is the straight way to there at the drone's cruise speed." + needs)
                .orElse("");
        return Html.plain("p", "Alert: " + rule(alert.rule(), confirmed) + "." + zone);
    }

    private static String rule(AlertRule rule, String confirmed) {
        if (rule instanceof AlertRule.SeveralSensors several) {
            return format(
                    "as soon as %d sensors detect a drone within %s s%s",
                    several.count(), number(several.within()), confirmed);
        }
        if (rule instanceof AlertRule.UnionOfProbabilities union) {
            return format(
                    "as soon as the looks of the last %s s together make detection %s likely, the sensors' misses taken for"
                            + " independent",
                    number(union.within()), Numbers.measured(union.probability(), ""));
        }
        return "as soon as any sensor detects a drone" + confirmed;
    }

    /** What not to believe, of the kinds of sensors that there are. */
    String limits() {
        List<String> items = new ArrayList<>();
        items.add("Ranges are those of the models and settings above: a real sensor's have to be measured.");
        Set<String> leftOut = new LinkedHashSet<>();
        settings.sensors().values().forEach(sensor -> leftOut.addAll(sensor.leavesOut()));
        items.addAll(leftOut);
        items.add("Nothing here gives a false alarm.");
        items.add("A flight is one of many: other bearings, heights and times give other results.");
        return Html.element(
                "ul", items.stream().map(item -> Html.plain("li", item)).reduce("", String::concat));
    }
}
