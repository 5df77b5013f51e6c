package org.dronewatch.report.placement;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.route.RoutePlacement;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.search.WeakestRoute;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** What {@code place.json} states about routes. */
final class RoutePlaceFile {
    private RoutePlaceFile() {}

    /** Adds the weakest route past the layout, as the search found it, and the condition, if there are any. */
    static void addRoute(ObjectNode node, RoutePlacement placement) {
        WeakestRoute route = placement.weakest().route();
        if (!placement.byCondition().isEmpty()) {
            node.put("condition", placement.weakest().condition().orElse(null));
        }
        node.put("exposure", Numbers.rounded(route.exposure()));
        node.put("lower", Numbers.rounded(placement.lower()));
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

    /**
     * Adds, by direction, the probability of a detection in time as flown, past the layout and past today's sensors.
     */
    static void addFlown(ArrayNode array, Optional<FlownLayout> layout, Optional<FlownLayout> present) {
        for (FlownTable.Pair pair : FlownTable.pairs(layout, present)) {
            ObjectNode node = array.addObject();
            node.put("sector", pair.from());
            put(node, "layout", pair.layout(), pair.response());
            put(node, "present", pair.present(), pair.response());
        }
    }

    private static void put(ObjectNode node, String name, Optional<SectorRoute> route, double response) {
        route.ifPresentOrElse(its -> node.put(name, Numbers.rounded(its.inTime(response))), () -> node.putNull(name));
    }
}
