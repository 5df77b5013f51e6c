package org.dronewatch.campaign;

import java.util.List;

/** Where a campaign ends: after a fixed number of cases, or when its rule stops. They are added in their order. */
public final class Stopping {
    private final CampaignPlan plan;
    private int cases;
    private int count;
    private int known;

    public Stopping(CampaignPlan plan) {
        this.plan = plan;
    }

    /** Whether no further case is needed. */
    public boolean isReached() {
        return cases >= plan.runs() || isPrecise();
    }

    /** Whether the probability is known as precisely as the campaign asks; false for a fixed number of cases. */
    public boolean isPrecise() {
        return plan.settings()
                .until()
                .map(until -> until.rule().stops(proportion()))
                .orElse(false);
    }

    /** The cases so far that have the outcome of the rule, of those in which it makes sense. */
    public Proportion proportion() {
        return new Proportion(count, known);
    }

    /**
     * Adds results, up to the end of the campaign.
     *
     * @param results by case, then variant
     * @return how many of the cases belong to the campaign
     */
    public int add(List<CaseResult> results) {
        int variants = plan.variants().size();
        int added = 0;
        while (added * variants < results.size() && !isReached()) {
            addCase(results.subList(added * variants, (added + 1) * variants));
            added++;
        }
        return added;
    }

    private void addCase(List<CaseResult> results) {
        cases++;
        plan.settings().until().ifPresent(until -> {
            String variant = plan.observed();
            for (CaseResult result : results) {
                if (result.variant().equals(variant) && until.of().isKnown(result)) {
                    known++;
                    count += until.of().isMetBy(result) ? 1 : 0;
                }
            }
        });
    }
}
