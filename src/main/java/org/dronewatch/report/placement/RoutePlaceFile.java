package org.dronewatch.report.placement;

import org.dronewatch.geometry.Position;
import org.dronewatch.placement.site.RoutePlacement;
import org.dronewatch.placement.site.SiteCandidate;
import org.dronewatch.report.Numbers;
import org.dronewatch.route.search.WeakestRoute;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * The contents of {@code place.json} for the objective {@code weakest-route}: equal inputs give the same bytes for any
 * number of threads.
 */
public final class RoutePlaceFile {
    private RoutePlaceFile() {}

    /** All keys. */
    public static ObjectNode toJson(RoutePlacement placement) {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("objective", "weakest-route");
        root.put("value", Numbers.rounded(placement.result().value()));
        root.put("bound", Numbers.rounded(placement.result().bound()));
        double gap = placement.result().gap();
        root.put("gap", Double.isFinite(gap) ? Numbers.rounded(gap) : null);
        root.put("cost", Numbers.rounded(placement.result().cost()));
        ArrayNode chosen = root.putArray("chosen");
        placement.chosen().forEach(sensor -> add(chosen.addObject(), sensor, placement));
        PlaceFile.present(root, placement.present());
        PlaceFile.order(root, placement.front());
        add(root.putObject("route"), placement.weakest(), placement.lower());
        root.put("rounds", placement.rounds());
        root.put("routes", placement.routes());
        root.put("complete", placement.complete());
        return root;
    }

    private static void add(ObjectNode node, SiteCandidate sensor, RoutePlacement placement) {
        PlaceFile.describe(node, sensor);
        Double alone = placement.alone().get(sensor.name());
        Double without = placement.without().get(sensor.name());
        node.put("alone", alone == null ? null : Numbers.rounded(alone));
        node.put("without", without == null ? null : Numbers.rounded(without));
    }

    private static void add(ObjectNode node, WeakestRoute route, double lower) {
        node.put("exposure", Numbers.rounded(route.exposure()));
        node.put("lower", Numbers.rounded(lower));
        node.put("p_detect", Numbers.rounded(route.detection()));
        node.put("duration_s", Numbers.rounded(route.seconds()));
        ArrayNode points = node.putArray("points");
        for (Position at : route.path().points()) {
            ObjectNode point = points.addObject();
            point.put("x", Numbers.rounded(at.x()));
            point.put("y", Numbers.rounded(at.y()));
            point.put("z", Numbers.rounded(at.z()));
        }
    }
}
