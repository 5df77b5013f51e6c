package org.dronewatch.campaign.outcome;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The results of a campaign: of each variant, and of each pair of them. Cases are added in any order. For use by one
 * thread.
 */
public final class CampaignSummary {
    private final Map<String, VariantSummary> variants = new LinkedHashMap<>();
    private final List<VariantComparison> comparisons = new ArrayList<>();

    /**
     * An empty summary, without any cases yet.
     *
     * @param names names of the variants, in their order
     */
    public CampaignSummary(List<String> names) {
        names.forEach(name -> variants.put(name, new VariantSummary()));
        for (int a = 0; a < names.size(); a++) {
            for (int b = a + 1; b < names.size(); b++) {
                for (Outcome outcome : Outcome.values()) {
                    comparisons.add(new VariantComparison(names.get(a), names.get(b), outcome));
                }
            }
        }
    }

    /**
     * Adds a case.
     *
     * @param results one result for each variant
     */
    public void add(List<CaseResult> results) {
        Map<String, CaseResult> byVariant = new LinkedHashMap<>();
        for (CaseResult result : results) {
            byVariant.put(result.variant(), result);
            variants.get(result.variant()).add(result);
        }
        comparisons.forEach(pair -> pair.add(byVariant.get(pair.a()), byVariant.get(pair.b())));
    }

    /** The variants by their names, in their order. */
    public Map<String, VariantSummary> variants() {
        return Collections.unmodifiableMap(variants);
    }

    /** Whether there are cases, but none could be run with any variant. */
    public boolean isAllFailed() {
        return variants.values().stream().allMatch(one -> one.failed() == one.cases())
                && variants.values().stream().anyMatch(one -> one.cases() > 0);
    }

    /** The comparisons of all pairs of variants by each outcome that is known for both. */
    public List<VariantComparison> comparisons() {
        return comparisons.stream().filter(VariantComparison::isKnown).toList();
    }
}
