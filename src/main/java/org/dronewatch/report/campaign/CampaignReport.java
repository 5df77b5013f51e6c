package org.dronewatch.report.campaign;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignResult;
import org.dronewatch.campaign.Expectation;
import org.dronewatch.campaign.outcome.CampaignSummary;
import org.dronewatch.campaign.outcome.Outcome;
import org.dronewatch.campaign.outcome.VariantComparison;
import org.dronewatch.campaign.outcome.VariantSummary;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.Page;
import org.dronewatch.report.html.ReadableNumbers;
import org.dronewatch.setting.Counted;

/**
 * A campaign for decision-makers: which variant is better, how certain that is, against attacks from which directions,
 * and the worst cases.
 */
final class CampaignReport {
    static final String NAME = "report.html";

    private final CampaignPlan plan;
    private final CampaignResult result;
    private final WorstCases worst;
    private final Optional<String> command;
    private final Outcome headline;
    private final PairWords pairs;

    /**
     * The report of a campaign that is complete.
     *
     * @param worst its worst cases
     * @param command command that runs a case again, without its number; empty if there is none
     */
    CampaignReport(CampaignPlan plan, CampaignResult result, WorstCases worst, Optional<String> command) {
        this.plan = plan;
        this.result = result;
        this.worst = worst;
        this.command = command;
        this.headline = ShareWords.headline(result.summary());
        this.pairs = new PairWords(result.summary());
    }

    /** Writes the page; the stream stays open. */
    void write(OutputStream stream) throws IOException {
        VariantTables tables = new VariantTables(result.summary());
        String scene = plan.settings().scene();
        Page page = new Page(stream, scene + ": campaign report", scene + ": campaign");
        CasePictures pictures = new CasePictures(plan);
        page.verdict(verdict());
        if (!plan.settings().expect().isEmpty()) {
            page.section("Expectations", expectations());
        }
        page.section("How often the defence succeeds", response() + tables.shares());
        page.section("By direction of attack", tables.rose());
        page.section("Warning time and range", tables.quantiles());
        Optional<String> deciding = pairs.html();
        if (deciding.isPresent()) {
            page.section("What decides between the variants", deciding.get());
            Optional<VariantComparison> best = pairs.best();
            if (best.isPresent()) {
                page.add(new DecidingCases(plan, command, pictures).html(best.get()));
            }
        }
        if (result.sensitivity().isPresent()) {
            page.section(
                    "Which settings matter",
                    new SensitivityBars(result.sensitivity().get()).html());
        }
        page.section("The worst case", worst.html(plan, command, pictures));
        List<String> failures = CampaignWords.failures(result.summary());
        if (!failures.isEmpty()) {
            page.section(
                    "Cases that failed",
                    Html.element(
                            "ul",
                            failures.stream()
                                    .map(line -> Html.plain("li", line + "."))
                                    .collect(Collectors.joining())));
        }
        page.section("What was run", new CampaignInputs(plan, command.isPresent()).html());
        page.end();
    }

    private String verdict() {
        CampaignSummary summary = result.summary();
        List<String> sentences = new ArrayList<>();
        List<String> ranked = pairs.ranked();
        sentences.add(pairs.shares());
        pairs.verdict().ifPresent(sentences::add);
        ranked.stream().findFirst().flatMap(this::worstInWords).ifPresent(sentences::add);
        int failed = summary.variants().values().stream()
                .mapToInt(VariantSummary::failed)
                .sum();
        if (failed > 0) {
            sentences.add(Counted.of(
                            failed,
                            "run failed and is not included in these figures; the reason is",
                            "runs failed and are not included in these figures; the reasons are")
                    + " at the end.");
        }
        CampaignWords.cutShort(summary).ifPresent(sentences::add);
        return String.join(" ", sentences);
    }

    private Optional<String> worstInWords(String variant) {
        boolean isAlone = plan.variants().size() == 1;
        return worst.inWords(variant, "The worst case" + (isAlone ? "" : " of " + variant));
    }

    /** What 'in time' means; empty where that does not matter. */
    private String response() {
        List<Double> responses = plan.variants().stream()
                .map(name -> plan.shared(name).alert().response())
                .distinct()
                .toList();
        boolean isOne =
                responses.size() == 1 && responses.get(0) > 0.0 && !plan.paths().contains("alert.response");
        return headline == Outcome.IN_TIME && isOne
                ? Html.plain(
                        "p",
                        "'In time' means at least " + ReadableNumbers.number(responses.get(0))
                                + " s (alert.response) before the drone can reach what is protected.")
                : "";
    }

    private String expectations() {
        String items = plan.settings().expect().stream()
                .map(this::words)
                .map(words -> Html.plain("li", words))
                .collect(Collectors.joining());
        return Html.element("ul", items);
    }

    private String words(Expectation one) {
        CampaignSummary summary = result.summary();
        return one.isMet(plan, summary)
                ? "Met: '" + ShareWords.name(one.of()) + "' for " + one.variantIn(plan) + ", lower bound at least "
                        + one.low() + ": "
                        + ShareWords.withInterval(
                                one.proportion(plan, summary).orElseThrow(),
                                one.interval(plan, summary).orElseThrow())
                        + "."
                : "Not met: " + CampaignWords.missed(plan, one, summary) + ".";
    }
}
