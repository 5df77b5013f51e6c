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
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Choices;

/** Tables of a scene's sensors for a report: their settings and costs, and the sources of the settings. */
public final class SensorTables {
    private final SceneSettings settings;

    /** The tables of the sensors of a scene. */
    public SensorTables(SceneSettings settings) {
        this.settings = settings;
    }

    /** The table of the sensors, with a row for each. */
    public String sensors() {
        return sensors("No prices are known; they can be set in the scene under 'prices'.");
    }

    /**
     * The table of the sensors, with a row for each.
     *
     * @param unpriced what to say if the scene states no prices
     */
    public String sensors(String unpriced) {
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
                String known = prices.containsKey(id) ? money(prices.get(id)) : "unknown";
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
            String rest = unknown == 0 ? "" : "excluding " + unknown + " of unknown price";
            rows.add(List.of("all", "", "", "", money(sum), rest));
        }
        return Html.table(head, rows) + (priced ? "" : Html.plain("p", unpriced));
    }

    private static String money(double amount) {
        return format("%,.0f", amount).replace(',', '\u202f');
    }

    private static String described(SensorSettings<?> sensor) {
        return sensor instanceof Record parts ? Described.of(parts, Set.of("position", "rate")) : sensor.toString();
    }

    /** The coordinates of a position to the east, north and up, m: {@code -44.0, 124.0, 12.5}. */
    public static String coordinates(Position at) {
        return format("%.1f, %.1f, %.1f", at.x(), at.y(), at.z());
    }

    /**
     * The sources of the sensors' settings: a row for each catalogue entry, and one for all sensors that are not in the
     * catalogue.
     */
    public String sources() {
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
                    entry.map(known -> known.source() + ". " + known.note()).orElse("No source given in the scene.")));
        });
        return Html.table(List.of("sensor", "model", "basis of its ranges", "source and assumptions"), rows);
    }

    /** What the models of the enabled sensors leave out, in sentences. */
    public List<String> omissions() {
        Set<String> omissions = new LinkedHashSet<>();
        settings.enabledSensors()
                .values()
                .forEach(sensor -> omissions.addAll(sensor.description().leavesOut()));
        return List.copyOf(omissions);
    }
}
