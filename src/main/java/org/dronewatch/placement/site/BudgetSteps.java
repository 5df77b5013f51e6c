package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.dronewatch.placement.Candidate;

/** Budgets below that of a layout at which another layout becomes affordable: sums of prices. */
final class BudgetSteps {
    /** The greatest number of sums that are listed; if there are more, evenly spaced budgets are as good. */
    private static final int MOST_SUMS = 4096;

    /** Sums are the same up to this, so that rounding does not split one sum in two. */
    private static final double UNIT = 1e-6;

    private BudgetSteps() {}

    /**
     * Budgets in ascending order.
     *
     * @param limit all are lower
     * @param most greatest number of them, 0 or more
     */
    static List<Double> below(double limit, int most, List<Candidate> candidates) {
        List<Double> sums = new ArrayList<>(sums(limit, candidates));
        if (sums.size() <= most) {
            return sums;
        }
        TreeSet<Double> chosen = new TreeSet<>();
        for (int step = 1; step <= most; step++) {
            double even = limit * step / (most + 1);
            chosen.add(sums.stream()
                    .filter(sum -> sum <= even)
                    .reduce((one, other) -> other)
                    .orElse(even));
        }
        return List.copyOf(chosen);
    }

    /** All sums of prices; none if there are too many. */
    private static TreeSet<Double> sums(double limit, List<Candidate> candidates) {
        TreeSet<Double> sums = new TreeSet<>(List.of(0.0));
        for (Candidate candidate : candidates) {
            if (!candidate.fixed() && sums.size() <= MOST_SUMS) {
                for (double sum : List.copyOf(sums.descendingSet())) {
                    double more = Math.rint((sum + candidate.cost()) / UNIT) * UNIT;
                    if (more < limit - UNIT) {
                        sums.add(more);
                    }
                }
            }
        }
        sums.remove(0.0);
        return sums;
    }
}
