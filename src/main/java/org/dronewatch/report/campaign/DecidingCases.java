package org.dronewatch.report.campaign;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.outcome.VariantComparison;
import org.dronewatch.report.html.Html;

/** The first case in which one of two variants is better, and the first in which the other is, side by side. */
final class DecidingCases {
    private final CampaignPlan plan;
    private final Optional<String> command;
    private final CasePictures pictures;

    /**
     * Cases of a campaign.
     *
     * @param command command that runs a case again, without its number; empty if there is none
     */
    DecidingCases(CampaignPlan plan, Optional<String> command, CasePictures pictures) {
        this.plan = plan;
        this.command = command;
        this.pictures = pictures;
    }

    /** The cases that decide between the variants of a pair; empty if none does. */
    String html(VariantComparison pair) throws IOException {
        StringBuilder html = new StringBuilder();
        for (String better : List.of(pair.a(), pair.b())) {
            Optional<Integer> first = pair.deciding().stream()
                    .filter(number -> pair.betterIn(number).equals(better))
                    .findFirst();
            if (first.isPresent()) {
                html.append(html(pair, better, first.get()));
            }
        }
        return html.toString();
    }

    private String html(VariantComparison pair, String better, int number) throws IOException {
        List<String> both = List.of(pair.a(), pair.b());
        StringBuilder html = new StringBuilder(
                Html.plain("h3", "Case " + number + ": " + ShareWords.clause(pair.outcome()) + " only with " + better));
        for (String variant : both) {
            html.append(pictures.html(number, variant));
        }
        return html + ShownCase.html(plan, number, both, command);
    }
}
