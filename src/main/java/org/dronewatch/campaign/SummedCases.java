package org.dronewatch.campaign;

import java.util.List;
import java.util.Optional;
import org.dronewatch.campaign.outcome.CampaignSummary;
import org.dronewatch.campaign.outcome.CaseResult;

/** The results of a campaign whose cases are not kept: they are summarised as they arrive. For use by one thread. */
public final class SummedCases implements CampaignRun.Chunks {
    private final CampaignSummary summary;
    private final Stopping stopping;
    private final int variants;
    private int next;

    /** A result without any cases yet. */
    public SummedCases(CampaignPlan plan) {
        this.summary = new CampaignSummary(plan.variants());
        this.stopping = new Stopping(plan);
        this.variants = plan.variants().size();
    }

    @Override
    public Optional<List<CaseResult>> find(int chunk) {
        return Optional.empty();
    }

    /** {@inheritDoc} Chunks must arrive in order, since the outcomes may decide how many there are. */
    @Override
    public void put(int chunk, List<CaseResult> results) {
        if (chunk != next) {
            throw new IllegalArgumentException("chunk " + chunk + " must be chunk " + next);
        }
        next++;
        int cases = stopping.add(results);
        for (int i = 0; i < cases; i++) {
            summary.add(results.subList(i * variants, (i + 1) * variants));
        }
    }

    /** The results so far, without sensitivities. */
    public CampaignResult result() {
        return new CampaignResult(summary, stopping, Optional.empty());
    }
}
