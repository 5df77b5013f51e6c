package org.dronewatch.placement.solver;

import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Adds candidates and swaps pairs by trying each, for objectives and conditions of which only the value of a choice
 * is known.
 */
final class TrialSearch {
    private final Incumbent incumbent;
    private final Rules rules;
    private final BooleanSupplier isStopped;

    TrialSearch(Incumbent incumbent, BooleanSupplier isStopped) {
        this.incumbent = incumbent;
        this.rules = incumbent.rules();
        this.isStopped = isStopped;
    }

    /** The start, with the best candidate added again and again, until none fits or makes it better. */
    int[] extended(int[] start) {
        int[] chosen = start.clone();
        Score score = incumbent.score(chosen);
        while (!isStopped.getAsBoolean()) {
            Tally tally = tally(chosen);
            int[] best = null;
            for (int candidate = 0; candidate < rules.size; candidate++) {
                if (!contains(chosen, candidate) && tally.fits(candidate)) {
                    int[] other = with(chosen, candidate);
                    Score trial = incumbent.score(other);
                    if (trial.isBetterThan(score)) {
                        score = trial;
                        best = other;
                    }
                }
            }
            if (best == null) {
                return chosen;
            }
            chosen = best;
        }
        return chosen;
    }

    /** Swaps a chosen candidate for another, and adds what then fits, until no swap makes it better. */
    int[] swapped(int[] start) {
        int[] chosen = start.clone();
        for (int[] better = betterBySwap(chosen); better != null; better = betterBySwap(chosen)) {
            chosen = extended(better);
        }
        return chosen;
    }

    private int[] betterBySwap(int[] chosen) {
        Score score = incumbent.score(chosen);
        for (int at = 0; at < chosen.length && !isStopped.getAsBoolean(); at++) {
            if (Arrays.binarySearch(rules.fixed, chosen[at]) >= 0) {
                continue;
            }
            int[] rest = without(chosen, at);
            Tally tally = tally(rest);
            for (int candidate = 0; candidate < rules.size; candidate++) {
                if (!contains(chosen, candidate) && tally.fits(candidate)) {
                    int[] other = with(rest, candidate);
                    if (incumbent.score(other).isBetterThan(score)) {
                        return other;
                    }
                }
            }
        }
        return null;
    }

    private Tally tally(int[] chosen) {
        Tally tally = new Tally(rules);
        for (int candidate : chosen) {
            tally.add(candidate);
        }
        return tally;
    }

    private static boolean contains(int[] chosen, int candidate) {
        for (int other : chosen) {
            if (other == candidate) {
                return true;
            }
        }
        return false;
    }

    private static int[] with(int[] chosen, int candidate) {
        int[] more = Arrays.copyOf(chosen, chosen.length + 1);
        more[chosen.length] = candidate;
        return more;
    }

    private static int[] without(int[] chosen, int at) {
        int[] fewer = Arrays.copyOf(chosen, chosen.length - 1);
        if (at < fewer.length) {
            fewer[at] = chosen[chosen.length - 1];
        }
        return fewer;
    }
}
