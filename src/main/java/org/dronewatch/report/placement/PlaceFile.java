package org.dronewatch.report.placement;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.PlaceStep;
import org.dronewatch.placement.site.PresentLayout;
import org.dronewatch.placement.site.SiteCandidate;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.report.Numbers;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The contents of {@code place.json}: equal inputs give the same bytes for any number of threads. */
public final class PlaceFile {
    private PlaceFile() {}

    /** All keys. */
    public static ObjectNode toJson(PlaceResults results) {
        SitePlacement placement = results.best();
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("objective", placement.plan().settings().objective().name().toLowerCase(Locale.ROOT));
        root.put("value", Numbers.rounded(placement.value()));
        root.put("bound", Numbers.rounded(placement.bound()));
        double gap = placement.result().gap();
        root.put("gap", Double.isFinite(gap) ? Numbers.rounded(gap) : null);
        root.put("cost", Numbers.rounded(placement.result().cost()));
        conditions(root, placement);
        ArrayNode chosen = root.putArray("chosen");
        placement.chosen().forEach(sensor -> add(chosen.addObject(), sensor, placement));
        present(root, placement.present());
        ArrayNode front = root.putArray("front");
        for (FrontPoint point : results.front().points()) {
            ObjectNode node = front.addObject();
            node.put("cost", Numbers.rounded(point.cost()));
            node.put("value", Numbers.rounded(point.layout().value()));
            ArrayNode added = node.putArray("added");
            point.added().forEach(added::add);
        }
        root.put("complete", results.complete());
        return root;
    }

    /** Adds what the layout covers as the scene is and under each condition, if there are any. */
    private static void conditions(ObjectNode root, SitePlacement placement) {
        Map<String, Double> fractions = placement.byCondition();
        if (!fractions.isEmpty()) {
            root.put("as_it_is", Numbers.rounded(placement.asItIs()));
            ArrayNode conditions = root.putArray("conditions");
            fractions.forEach((name, fraction) ->
                    conditions.addObject().put("name", name).put("value", Numbers.rounded(fraction)));
        }
    }

    private static void add(ObjectNode node, SiteCandidate sensor, SitePlacement placement) {
        describe(node, sensor);
        node.put("alone", Numbers.rounded(placement.alone(sensor)));
    }

    /** Adds the layout of today: the number of its sensors and its value; neither where the scene has no sensors. */
    static void present(ObjectNode root, Optional<PresentLayout> layout) {
        ObjectNode present = root.putObject("present");
        layout.ifPresent(own -> {
            present.put("sensors", own.sensors());
            present.put("value", Numbers.rounded(own.value()));
        });
    }

    /** Adds the best order in which to buy the sensors of a layout. */
    static void order(ObjectNode root, List<PlaceStep> steps) {
        ArrayNode front = root.putArray("front");
        for (PlaceStep step : steps) {
            ObjectNode node = front.addObject();
            node.put("cost", Numbers.rounded(step.cost()));
            node.put("value", Numbers.rounded(step.value()));
            node.putArray("added").add(step.added());
        }
    }

    /** Adds which sensor it is, where it stands, and what it costs. */
    static void describe(ObjectNode node, SiteCandidate sensor) {
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
    }
}
