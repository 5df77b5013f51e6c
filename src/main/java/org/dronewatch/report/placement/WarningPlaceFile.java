package org.dronewatch.report.placement;

import java.util.Locale;
import org.dronewatch.placement.site.SiteCandidate;
import org.dronewatch.placement.site.WarningPlacement;
import org.dronewatch.report.Numbers;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * The contents of {@code place.json} for the objective {@code warning-time}: equal inputs give the same bytes for any
 * number of threads.
 */
public final class WarningPlaceFile {
    private WarningPlaceFile() {}

    /** All keys. */
    public static ObjectNode toJson(WarningPlacement placement) {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("objective", "warning-time");
        root.put("warning", placement.measure().name().toLowerCase(Locale.ROOT));
        double value = placement.value();
        root.put("value", Numbers.rounded(value));
        root.put("bound", Numbers.rounded(placement.bound()));
        double gap = placement.bound() <= value ? 0.0 : placement.bound() / value - 1.0;
        root.put("gap", Double.isFinite(gap) ? Numbers.rounded(gap) : null);
        root.put("cost", Numbers.rounded(placement.result().cost()));
        ArrayNode chosen = root.putArray("chosen");
        for (SiteCandidate sensor : placement.chosen()) {
            ObjectNode node = chosen.addObject();
            PlaceFile.describe(node, sensor);
            node.put("alone", Numbers.rounded(placement.alone(sensor)));
        }
        PlaceFile.present(root, placement.present());
        PlaceFile.order(root, placement.front());
        root.put("flights", placement.flights());
        root.put("detected", placement.detected());
        root.put("longest_s", Numbers.rounded(placement.longest()));
        root.put("complete", placement.complete());
        return root;
    }
}
