package org.dronewatch.report.campaign;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignSettings;
import org.dronewatch.campaign.variation.EvenlySpaced;
import org.dronewatch.campaign.variation.Normal;
import org.dronewatch.campaign.variation.Variation;
import org.dronewatch.report.html.Html;
import org.dronewatch.setting.PlainText;

/** What a campaign runs: its variants, and what varies. */
final class CampaignInputs {
    private final CampaignPlan plan;
    private final boolean hasProvenance;

    /**
     * The inputs of a campaign.
     *
     * @param hasProvenance whether provenance.json lies beside the page
     */
    CampaignInputs(CampaignPlan plan, boolean hasProvenance) {
        this.plan = plan;
        this.hasProvenance = hasProvenance;
    }

    /** The section. */
    String html() {
        CampaignSettings settings = plan.settings();
        List<List<String>> rows = new ArrayList<>();
        settings.variants().forEach((name, changes) -> rows.add(List.of(name, changed(changes))));
        Map<String, String> varied = new LinkedHashMap<>();
        settings.table().ifPresent(name -> varied.put("table", PlainText.value(name)));
        settings.vary().forEach((path, variation) -> varied.put(path, words(variation)));
        return Html.plain("p", introduction(settings))
                + (rows.isEmpty() ? "" : Html.table(List.of("variant", "settings that differ from the scene"), rows))
                + (varied.isEmpty() ? "" : Html.definitions(varied));
    }

    private String introduction(CampaignSettings settings) {
        return "The scene is " + settings.scene() + ", and the seed is " + settings.seed()
                + ". The probabilities hold for the distributions below, which are assumptions: nobody knows where"
                + " the next attack will come from. "
                + settings.until()
                        .map(until -> String.format(
                                Locale.ROOT,
                                "The outcomes determined how many cases were run: cases were added until the"
                                        + " probability of '%s' for %s was known to within %s. The other intervals are"
                                        + " approximate. ",
                                ShareWords.name(until.of()),
                                plan.observed(),
                                CampaignWords.points(until.halfWidth())))
                        .orElse("")
                + (hasProvenance
                        ? "runs.csv contains all cases, campaign.json all figures, and provenance.json the origin of"
                                + " both."
                        : "runs.csv contains all cases, and campaign.json all figures.");
    }

    private static String changed(Map<String, String> changes) {
        return changes.isEmpty()
                ? "none"
                : changes.entrySet().stream()
                        .map(one -> one.getKey() + " = " + PlainText.value(one.getValue()))
                        .collect(Collectors.joining("; "));
    }

    private static String words(Variation variation) {
        return PlainText.value(variation
                .values()
                .map(all -> "one of " + String.join(", ", all))
                .or(() -> variation.range().map(CampaignInputs::words))
                .or(() -> variation.uniform().map(one -> "uniform from " + one.from() + " to " + one.to()))
                .or(() -> variation
                        .triangular()
                        .map(one -> "triangular from " + one.from() + " to " + one.to() + " with mode " + one.mode()))
                .or(() -> variation.normal().map(CampaignInputs::words))
                .orElse(""));
    }

    private static String words(EvenlySpaced one) {
        return one.count().map(count -> "one of " + count + " values").orElse("one of the values") + " from "
                + one.from() + " to " + one.to()
                + one.step().map(step -> " in steps of " + step).orElse("");
    }

    private static String words(Normal one) {
        return "normal with mean " + one.mean() + " and standard deviation " + one.deviation()
                + one.from().map(from -> ", at least " + from).orElse("")
                + one.to().map(to -> ", at most " + to).orElse("");
    }
}
