package org.dronewatch.campaign;

import java.util.Optional;
import org.dronewatch.campaign.outcome.CampaignSummary;
import org.dronewatch.campaign.outcome.Outcome;
import org.dronewatch.campaign.outcome.SequentialRule;
import org.dronewatch.campaign.outcome.UntilSettings;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.statistics.Proportion;

/**
 * What a campaign is expected to show: that the interval for a probability does not extend below a limit. The interval
 * is the 95 % confidence interval or, for the probability that decided how many cases were run, the one that the rule
 * guarantees.
 *
 * @param of the outcome to whose probability the limit applies
 * @param variant the variant; the first by default
 * @param low the limit: the smallest lower bound that meets the expectation
 */
public record Expectation(
        Outcome of, Optional<String> variant, @In(value = Quantity.NUMBER, from = 0, to = 1) double low) {
    /** Checks the limits. */
    public Expectation {
        Check.present("variant", variant);
        Limits.check(Expectation.class, of, variant, low);
    }

    /** An expectation about the first variant. */
    @Defaults({"of", "low"})
    public static Expectation of(Outcome of, double low) {
        return new Expectation(of, Optional.empty(), low);
    }

    /** The variant that the expectation is about. */
    public String variantIn(CampaignPlan plan) {
        return variant.orElseGet(() -> plan.variants().get(0));
    }

    /** The proportion of cases with the outcome, among those in which it is known; empty if it is known for none. */
    public Optional<Proportion> proportion(CampaignPlan plan, CampaignSummary summary) {
        return summary.variants().get(variantIn(plan)).proportion(of);
    }

    /** Whether the campaign meets the expectation. */
    public boolean isMet(CampaignPlan plan, CampaignSummary summary) {
        return interval(plan, summary).map(one -> one.low() >= low).orElse(false);
    }

    /** The interval by which the expectation is judged; empty if the outcome is not known for any of the cases. */
    public Optional<Proportion.Interval> interval(CampaignPlan plan, CampaignSummary summary) {
        return proportion(plan, summary).map(one -> plan.settings()
                .until()
                .filter(until -> until.of() == of && plan.observed().equals(variantIn(plan)))
                .map(UntilSettings::rule)
                .filter(rule -> rule.stops(one))
                .map(rule -> rule.interval(one))
                .orElseGet(() -> one.wilson(SequentialRule.CONFIDENCE)));
    }
}
