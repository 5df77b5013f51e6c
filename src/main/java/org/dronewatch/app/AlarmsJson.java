package org.dronewatch.app;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.fusion.AlertRule;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.Confirmation;
import org.dronewatch.fusion.FalseAlertRate;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.alarm.FalseAlarmRate;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The JSON that {@code alarms} prints for programs. Rates may be tiny, and are therefore not rounded. */
final class AlarmsJson {
    private AlarmsJson() {}

    /** The rates of all sensors, and the false alerts with each rule. */
    static ObjectNode of(SceneSettings settings, List<Confirmation> rules) {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        ArrayNode sensors = root.putArray("sensors");
        settings.enabledSensors().forEach((id, sensor) -> {
            ObjectNode one = sensors.addObject().put("sensor", id).put("kind", sensor.kind());
            add(one, AlarmsCommand.rate(sensor, settings.world().weather()));
        });
        AlertSettings alert = settings.alert();
        add(root.putObject("false_alerts"), AlarmsCommand.rate(alert, settings));
        ArrayNode all = root.putArray("rules");
        if (!(alert.rule() instanceof AlertRule.UnionOfProbabilities)) {
            rules.forEach(confirm -> add(all.addObject(), confirm, settings));
        }
        return root;
    }

    /** A setting and its value. */
    static ObjectNode of(Map.Entry<String, String> wanted) {
        return JsonNodeFactory.instance
                .objectNode()
                .put("setting", wanted.getKey())
                .put("value", Double.parseDouble(wanted.getValue()));
    }

    private static void add(ObjectNode node, Optional<FalseAlarmRate> known) {
        node.put("per_hour", known.map(FalseAlarmRate::perHour).orElse(null));
        node.put("per_look", known.map(FalseAlarmRate::perLook).orElse(null));
        node.put("cells", known.map(FalseAlarmRate::cells).orElse(null));
        node.put("looks", known.map(FalseAlarmRate::looks).orElse(null));
    }

    private static void add(ObjectNode node, Confirmation confirm, SceneSettings settings) {
        node.put("hits", confirm.hits());
        node.put("looks", confirm.looks());
        node.put("confirmed_at_50", confirm.probability(AlarmsCommand.EVEN));
        node.put("confirmed_at_90", confirm.probability(AlarmsCommand.LIKELY));
        node.put("of_scene", confirm.equals(settings.alert().confirm()));
        AlertSettings changed = settings.alert().withConfirmation(confirm.hits(), confirm.looks());
        add(node.putObject("false_alerts"), AlarmsCommand.rate(changed, settings));
    }

    private static void add(ObjectNode node, FalseAlertRate rate) {
        node.put("per_day", rate.isUnknown() ? null : (Double) rate.perDay());
        node.put("upper_bound", rate.isUpperBound());
        ArrayNode unknown = node.putArray("unknown");
        rate.unknown().forEach(unknown::add);
    }
}
