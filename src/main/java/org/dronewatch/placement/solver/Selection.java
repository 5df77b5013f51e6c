package org.dronewatch.placement.solver;

import java.util.Arrays;

/**
 * The choice with the greatest sum of shares, at least as great as any that complies. Number, kinds and the exclusive
 * places of one kind each form a laminar matroid, for which the greedy choice is the best; the budget enters by a
 * price, the Lagrange multiplier with the least bound. Minimum numbers and the other exclusive places are not taken
 * into account. Not thread-safe.
 */
final class Selection {
    private static final int BISECTIONS = 24;

    private final Rules rules;
    private final Tally tally;
    private final Order sorting;
    private final int[] order;
    private final double[] key;
    private final boolean[] isTaken;
    private final int[] ofKind;
    private int free;

    /** Whether a candidate is picked, in addition to those that are decided. */
    private final boolean[] isPicked;

    private int picked;
    private double sum;
    private double cost;
    private double bound;

    /** A picked choice within the budget. */
    private int[] affordable = {};

    Selection(Rules rules) {
        this.rules = rules;
        tally = new Tally(rules);
        sorting = new Order(rules.size);
        order = new int[rules.size];
        key = new double[rules.size];
        isPicked = new boolean[rules.size];
        isTaken = new boolean[rules.places];
        ofKind = new int[rules.kinds()];
    }

    /** An upper bound on the sum of shares over all choices that agree with the decisions. */
    double solve(double[] share, byte[] state) {
        tally.clear();
        double decided = 0.0;
        free = 0;
        for (int candidate = 0; candidate < state.length; candidate++) {
            if (state[candidate] == SearchNode.IN) {
                tally.add(candidate);
                decided += share[candidate];
            } else if (state[candidate] == SearchNode.FREE) {
                order[free++] = candidate;
            }
        }
        double rest = rules.budget - tally.cost();
        pick(0.0, share);
        bound = sum;
        if (cost > rest) {
            priceBudget(share, rest, state);
        } else {
            affordable = withPicked(state);
        }
        bound += decided;
        return bound;
    }

    /** Bisects the price of the budget; leaves the picks at the price with the least bound. */
    private void priceBudget(double[] share, double rest, byte[] state) {
        double low = 0.0;
        double high = 0.0;
        for (int at = 0; at < free; at++) {
            double candidateCost = rules.cost[order[at]];
            high = Math.max(high, candidateCost > 0.0 ? share[order[at]] / candidateCost : 0.0);
        }
        double best = 0.0;
        affordable = SearchNode.having(state, SearchNode.IN, SearchNode.IN);
        for (int bisection = 0; bisection < BISECTIONS; bisection++) {
            double price = 0.5 * (low + high);
            pick(price, share);
            double priced = sum + price * rest;
            if (priced < bound) {
                bound = priced;
                best = price;
            }
            if (cost > rest) {
                low = price;
            } else {
                high = price;
                affordable = withPicked(state);
            }
        }
        pick(best, share);
    }

    /** Picks the candidates with the greatest keys, the shares less their priced costs. */
    private void pick(double price, double[] share) {
        for (int at = 0; at < free; at++) {
            key[order[at]] = share[order[at]] - price * rules.cost[order[at]];
        }
        sorting.sort(order, free, key);
        Arrays.fill(isPicked, false);
        for (int place = 0; place < isTaken.length; place++) {
            isTaken[place] = tally.isTaken(place);
        }
        for (int kind = 0; kind < ofKind.length; kind++) {
            ofKind[kind] = tally.ofKind(kind);
        }
        sum = 0.0;
        cost = 0.0;
        picked = 0;
        for (int at = 0; at < free && key[order[at]] > 0.0 && tally.count() + picked < rules.atMost; at++) {
            int candidate = order[at];
            if (!isBarred(candidate)) {
                pick(candidate);
            }
        }
    }

    private boolean isBarred(int candidate) {
        int place = rules.place[candidate];
        int kind = rules.kind[candidate];
        return place >= 0 && rules.isNested[place] && isTaken[place]
                || kind >= 0 && ofKind[kind] >= rules.kindAtMost[kind];
    }

    private void pick(int candidate) {
        isPicked[candidate] = true;
        sum += key[candidate];
        cost += rules.cost[candidate];
        picked++;
        if (rules.place[candidate] >= 0) {
            isTaken[rules.place[candidate]] = true;
        }
        if (rules.kind[candidate] >= 0) {
            ofKind[rules.kind[candidate]]++;
        }
    }

    private int[] withPicked(byte[] state) {
        boolean[] all = isPicked.clone();
        for (int candidate = 0; candidate < all.length; candidate++) {
            all[candidate] |= state[candidate] == SearchNode.IN;
        }
        return indices(all);
    }

    private static int[] indices(boolean[] isChosen) {
        int[] indices = new int[isChosen.length];
        int count = 0;
        for (int candidate = 0; candidate < isChosen.length; candidate++) {
            if (isChosen[candidate]) {
                indices[count++] = candidate;
            }
        }
        return Arrays.copyOf(indices, count);
    }

    boolean isPicked(int candidate) {
        return isPicked[candidate];
    }

    /** The decided and picked candidates if the budget suffices for them; otherwise some that it suffices for. */
    int[] affordable() {
        return affordable;
    }

    /**
     * The least amount by which the bound decreases if a free candidate that is not picked is chosen, or one that is
     * picked is not: another takes its place.
     */
    double loss(int candidate) {
        if (isPicked[candidate]) {
            return key[candidate] - Math.max(0.0, bestKey(false));
        }
        boolean isInstead = tally.count() + picked >= rules.atMost || isBarred(candidate);
        return (isInstead && picked > 0 ? leastPicked() : 0.0) - key[candidate];
    }

    private double bestKey(boolean ofPicked) {
        for (int at = 0; at < free; at++) {
            if (isPicked[order[at]] == ofPicked) {
                return key[order[at]];
            }
        }
        return 0.0;
    }

    private double leastPicked() {
        for (int at = free - 1; at >= 0; at--) {
            if (isPicked[order[at]]) {
                return key[order[at]];
            }
        }
        return 0.0;
    }

    /** The free candidate that decides most: the picked one with the greatest key, or else the greatest key of all. */
    int decisive() {
        for (int at = 0; at < free; at++) {
            if (isPicked[order[at]]) {
                return order[at];
            }
        }
        return order[0];
    }
}
