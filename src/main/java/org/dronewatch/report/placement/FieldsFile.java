package org.dronewatch.report.placement;

import java.util.Optional;
import org.dronewatch.analysis.field.FieldHeading;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.Gap;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.placement.site.LayoutFields;
import org.dronewatch.report.file.Numbers;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** What {@code place.json} states about the coverage at each height, as {@code coverage} finds it. */
final class FieldsFile {
    private FieldsFile() {}

    /**
     * Adds the fraction that is covered on the worst heading, and the figures of each height.
     *
     * @param fold number of sensors that must cover a cell for it to count on the worst heading, 1 or more
     */
    static void add(ObjectNode root, Optional<LayoutFields> fields, int fold) {
        Optional<LayoutFields> worst = fields.filter(its -> its.heading() != FieldHeading.INBOUND);
        root.put(
                "worst_heading",
                worst.map(its -> Numbers.rounded(LayoutFields.share(its.layout(), fold)))
                        .orElse(null));
        ArrayNode heights = root.putArray("heights");
        fields.ifPresent(its -> {
            for (int height = 0; height < its.layout().heights().size(); height++) {
                ObjectNode node = heights.addObject();
                node.put(
                        "height_m",
                        Numbers.rounded(its.layout().heights().get(height).height()));
                add(node.putObject("layout"), its.layout(), height);
                if (its.present().isPresent()) {
                    add(node.putObject("present"), its.present().get(), height);
                } else {
                    node.putNull("present");
                }
            }
        });
    }

    private static void add(ObjectNode node, FieldSummary summary, int height) {
        HeightSummary its = summary.heights().get(height);
        share(node, "covered_share", its.covered(), its.known());
        int lost = its.lost().values().stream().max(Integer::compare).orElse(0);
        share(node, "after_loss_share", its.covered() - lost, its.known());
        node.put("largest_gap_m2", Numbers.rounded(its.gap().map(Gap::area).orElse(0.0)));
    }

    private static void share(ObjectNode node, String name, int some, int all) {
        node.put(name, all == 0 ? null : Numbers.rounded((double) some / all));
    }
}
