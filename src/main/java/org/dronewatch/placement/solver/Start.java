package org.dronewatch.placement.solver;

import java.util.List;
import java.util.function.BooleanSupplier;

/** A good choice to begin with: greedy, then improved by swaps. */
final class Start {
    private final Gains gains;
    private final Incumbent incumbent;
    private final BooleanSupplier isStopped;

    Start(Gains gains, Incumbent incumbent, BooleanSupplier isStopped) {
        this.gains = gains;
        this.incumbent = incumbent;
        this.isStopped = isStopped;
    }

    /** Offers what it finds; returns the best, or one that does not comply if there is no better. */
    int[] found() {
        int[] chosen = gains.isSubmodular() && !incumbent.hasLossCondition() ? greedy() : tried();
        return incumbent.isFound() ? incumbent.chosen() : chosen;
    }

    private int[] greedy() {
        Rules rules = incumbent.rules();
        int[] chosen = rules.fixed;
        boolean hasBudget = rules.budget < Double.POSITIVE_INFINITY;
        for (boolean byCost : hasBudget ? List.of(false, true) : List.of(false)) {
            LazyGreedy greedy = new LazyGreedy(gains, rules, byCost);
            chosen = greedy.extended(rules.fixed);
            incumbent.offer(chosen);
            improve(chosen);
        }
        return chosen;
    }

    /** Offers what swaps make of a choice that breaks no rule, where they are quick. */
    void improve(int[] chosen) {
        boolean isQuick = gains.form == Gains.Form.BEST_SUM && gains.fold == 1 && !incumbent.hasLossCondition();
        if (isQuick && !isStopped.getAsBoolean() && incumbent.isLegal(chosen)) {
            Rules rules = incumbent.rules();
            int[] more = new LazyGreedy(gains, rules, false).extended(chosen);
            incumbent.offer(new LazyGreedy(gains, rules, false)
                    .extended(new Interchange(gains, rules, isStopped).swapped(more)));
        }
    }

    private int[] tried() {
        TrialSearch trials = new TrialSearch(incumbent, isStopped);
        int[] chosen = trials.extended(incumbent.rules().fixed);
        incumbent.offer(chosen);
        chosen = trials.swapped(chosen);
        incumbent.offer(chosen);
        return chosen;
    }
}
