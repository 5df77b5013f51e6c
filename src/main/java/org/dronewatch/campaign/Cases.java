package org.dronewatch.campaign;

import java.util.List;

/** Cases that can be run in any order, each with every one of some variants. Immutable and thread-safe. */
public interface Cases {
    /** The number of cases, or, if it depends on their outcomes, the largest number. */
    int size();

    /** The names of the variants that they are run with. */
    List<String> variants();

    /** The texts of the values of a case, in the order of {@link CampaignPlan#paths()}. */
    List<String> values(int number);

    /** The seed of the runs of a case, the same for all variants. */
    long seed(int number);
}
