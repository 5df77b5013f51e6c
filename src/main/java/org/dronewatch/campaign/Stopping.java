package org.dronewatch.campaign;

import java.util.List;
import java.util.Optional;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.Cases;
import org.dronewatch.campaign.outcome.UntilSettings;
import org.dronewatch.statistics.Proportion;

/**
 * Decides when a campaign ends: after a fixed number of cases, or when its rule is met. Cases are added in their order.
 */
public final class Stopping {
    private final int most;
    private final int variants;
    private final Optional<UntilSettings> until;
    private final String observed;
    private int cases;
    private int count;
    private int known;

    /** Decides when a campaign ends. */
    public Stopping(CampaignPlan plan) {
        this.most = plan.size();
        this.variants = plan.variants().size();
        this.until = plan.settings().until();
        this.observed = plan.observed();
    }

    /** Ends after all of the given cases, whatever their outcomes. */
    public Stopping(Cases cases) {
        this.most = cases.size();
        this.variants = cases.variants().size();
        this.until = Optional.empty();
        this.observed = "";
    }

    /** Whether no further case is needed. */
    public boolean isReached() {
        return cases >= most || isPrecise();
    }

    /** Whether the probability is known as precisely as the campaign asks; false for a fixed number of cases. */
    public boolean isPrecise() {
        return until.map(one -> one.rule().stops(proportion())).orElse(false);
    }

    /**
     * The proportion of cases with the outcome that the rule considers, among the cases so far in which this outcome is
     * known.
     */
    public Proportion proportion() {
        return new Proportion(count, known);
    }

    /**
     * Adds results, up to the end of the campaign.
     *
     * @param results the results, by case, then by variant
     * @return how many of these cases belong to the campaign
     */
    public int add(List<CaseResult> results) {
        int added = 0;
        while (added * variants < results.size() && !isReached()) {
            addCase(results.subList(added * variants, (added + 1) * variants));
            added++;
        }
        return added;
    }

    private void addCase(List<CaseResult> results) {
        cases++;
        until.ifPresent(rule -> {
            for (CaseResult result : results) {
                if (result.variant().equals(observed) && rule.of().isKnown(result)) {
                    known++;
                    count += rule.of().isMetBy(result) ? 1 : 0;
                }
            }
        });
    }
}
