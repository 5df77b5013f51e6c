package org.dronewatch.placement.solver;

import java.util.Arrays;

/** How much of the limits in the conditions a choice has used up so far. Not thread-safe. */
final class Tally {
    private final Rules rules;
    private final boolean[] isTaken;
    private final int[] ofKind;
    private double cost;
    private int count;

    Tally(Rules rules) {
        this.rules = rules;
        isTaken = new boolean[rules.places];
        ofKind = new int[rules.kinds()];
    }

    /** Begins again with nothing chosen. */
    void clear() {
        Arrays.fill(isTaken, false);
        Arrays.fill(ofKind, 0);
        cost = 0.0;
        count = 0;
    }

    /** Chooses a candidate, whether it fits or not. */
    void add(int candidate) {
        count++;
        cost += rules.cost[candidate];
        if (rules.place[candidate] >= 0) {
            isTaken[rules.place[candidate]] = true;
        }
        if (rules.kind[candidate] >= 0) {
            ofKind[rules.kind[candidate]]++;
        }
    }

    /** Takes back a candidate that was added. */
    void remove(int candidate) {
        count--;
        cost -= rules.cost[candidate];
        if (rules.place[candidate] >= 0) {
            isTaken[rules.place[candidate]] = false;
        }
        if (rules.kind[candidate] >= 0) {
            ofKind[rules.kind[candidate]]--;
        }
    }

    /** Whether a candidate may be added, and what is missing of some kinds may be added after it. */
    boolean fits(int candidate) {
        int place = rules.place[candidate];
        int kind = rules.kind[candidate];
        boolean isMissing = kind >= 0 && ofKind[kind] < rules.kindAtLeast[kind];
        return count < rules.atMost
                && cost + rules.cost[candidate] <= rules.budget
                && (place < 0 || !isTaken[place])
                && (kind < 0 || ofKind[kind] < rules.kindAtMost[kind])
                && (isMissing || missing() < rules.atMost - count);
    }

    /** How many candidates are missing of the kinds of which some must be chosen. */
    int missing() {
        int missing = 0;
        for (int kind = 0; kind < ofKind.length; kind++) {
            missing += Math.max(0, rules.kindAtLeast[kind] - ofKind[kind]);
        }
        return missing;
    }

    /** Whether what is chosen so far breaks a rule, though more may still be added. */
    boolean isBroken(int[] chosen) {
        clear();
        for (int candidate : chosen) {
            int place = rules.place[candidate];
            if (place >= 0 && isTaken[place]) {
                return true;
            }
            add(candidate);
        }
        for (int kind = 0; kind < ofKind.length; kind++) {
            if (ofKind[kind] > rules.kindAtMost[kind]) {
                return true;
            }
        }
        return cost > rules.budget || count > rules.atMost || missing() > rules.atMost - count;
    }

    boolean isTaken(int place) {
        return isTaken[place];
    }

    int ofKind(int kind) {
        return ofKind[kind];
    }

    double cost() {
        return cost;
    }

    int count() {
        return count;
    }
}
