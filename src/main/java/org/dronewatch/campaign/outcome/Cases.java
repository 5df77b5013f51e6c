package org.dronewatch.campaign.outcome;

import java.util.List;

/** Cases that can be run in any order, each with every variant. Immutable and thread-safe. */
public interface Cases {
    /** The number of cases, or, if it depends on their outcomes, the largest number. */
    int size();

    /** The names of the variants with which the cases are run. */
    List<String> variants();

    /** The values of a case as text, in the order of {@code CampaignPlan.paths()}. */
    List<String> values(int number);

    /** The seed of the runs of a case, the same for all variants. */
    long seed(int number);
}
