package org.dronewatch.placement.solver;

import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;

/**
 * Finds a choice that satisfies demands, or shows that there is none: it branches on the candidates of the demand that
 * leaves the fewest possibilities, and gives up a part of the search where even the candidates that serve most demands
 * are too few. Not thread-safe.
 */
final class CoverSearch {
    private final Rules rules;
    private final UnaryOperator<int[]> mending;
    private final BooleanSupplier isStopped;
    private final List<Demand> demands;
    private final Tally tally;
    private final byte[] state;

    /** By demand: how many are still needed, and how many candidates are left for it. */
    private final int[] need;

    private final int[] left;

    /** By candidate: the demands that it serves. */
    private final int[][] served;

    /**
     * A search.
     *
     * @param mending the candidates of which at least one must be added to a choice that satisfies all demands, for it
     *     to comply; null if it complies
     */
    CoverSearch(Rules rules, List<Demand> demands, UnaryOperator<int[]> mending, BooleanSupplier isStopped) {
        this.rules = rules;
        this.mending = mending;
        this.demands = List.copyOf(demands);
        this.isStopped = isStopped;
        tally = new Tally(rules);
        state = new byte[rules.size];
        need = demands.stream().mapToInt(Demand::need).toArray();
        left = demands.stream().mapToInt(demand -> demand.candidates().length).toArray();
        IntStream.Builder[] serving = new IntStream.Builder[rules.size];
        for (int candidate = 0; candidate < serving.length; candidate++) {
            serving[candidate] = IntStream.builder();
        }
        for (int number = 0; number < demands.size(); number++) {
            for (int candidate : demands.get(number).candidates()) {
                serving[candidate].add(number);
            }
        }
        served = new int[rules.size][];
        for (int candidate = 0; candidate < served.length; candidate++) {
            served[candidate] = serving[candidate].build().toArray();
        }
    }

    /** A choice; null if there is none, or the search was stopped. */
    int[] find() {
        if (tally.isBroken(rules.fixed)) {
            return null;
        }
        tally.clear();
        for (int candidate : rules.fixed) {
            choose(candidate);
        }
        return search() ? SearchNode.having(state, SearchNode.IN, SearchNode.IN) : null;
    }

    private boolean search() {
        int hardest = hardest();
        if (hardest < 0) {
            return completed();
        }
        if (isStopped.getAsBoolean() || left[hardest] < need[hardest] || isTooMuch()) {
            return false;
        }
        int[] tried = byUse(demands.get(hardest).candidates());
        int count = 0;
        boolean isFound = false;
        while (count < tried.length && !isFound && left[hardest] >= need[hardest]) {
            int candidate = tried[count];
            if (tally.fits(candidate)) {
                choose(candidate);
                isFound = search();
                if (!isFound) {
                    takeBack(candidate);
                }
            }
            if (!isFound) {
                forbid(candidate);
                count++;
            }
        }
        for (int at = 0; at < count && !isFound; at++) {
            allow(tried[at]);
        }
        return isFound;
    }

    /** Whether the choice that satisfies all demands complies, if necessary with further candidates. */
    private boolean completed() {
        int[] added = missing(SearchNode.having(state, SearchNode.IN, SearchNode.IN));
        if (added == null) {
            return true;
        }
        for (int candidate : added) {
            if (state[candidate] == SearchNode.FREE && tally.fits(candidate) && !isStopped.getAsBoolean()) {
                choose(candidate);
                if (completed()) {
                    return true;
                }
                takeBack(candidate);
            }
        }
        return false;
    }

    /** Those of which a choice lacks one; null if it lacks none. */
    private int[] missing(int[] chosen) {
        int lacking = IntStream.of(chosen)
                .filter(candidate ->
                        !rules.isFixed(candidate) && !rules.isServed(candidate, other -> state[other] == SearchNode.IN))
                .findFirst()
                .orElse(-1);
        return lacking < 0 ? mending.apply(chosen) : rules.needs[lacking];
    }

    /** The demand that leaves the fewest possibilities; -1 if all are satisfied. */
    private int hardest() {
        int hardest = -1;
        for (int demand = 0; demand < need.length; demand++) {
            if (need[demand] > 0 && (hardest < 0 || left[demand] - need[demand] < left[hardest] - need[hardest])) {
                hardest = demand;
            }
        }
        return hardest;
    }

    /** Whether the candidates that serve most demands, as many as may be added, serve too few. */
    private boolean isTooMuch() {
        int needed = 0;
        int most = 0;
        for (int one : need) {
            needed += Math.max(0, one);
            most = Math.max(most, one);
        }
        int[] counts = new int[need.length + 1];
        for (int candidate = 0; candidate < state.length; candidate++) {
            if (state[candidate] == SearchNode.FREE && tally.fits(candidate)) {
                counts[use(candidate)]++;
            }
        }
        int room = Math.min(rules.size, rules.atMost) - tally.count();
        for (int use = need.length; use > 0 && room > 0; use--) {
            int taken = Math.min(room, counts[use]);
            needed -= taken * use;
            room -= taken;
        }
        return needed > 0;
    }

    /** How many unsatisfied demands a candidate serves. */
    private int use(int candidate) {
        int use = 0;
        for (int demand : served[candidate]) {
            use += need[demand] > 0 ? 1 : 0;
        }
        return use;
    }

    private int[] byUse(int[] candidates) {
        return IntStream.of(candidates)
                .filter(candidate -> state[candidate] == SearchNode.FREE)
                .boxed()
                .sorted((one, other) -> Integer.compare(use(other), use(one)))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    private void choose(int candidate) {
        state[candidate] = SearchNode.IN;
        tally.add(candidate);
        change(candidate, -1, -1);
    }

    private void takeBack(int candidate) {
        state[candidate] = SearchNode.FREE;
        tally.remove(candidate);
        change(candidate, 1, 1);
    }

    private void forbid(int candidate) {
        state[candidate] = SearchNode.OUT;
        change(candidate, 0, -1);
    }

    private void allow(int candidate) {
        state[candidate] = SearchNode.FREE;
        change(candidate, 0, 1);
    }

    private void change(int candidate, int ofNeed, int ofLeft) {
        for (int demand : served[candidate]) {
            need[demand] += ofNeed;
            left[demand] += ofLeft;
        }
    }
}
