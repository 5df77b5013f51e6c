package org.dronewatch.report.route;

import java.util.Locale;
import java.util.OptionalDouble;
import org.dronewatch.report.coverage.CauseKey;
import org.dronewatch.report.file.JsonFile;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.route.CauseTimes;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.proof.ProvenChance;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.route.proof.RouteStarts;
import org.dronewatch.route.search.RouteMode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The contents of {@code route.json}. Equal inputs give the same bytes for any number of threads. */
public final class RouteFile {
    /** The version of the keys. */
    private static final int FORMAT = 1;

    private RouteFile() {}

    /** The contents, with all keys. */
    public static ObjectNode toJson(RouteResults results, RouteInputs inputs) {
        RouteSurvey survey = results.survey();
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("format", FORMAT);
        root.put("scene", inputs.scene());
        root.put("drone", inputs.drone());
        root.put("pointing", inputs.pointing().name().toLowerCase(Locale.ROOT));
        ArrayNode modes = root.putArray("modes");
        survey.modes().forEach(mode -> modes.add(mode.name()));
        root.put("launch", inputs.launch().orElse(null));
        if (survey.response() > 0.0) {
            root.put("response_s", Numbers.rounded(survey.response()));
        } else {
            root.putNull("response_s");
        }
        root.put("p_n", inputs.stopped().map(Numbers::rounded).orElse(null));
        root.put("cell_m", Numbers.rounded(inputs.grid().cell()));
        root.put("cells_per_side", inputs.grid().columns());
        ArrayNode heights = root.putArray("heights_m");
        inputs.grid().heights().forEach(height -> heights.add(Numbers.rounded(height)));
        ObjectNode between = root.putObject("between_cells");
        between.put("tried", results.between().tried());
        between.put("unseen", results.between().unseen());
        ArrayNode begins = root.putArray("starts_s");
        RouteStarts.of(inputs.settings().enabledSensors().values())
                .forEach(begin -> begins.add(Numbers.rounded(begin)));
        inputs.origin().ifPresent(origin -> JsonFile.add(root.putObject("origin"), origin));
        root.put(
                "least_exposure",
                results.leastExposed()
                        .map(route -> Numbers.rounded(route.route().exposure()))
                        .orElse(null));
        ArrayNode routes = root.putArray("routes");
        survey.routes().forEach(route -> add(routes.addObject(), route, results, inputs));
        RouteNotes notes = new RouteNotes(inputs);
        notes.notes(results).forEach(root.putArray("notes")::add);
        notes.warnings(survey).forEach(root.putArray("warnings")::add);
        root.put("complete", results.isComplete());
        return root;
    }

    private static void add(ObjectNode node, SectorRoute route, RouteResults results, RouteInputs inputs) {
        RouteSurvey survey = results.survey();
        node.put("sector", RouteWords.sector(route));
        ArrayNode points = node.putArray("points");
        route.corners().forEach(corner -> add(points.addObject(), corner, survey));
        node.put("exposure", Numbers.rounded(route.searched().exposure()));
        node.put("lower", Numbers.rounded(route.route().lower()));
        node.put("upper", Numbers.rounded(route.route().exposure()));
        node.put("p_detect", Numbers.rounded(route.detection()));
        ObjectNode sensors = node.putObject("by_sensor");
        route.sensors().forEach((sensor, exposure) -> sensors.put(sensor, Numbers.rounded(exposure)));
        add(node.putObject("causes_s"), route.causes().dominant());
        ObjectNode own = node.putObject("causes_by_sensor_s");
        route.causes().bySensor().forEach((sensor, times) -> add(own.putObject(sensor), times));
        if (survey.response() > 0.0) {
            node.put("p_in_time", Numbers.rounded(route.inTime(survey.response())));
            node.put("critical_s", Numbers.rounded(route.critical(survey.response())));
        } else {
            node.putNull("p_in_time");
            node.putNull("critical_s");
        }
        put(node, "p_i", route.alertInTime());
        put(node, "p_e", RouteResults.effectiveness(route, inputs));
        RouteProof proof = results.proofs().get(route.sector());
        if (proof == null) {
            node.putNull("proof");
        } else {
            add(node.putObject("proof"), proof);
        }
    }

    private static void add(ObjectNode node, CauseTimes times) {
        times.seconds().forEach((cause, seconds) -> node.put(CauseKey.of(cause), Numbers.rounded(seconds)));
    }

    private static void put(ObjectNode node, String key, OptionalDouble probability) {
        if (probability.isPresent()) {
            node.put(key, Numbers.rounded(probability.getAsDouble()));
        } else {
            node.putNull(key);
        }
    }

    private static void add(ObjectNode node, RouteProof proof) {
        node.put("runs", proof.detections().of());
        add(node, proof.detection());
        proof.withCues().ifPresent(cued -> {
            node.put("cued_runs", cued.flown().of());
            node.put("cued_k", cued.flown().count());
            node.put("cued_agrees", cued.agrees());
        });
        if (proof.alertInTime().isPresent()) {
            add(node.putObject("in_time"), proof.alertInTime().get());
        } else {
            node.putNull("in_time");
        }
    }

    private static void add(ObjectNode node, ProvenChance proven) {
        node.put("k", proven.flown().count());
        node.put("low", Numbers.rounded(proven.interval().low()));
        node.put("high", Numbers.rounded(proven.interval().high()));
        node.put("predicted", Numbers.rounded(proven.predicted()));
        node.put("agrees", proven.agrees());
    }

    private static void add(ObjectNode node, RoutePoint point, RouteSurvey survey) {
        RouteMode mode = survey.modes().get(point.mode());
        node.put("t", Numbers.rounded(point.time()));
        node.put("x", Numbers.rounded(point.position().x()));
        node.put("y", Numbers.rounded(point.position().y()));
        node.put("z", Numbers.rounded(point.position().z()));
        node.put("mode", mode.name());
    }
}
