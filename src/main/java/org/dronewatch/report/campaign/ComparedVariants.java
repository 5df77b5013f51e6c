package org.dronewatch.report.campaign;

import java.util.List;
import org.dronewatch.campaign.outcome.CampaignSummary;

/** Compares the variants of a campaign, for a section of a report on another subject. */
public final class ComparedVariants {
    private final CampaignSummary summary;
    private final PairWords pairs;

    /** The comparison of all variants of a campaign. */
    public ComparedVariants(CampaignSummary summary) {
        this.summary = summary;
        this.pairs = new PairWords(summary);
    }

    /** How often each variant succeeds, and whether the difference is more than chance, in plain text. */
    public String verdict() {
        return (pairs.shares() + " " + pairs.verdict().orElse("")).strip();
    }

    /** Tables and figures with confidence intervals, and the cases that decide, as mark-up. */
    public String html() {
        VariantTables tables = new VariantTables(summary);
        return tables.shares() + tables.quantiles() + pairs.html().orElse("");
    }

    /** What casts doubt on the results, in sentences: cases that failed, and runs that end too early. */
    public List<String> doubts() {
        return CampaignWords.doubts(summary);
    }
}
