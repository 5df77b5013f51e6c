package org.dronewatch.placement.solver;

/**
 * How good a choice is, even one that does not comply yet.
 *
 * @param penalty what is missing of the conditions; less is better
 * @param value its gain
 * @param progress decides between choices that are otherwise equal
 */
record Score(double penalty, double value, double progress) {
    private static final double ROUNDING = 1e-12;

    /** Whether it is better by more than rounding errors. */
    boolean isBetterThan(Score other) {
        if (isMore(other.penalty, penalty) || isMore(penalty, other.penalty)) {
            return penalty < other.penalty;
        }
        if (isMore(value, other.value) || isMore(other.value, value)) {
            return value > other.value;
        }
        return isMore(progress, other.progress);
    }

    private static boolean isMore(double one, double other) {
        return one - other > ROUNDING * Math.max(1.0, Math.abs(other));
    }
}
