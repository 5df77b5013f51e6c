package org.dronewatch.report.placement;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.plan.Cues;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.placement.site.TriedBudgets;
import org.dronewatch.report.file.Numbers;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The contents of {@code place.json}: equal inputs give the same bytes for any number of threads. */
final class PlaceFile {
    /** Whether nothing was left out. */
    static final String COMPLETE = "complete";

    private PlaceFile() {}

    /**
     * The figures that every objective has.
     *
     * @param terms adds what the objective is
     * @param values adds what belongs to its value
     * @param more adds what is only known for the objective
     */
    static ObjectNode of(
            PlaceResults results, Consumer<ObjectNode> terms, Consumer<ObjectNode> values, Consumer<ObjectNode> more) {
        PlacedLayout layout = results.best();
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put(
                "objective",
                layout.plan()
                        .settings()
                        .objective()
                        .name()
                        .toLowerCase(Locale.ROOT)
                        .replace('_', '-'));
        terms.accept(root);
        addWorth(root, layout);
        root.put("cost", Numbers.rounded(layout.result().cost()));
        values.accept(root);
        ArrayNode chosen = root.putArray("chosen");
        Map<String, Double> without = layout.withoutEach();
        layout.chosen().forEach(sensor -> add(chosen.addObject(), sensor, layout, without));
        List<String> uncued = new Cues(layout.plan()).uncued(layout.chosen());
        if (!uncued.isEmpty()) {
            ArrayNode names = root.putArray("uncued");
            uncued.forEach(names::add);
        }
        new SilentDrone(layout, results.measure()).add(root);
        present(root, layout);
        ArrayNode front = root.putArray("front");
        for (FrontPoint<? extends PlacedLayout> point : results.front().points()) {
            ObjectNode node = front.addObject();
            node.put("cost", Numbers.rounded(point.cost()));
            node.put("budget", Numbers.rounded(point.budget()));
            addWorth(node, point.layout());
            ArrayNode added = node.putArray("added");
            point.added().forEach(added::add);
            ArrayNode removed = node.putArray("removed");
            point.removed().forEach(removed::add);
        }
        tried(root.putObject("budgets"), results.front().tried());
        more.accept(root);
        results.front().stopped().ifPresent(stop -> TimeStopWords.add(root, stop));
        root.put(COMPLETE, results.complete());
        return root;
    }

    private static void addWorth(ObjectNode node, PlacedLayout layout) {
        node.put("value", Numbers.rounded(layout.value()));
        node.put("bound", Numbers.rounded(layout.bound()));
        node.put("gap", Double.isFinite(layout.gap()) ? Numbers.rounded(layout.gap()) : null);
    }

    private static void tried(ObjectNode budgets, TriedBudgets tried) {
        budgets.put("tried", tried.count());
        budgets.put("all", tried.all());
        ArrayNode infeasible = budgets.putArray("infeasible");
        tried.infeasible().forEach(budget -> infeasible.add(Numbers.rounded(budget)));
        ArrayNode unknown = budgets.putArray("unknown");
        tried.unknown().forEach(budget -> unknown.add(Numbers.rounded(budget)));
    }

    /** Adds the value of a layout in the scene as it is and under each condition, if there are any. */
    static Consumer<ObjectNode> conditions(PlacedLayout layout) {
        return root -> {
            Map<String, Double> values = layout.byCondition();
            if (!values.isEmpty()) {
                root.put("as_it_is", Numbers.rounded(layout.asItIs()));
                ArrayNode conditions = root.putArray("conditions");
                values.forEach((name, value) ->
                        conditions.addObject().put("name", name).put("value", Numbers.rounded(value)));
            }
        };
    }

    /** Adds the layout of today: the number of its sensors and its value; neither where the scene has no sensors. */
    private static void present(ObjectNode root, PlacedLayout layout) {
        ObjectNode present = root.putObject("present");
        layout.present().ifPresent(own -> {
            present.put("sensors", own.sensors());
            present.put("value", Numbers.rounded(own.value()));
        });
    }

    /** Adds which sensor it is, where it stands, what it costs, and what it adds. */
    private static void add(ObjectNode node, SiteCandidate sensor, PlacedLayout layout, Map<String, Double> without) {
        Position position = sensor.sensor().position();
        node.put("sensor", sensor.name());
        node.put("kind", sensor.sensor().kind());
        node.put("x", Numbers.rounded(position.x()));
        node.put("y", Numbers.rounded(position.y()));
        node.put("z", Numbers.rounded(position.z()));
        PlaceTable.azimuth(sensor)
                .ifPresentOrElse(
                        azimuth -> node.put("azimuth_deg", Numbers.rounded(azimuth)),
                        () -> node.putNull("azimuth_deg"));
        node.put("cost", Numbers.rounded(sensor.candidate().cost()));
        OptionalDouble alone = layout.alone(sensor);
        node.put("alone", alone.isPresent() ? Numbers.rounded(alone.getAsDouble()) : null);
        Double remaining = without.get(sensor.name());
        node.put("without", remaining == null ? null : Numbers.rounded(remaining));
    }
}
