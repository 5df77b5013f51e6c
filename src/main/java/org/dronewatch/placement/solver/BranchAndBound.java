package org.dronewatch.placement.solver;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.BooleanSupplier;

/**
 * Proves which choice is best: decides candidates one by one, bounds what is left by a Lagrangian relaxation, and
 * leaves out what cannot be better. A candidate without which, or with which, nothing better is possible is decided at
 * once.
 */
final class BranchAndBound {
    private static final int FIRST_STEPS = 600;
    private static final int STEPS = 60;

    private final Rules rules;
    private final Incumbent incumbent;
    private final Cutoff cutoff;
    private final Dual dual;
    private final Subgradient subgradient;
    private final BooleanSupplier isStopped;
    private final Tally tally;
    private final Deque<SearchNode> open = new ArrayDeque<>();
    private final Start begin;

    BranchAndBound(Gains gains, Incumbent incumbent, Cutoff cutoff, Start begin, BooleanSupplier isStopped) {
        this.rules = incumbent.rules();
        this.incumbent = incumbent;
        this.cutoff = cutoff;
        this.isStopped = isStopped;
        this.begin = begin;
        dual = Dual.of(gains, rules);
        subgradient = new Subgradient(dual, incumbent, cutoff, begin::improve, isStopped);
        tally = new Tally(rules);
    }

    /**
     * Searches; returns the greatest bound of what was left when the search was stopped, negative infinity if nothing
     * was.
     */
    double search() {
        byte[] state = new byte[rules.size];
        for (int candidate : rules.fixed) {
            state[candidate] = SearchNode.IN;
        }
        SearchNode root = new SearchNode(state, dual.start(begin.found()), Double.POSITIVE_INFINITY);
        open.push(root);
        int steps = FIRST_STEPS;
        while (!open.isEmpty()) {
            SearchNode node = open.pop();
            boolean isBounded = node.bound() < Double.POSITIVE_INFINITY;
            double bound = isBounded && isStopped.getAsBoolean() ? node.bound() : examined(node, steps);
            if (isStopped.getAsBoolean()) {
                return open.stream().mapToDouble(SearchNode::bound).reduce(bound, Math::max);
            }
            steps = STEPS;
        }
        return Double.NEGATIVE_INFINITY;
    }

    /** Examines a node, and opens what is left of it; returns its bound. */
    private double examined(SearchNode node, int steps) {
        byte[] state = node.state();
        if (cutoff.isHopeless(node.bound()) || !propagated(state) || !maySurviveLoss(state)) {
            return Double.NEGATIVE_INFINITY;
        }
        double bound = Math.min(node.bound(), subgradient.lowest(node.multipliers(), state, steps));
        if (isStopped.getAsBoolean()) {
            return bound;
        }
        if (cutoff.isHopeless(bound)) {
            return Double.NEGATIVE_INFINITY;
        }
        decide(state, node.multipliers(), bound);
        if (!propagated(state)) {
            return Double.NEGATIVE_INFINITY;
        }
        if (SearchNode.having(state, SearchNode.FREE, SearchNode.FREE).length == 0) {
            incumbent.offer(SearchNode.having(state, SearchNode.IN, SearchNode.IN));
            return Double.NEGATIVE_INFINITY;
        }
        branch(new SearchNode(state, node.multipliers(), bound));
        return bound;
    }

    private void branch(SearchNode node) {
        int candidate = decisive(node.state());
        open.push(node.with(candidate, SearchNode.OUT));
        open.push(node.with(candidate, SearchNode.IN));
    }

    private int decisive(byte[] state) {
        int candidate = dual.selection.decisive();
        return state[candidate] == SearchNode.FREE
                ? candidate
                : SearchNode.having(state, SearchNode.FREE, SearchNode.FREE)[0];
    }

    /** Fixes candidates for which the opposite decision cannot lead to anything better. */
    private void decide(byte[] state, double[] multipliers, double bound) {
        double current = dual.evaluate(multipliers, state);
        for (int candidate = 0; candidate < state.length; candidate++) {
            if (state[candidate] == SearchNode.FREE
                    && cutoff.isHopeless(Math.min(bound, current - dual.selection.loss(candidate)))) {
                state[candidate] = dual.selection.isPicked(candidate) ? SearchNode.IN : SearchNode.OUT;
            }
        }
    }

    /** Draws the conclusions that the rules allow; returns false if no choice complies. */
    private boolean propagated(byte[] state) {
        if (tally.isBroken(SearchNode.having(state, SearchNode.IN, SearchNode.IN))) {
            return false;
        }
        int[] left = new int[rules.kinds()];
        for (int candidate = 0; candidate < state.length; candidate++) {
            boolean mayBeServed = rules.isServed(candidate, other -> state[other] != SearchNode.OUT);
            if (state[candidate] == SearchNode.IN && !mayBeServed) {
                return false;
            }
            if (state[candidate] == SearchNode.FREE && !(tally.fits(candidate) && mayBeServed)) {
                state[candidate] = SearchNode.OUT;
            }
            if (state[candidate] != SearchNode.OUT && rules.kind[candidate] >= 0) {
                left[rules.kind[candidate]]++;
            }
        }
        for (int kind = 0; kind < left.length; kind++) {
            if (left[kind] < rules.kindAtLeast[kind]) {
                return false;
            }
        }
        return true;
    }

    /** Gains never decrease with more candidates, nor does what remains after the worst loss. */
    private boolean maySurviveLoss(byte[] state) {
        return !incumbent.hasLossCondition()
                || incumbent.shortfall(SearchNode.having(state, SearchNode.IN, SearchNode.FREE)) == 0.0;
    }
}
