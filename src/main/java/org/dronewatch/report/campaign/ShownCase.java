package org.dronewatch.report.campaign;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.report.html.Html;

/** The values of a case, and the commands that run and show it again. */
final class ShownCase {
    private ShownCase() {}

    /**
     * The table.
     *
     * @param variants variants with which the case may be shown
     * @param command command that runs a case again, without its number; empty if there is none
     */
    static String html(CampaignPlan plan, int number, List<String> variants, Optional<String> command) {
        Map<String, String> values = new LinkedHashMap<>();
        List<String> texts = plan.values(number);
        int i = 0;
        for (String path : plan.paths()) {
            values.put(path, texts.get(i++));
        }
        values.put("run.seed", Long.toString(plan.seed(number)));
        command.ifPresent(words -> {
            String run = words + " --case " + number;
            values.put("run it again", run);
            boolean isAlone = plan.variants().size() == 1;
            variants.forEach(variant -> values.put(
                    isAlone ? "watch it" : "watch it with " + variant,
                    run + (isAlone ? "" : " --variant " + variant) + " --view"));
        });
        return Html.definitions(values);
    }
}
