package org.dronewatch.report;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalDouble;
import org.dronewatch.scene.AlertResult;
import org.dronewatch.scene.PairResult;
import org.dronewatch.scene.SceneResult;
import org.dronewatch.scene.SweepPoint;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** The summary of a result as JSON. */
final class Summary {
    private static final JsonMapper MAPPER = JsonMapper.builder().build();

    private final SceneResult result;

    Summary(SceneResult result) {
        this.result = result;
    }

    void write(Path file) throws IOException {
        String text = MAPPER.writerWithDefaultPrettyPrinter().writeValueAsString(toJson());
        Files.writeString(file, text.replace("\r\n", "\n") + "\n", StandardCharsets.UTF_8);
    }

    private ObjectNode toJson() {
        double wall = result.timing().wall();
        ObjectNode root = MAPPER.createObjectNode();
        root.put("scene", result.scene());
        root.put("seed", result.seed());
        root.put("threads", result.threads());
        result.runs().get(0).settings().world().origin().ifPresent(origin -> {
            ObjectNode place = root.putObject("origin");
            place.put("latitude_deg", Math.toDegrees(origin.latitude()));
            place.put("longitude_deg", Math.toDegrees(origin.longitude()));
            if (origin.hasHeight()) {
                place.put("height_m", origin.height());
            }
        });
        root.put("simulated_s", Numbers.rounded(result.simulated()));
        root.put("load_s", Numbers.rounded(result.timing().load()));
        root.put("build_s", Numbers.rounded(result.timing().build()));
        root.put("wall_s", Numbers.rounded(wall));
        ObjectNode looking = root.putObject("looking_s");
        result.timing().looking().forEach((kind, seconds) -> looking.put(kind + "_s", Numbers.rounded(seconds)));
        root.put("real_time_factor", Numbers.rounded(result.simulated() / wall));
        root.put("complete", result.complete());
        ArrayNode pairs = root.putArray("pairs");
        result.pairs().forEach(pair -> add(pairs.addObject(), pair));
        ArrayNode alerts = root.putArray("alerts");
        result.alerts().forEach(alert -> add(alerts.addObject(), alert));
        if (!result.sweep().isEmpty()) {
            ArrayNode sweep = root.putArray("sweep");
            result.sweep().forEach(point -> add(sweep.addObject(), point));
        }
        return root;
    }

    private static void add(ObjectNode node, PairResult pair) {
        node.put("run", pair.run());
        node.put("sensor", pair.sensor());
        node.put("kind", pair.kind());
        node.put("drone", pair.drone());
        put(node, "first_detected_s", pair.firstDetected());
        put(node, "range_m", pair.range());
        put(node, "max_range_m", pair.maxRange());
    }

    private static void add(ObjectNode node, AlertResult alert) {
        node.put("run", alert.run());
        node.put("drone", alert.drone());
        put(node, "first_sight_s", alert.firstSight());
        put(node, "alert_s", alert.time());
        put(node, "time_to_alert_s", alert.timeToAlert());
        ArrayNode sensors = node.putArray("sensors");
        alert.sensors().forEach(sensors::add);
        put(node, "zone_distance_m", alert.zoneDistance());
        put(node, "warning_s", alert.warning());
        put(node, "entered_s", alert.entered());
        alert.inTime().ifPresentOrElse(enough -> node.put("in_time", enough), () -> node.putNull("in_time"));
    }

    private static void add(ObjectNode node, SweepPoint point) {
        node.put("parameter", point.parameter());
        if (point.value() instanceof Double number) {
            node.put("value", number);
        } else if (point.value() instanceof Number number) {
            node.put("value", number.longValue());
        } else {
            node.put("value", point.value().toString());
        }
        node.put("sensor", point.sensor());
        put(node, "range_m", point.range());
    }

    private static void put(ObjectNode node, String key, OptionalDouble value) {
        if (value.isPresent()) {
            node.put(key, Numbers.rounded(value.getAsDouble()));
        } else {
            node.putNull(key);
        }
    }
}
