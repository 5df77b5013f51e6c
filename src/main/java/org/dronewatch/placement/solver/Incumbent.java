package org.dronewatch.placement.solver;

import java.util.OptionalDouble;

/** The best choice so far that complies with every condition. Not thread-safe: one per search. */
final class Incumbent {
    private static final double ROUNDING = 1e-9;

    private final Rules rules;
    private final Valuation valuation;
    private final Tally tally;
    private final OptionalDouble needed;
    private int[] chosen;
    private double value = Double.NEGATIVE_INFINITY;

    /**
     * A best choice that has not been found yet.
     *
     * @param needed gain that must remain after the worst loss
     */
    Incumbent(Gains gains, Rules rules, OptionalDouble needed) {
        this.rules = rules;
        this.valuation = new Valuation(gains);
        this.tally = new Tally(rules);
        this.needed = needed;
    }

    /** Takes over a choice if it complies and is better. */
    void offer(int[] other) {
        if (tally.isBroken(other) || missing(other) > 0) {
            return;
        }
        double offered = valuation.value(other);
        if (offered > value && shortfall(other) == 0.0) {
            value = offered;
            chosen = other.clone();
        }
    }

    /** Whether a choice breaks no rule, though more may be missing. */
    boolean isLegal(int[] other) {
        return !tally.isBroken(other);
    }

    /** Whether a choice complies, and has the gain of the best. */
    boolean isAsGood(int[] other) {
        return !tally.isBroken(other)
                && missing(other) == 0
                && shortfall(other) == 0.0
                && valuation.value(other) >= value;
    }

    /** How many candidates are missing of those that some kinds, or other candidates, need. */
    private int missing(int[] tallied) {
        return tally.missing() + rules.lacking(tallied);
    }

    /** How much of what must remain after the worst loss is missing, as a fraction of it; 0 if none is. */
    double shortfall(int[] other) {
        if (needed.isEmpty()) {
            return 0.0;
        }
        double scale = Math.max(1.0, Math.abs(needed.getAsDouble()));
        double missing = (needed.getAsDouble() - worstLoss(other)) / scale;
        return missing > ROUNDING ? missing : 0.0;
    }

    private double worstLoss(int[] other) {
        double worst = valuation.worstLoss(other);
        for (int lost : other) {
            if (rules.stopsOthers(other, lost)) {
                worst = Math.min(worst, valuation.value(rules.remaining(other, lost)));
            }
        }
        return worst;
    }

    /** The score of any choice that breaks no rule. */
    Score score(int[] other) {
        tally.isBroken(other);
        double penalty = missing(other) + shortfall(other);
        double gain = valuation.value(other);
        return new Score(penalty, gain, valuation.progress());
    }

    boolean isFound() {
        return chosen != null;
    }

    /** What is chosen; there must be one. */
    int[] chosen() {
        return chosen.clone();
    }

    /** Its gain; negative infinity if there is none. */
    double value() {
        return value;
    }

    Rules rules() {
        return rules;
    }

    boolean hasLossCondition() {
        return needed.isPresent();
    }
}
