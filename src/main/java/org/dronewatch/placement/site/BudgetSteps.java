package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.NavigableSet;
import java.util.TreeSet;
import org.dronewatch.placement.Candidate;

/** Budgets below that of a layout at which another layout becomes affordable: sums of prices. */
final class BudgetSteps {
    /** The greatest number of sums that are listed; if there are more, evenly spaced budgets are as good. */
    private static final int MOST_SUMS = 4096;

    /** Sums are rounded to multiples of this, so that rounding errors do not split one sum in two. */
    private static final double UNIT = 1e-6;

    private BudgetSteps() {}

    /**
     * Evenly spaced budgets in ascending order.
     *
     * @param sums the sums of prices
     * @param limit a limit below which all of them lie
     * @param most greatest number of them, 0 or more
     */
    static List<Double> spread(NavigableSet<Double> sums, double limit, int most) {
        if (sums.size() <= most) {
            return List.copyOf(sums);
        }
        TreeSet<Double> chosen = new TreeSet<>();
        for (int step = 1; step <= most; step++) {
            double even = limit * step / (most + 1);
            chosen.add(sums.stream()
                    .filter(sum -> sum <= even)
                    .reduce((one, other) -> other)
                    .orElseGet(sums::first));
        }
        return List.copyOf(chosen);
    }

    /**
     * Further budgets, each at the midpoint of what is then the widest interval that has any sum inside.
     *
     * @param sums the sums of prices
     * @param had the budgets between which they lie, in any order
     * @param most greatest number of them
     */
    static List<Double> between(NavigableSet<Double> sums, Collection<Double> had, int most) {
        TreeSet<Double> ends = new TreeSet<>(had);
        List<Double> further = new ArrayList<>();
        while (further.size() < most) {
            double widest = 0.0;
            double middle = Double.NaN;
            for (double low : ends) {
                Double high = ends.higher(low);
                NavigableSet<Double> inside = high == null ? new TreeSet<>() : sums.subSet(low, false, high, false);
                if (!inside.isEmpty() && high - low > widest) {
                    widest = high - low;
                    double even = 0.5 * (low + high);
                    middle = inside.stream()
                            .min(Comparator.comparingDouble(sum -> Math.abs(sum - even)))
                            .orElseThrow();
                }
            }
            if (Double.isNaN(middle)) {
                return further;
            }
            ends.add(middle);
            further.add(middle);
        }
        return further;
    }

    /** Whether all sums of prices are listed. */
    static boolean isWhole(NavigableSet<Double> sums) {
        return sums.size() <= MOST_SUMS;
    }

    /** All sums of prices below a limit; if there are too many, those of some of the candidates. */
    static NavigableSet<Double> sums(double limit, List<Candidate> candidates) {
        TreeSet<Double> sums = new TreeSet<>(List.of(0.0));
        for (Candidate candidate : candidates) {
            if (!candidate.fixed() && isWhole(sums)) {
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
