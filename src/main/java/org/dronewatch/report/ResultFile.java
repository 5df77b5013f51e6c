package org.dronewatch.report;

import java.util.OptionalDouble;
import org.dronewatch.report.file.JsonFile;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.run.AlertResult;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.SweepPoint;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * The contents of {@code result.json}: only what depends on the scene, its settings and the seed, so that equal inputs
 * give the same bytes for any number of threads.
 */
public final class ResultFile {
    private final SceneResult result;

    /** The contents for a run that has ended. */
    public ResultFile(SceneResult result) {
        this.result = result;
    }

    /** The contents, with all keys. */
    public ObjectNode toJson() {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("scene", result.scene());
        root.put("seed", result.seed());
        addOrigin(root);
        root.put("simulated_s", Numbers.rounded(result.simulated()));
        addFindings(root);
        return root;
    }

    /** The geographic position of the scene's origin, if it is known. */
    void addOrigin(ObjectNode root) {
        result.runs()
                .get(0)
                .settings()
                .world()
                .origin()
                .ifPresent(origin -> JsonFile.add(root.putObject("origin"), origin));
    }

    /** What the sensors detected, in all runs. */
    void addFindings(ObjectNode root) {
        root.put("complete", result.complete());
        ArrayNode seeds = root.putArray("seeds");
        result.runs().forEach(run -> seeds.add(run.settings().run().seed()));
        ArrayNode pairs = root.putArray("pairs");
        result.pairs().forEach(pair -> add(pairs.addObject(), pair));
        ArrayNode alerts = root.putArray("alerts");
        result.alerts().forEach(alert -> add(alerts.addObject(), alert));
        FalseAlarmsKey falseAlarms = new FalseAlarmsKey(result);
        if (falseAlarms.isKnown()) {
            falseAlarms.addTo(root.putArray("false_alarms"));
        }
        if (!result.sweep().isEmpty()) {
            ArrayNode sweep = root.putArray("sweep");
            result.sweep().forEach(point -> add(sweep.addObject(), point));
        }
    }

    private static void add(ObjectNode node, PairResult pair) {
        node.put("run", pair.run());
        node.put("sensor", pair.sensor());
        node.put("kind", pair.kind());
        node.put("drone", pair.drone());
        put(node, "first_detected_s", pair.firstDetected());
        put(node, "range_m", pair.range());
        if (pair.isUnknown()) {
            node.put("unknown_ground", true);
        }
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
        alert.zone().ifPresent(zone -> node.put("zone", zone));
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

    static void put(ObjectNode node, String key, OptionalDouble value) {
        if (value.isPresent()) {
            node.put(key, Numbers.rounded(value.getAsDouble()));
        } else {
            node.putNull(key);
        }
    }
}
