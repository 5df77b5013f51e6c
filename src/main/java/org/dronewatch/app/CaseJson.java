package org.dronewatch.app;

import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.report.file.Numbers;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The JSON that {@code campaign --case} and {@code compare --case} print for programs. */
final class CaseJson {
    private CaseJson() {}

    /** The values of a case, and its outcome with each variant. */
    static ObjectNode of(CampaignPlan plan, int number, List<CaseResult> results) {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("case", number);
        root.put("seed", plan.seed(number));
        ObjectNode values = root.putObject("values");
        List<String> texts = plan.values(number);
        int i = 0;
        for (String path : plan.paths()) {
            values.put(path, texts.get(i++));
        }
        ObjectNode variants = root.putObject("variants");
        results.forEach(result -> add(variants.putObject(result.variant()), result));
        return root;
    }

    private static void add(ObjectNode node, CaseResult result) {
        node.put("error", result.error().orElse(null));
        put(node, "first_detected_s", result.firstDetected());
        node.put("first_sensor", result.firstSensor().orElse(null));
        put(node, "range_m", result.range());
        put(node, "alert_s", result.alert());
        put(node, "warning_s", result.warning());
        node.put("in_time", result.inTime().orElse(null));
        put(node, "closest_m", result.closest());
    }

    private static void put(ObjectNode node, String key, OptionalDouble value) {
        node.put(key, value.isPresent() ? Numbers.rounded(value.getAsDouble()) : null);
    }
}
