package org.dronewatch.campaign;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** Cases of a campaign that are kept in memory. For one thread. */
public final class KeptCases implements CampaignRun.Chunks {
    private final CampaignPlan plan;
    private final Map<Integer, List<CaseResult>> chunks = new TreeMap<>();

    /** None yet. */
    public KeptCases(CampaignPlan plan) {
        this.plan = plan;
    }

    @Override
    public Optional<List<CaseResult>> find(int chunk) {
        return Optional.ofNullable(chunks.get(chunk));
    }

    @Override
    public void put(int chunk, List<CaseResult> results) {
        chunks.put(chunk, List.copyOf(results));
    }

    /** The results of the campaign so far, without sensitivities. */
    public CampaignResult result() {
        CampaignSummary summary = new CampaignSummary(plan.variants());
        Stopping stopping = new Stopping(plan);
        int variants = plan.variants().size();
        for (List<CaseResult> results : chunks.values()) {
            int cases = stopping.add(results);
            for (int i = 0; i < cases; i++) {
                summary.add(results.subList(i * variants, (i + 1) * variants));
            }
        }
        return new CampaignResult(summary, stopping, Optional.empty());
    }
}
