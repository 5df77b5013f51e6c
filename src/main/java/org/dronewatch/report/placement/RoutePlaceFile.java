package org.dronewatch.report.placement;

import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.route.DirectedRoute;
import org.dronewatch.placement.route.RoutePlacement;
import org.dronewatch.report.CompassPoint;
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
        add(node, placement.weakest(), placement.lower(), placement);
    }

    /** Adds the weakest routes past all affordable candidates, from each direction. */
    static void addRemaining(ArrayNode array, RoutePlacement placement) {
        for (DirectedRoute one : placement.remaining()) {
            ObjectNode node = array.addObject();
            node.put("sector", CompassPoint.of(one.bearing()));
            add(node, one, one.route().lower(), placement);
        }
    }

    private static void add(ObjectNode node, DirectedRoute directed, double lower, RoutePlacement placement) {
        WeakestRoute route = directed.route();
        if (!placement.byCondition().isEmpty()) {
            node.put("condition", directed.condition().orElse(null));
        }
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

    /** Adds the direction of a route, and the probability that the drone is detected in time on it, as flown. */
    static void addInTime(ObjectNode node, SectorRoute route, FlownLayout flown) {
        node.put("sector", CompassPoint.of(route.bearing()));
        node.put("p_in_time", Numbers.rounded(flown.inTime(route)));
    }

    /** Adds, by the sensor that is lost, the weakest route past the others, as flown. */
    static void addLosses(ArrayNode array, List<FlownPromise.Loss> losses) {
        for (FlownPromise.Loss loss : losses) {
            ObjectNode node = array.addObject();
            node.put("sensor", loss.sensor());
            addInTime(node, loss.route(), loss.flown());
        }
    }

    private static void put(ObjectNode node, String name, Optional<SectorRoute> route, double response) {
        route.ifPresentOrElse(its -> node.put(name, Numbers.rounded(its.inTime(response))), () -> node.putNull(name));
    }
}
