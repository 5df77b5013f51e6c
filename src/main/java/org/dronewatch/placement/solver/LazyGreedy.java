package org.dronewatch.placement.solver;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.PriorityQueue;
import org.dronewatch.placement.solver.Gains.Form;

/**
 * Chooses what adds most, repeatedly. Where a candidate adds less the more are already chosen (submodularity), a gain
 * that was computed earlier is an upper bound, so that gains are computed again only for candidates at the head of a
 * queue: M. Minoux, Accelerated greedy algorithms (1978). With a limit on the number alone, the choice has at least 1 -
 * 1/e = 63 % of the best gain: G. L. Nemhauser, L. A. Wolsey and M. L. Fisher, Mathematical Programming 14 (1978).
 * Under a budget, the better of two such choices, by gain and by gain per cost, has at least (1 - 1/e) / 2: J. Leskovec
 * et al., Cost-effective outbreak detection in networks, KDD 2007. With kinds, exclusive places and fixed candidates
 * there is no such guarantee.
 */
final class LazyGreedy {
    private final Gains gains;
    private final Rules rules;
    private final boolean byCost;

    /** By row: the best gain so far, or the sum of gains. */
    private final double[] reached;

    LazyGreedy(Gains gains, Rules rules, boolean byCost) {
        this.gains = gains;
        this.rules = rules;
        this.byCost = byCost;
        this.reached = new double[gains.rowCount()];
    }

    private record Entry(int candidate, double rank, int round) {}

    /** The start, with candidates added until none fits or adds anything. */
    int[] extended(int[] start) {
        Arrays.fill(reached, 0.0);
        Tally tally = new Tally(rules);
        boolean[] isChosen = new boolean[rules.size];
        int[] chosen = Arrays.copyOf(start, rules.size);
        int count = start.length;
        for (int candidate : start) {
            choose(candidate, tally, isChosen);
        }
        PriorityQueue<Entry> queue = queue(isChosen);
        List<Entry> waiting = new ArrayList<>();
        while (!queue.isEmpty()) {
            Entry head = queue.poll();
            if (!tally.fits(head.candidate)) {
                continue;
            }
            if (!rules.isServed(head.candidate, other -> isChosen[other])) {
                waiting.add(head);
                continue;
            }
            if (head.round < count) {
                double rank = rank(head.candidate);
                if (rank > 0.0 || tally.missing() > 0) {
                    queue.add(new Entry(head.candidate, rank, count));
                }
                continue;
            }
            choose(head.candidate, tally, isChosen);
            chosen[count++] = head.candidate;
            // What waits for one of several others may have got it.
            queue.addAll(waiting);
            waiting.clear();
        }
        return Arrays.copyOf(chosen, count);
    }

    private PriorityQueue<Entry> queue(boolean[] isChosen) {
        PriorityQueue<Entry> queue = new PriorityQueue<>((one, other) -> one.rank != other.rank
                ? Double.compare(other.rank, one.rank)
                : Integer.compare(one.candidate, other.candidate));
        for (int candidate = 0; candidate < rules.size; candidate++) {
            if (!isChosen[candidate]) {
                queue.add(new Entry(candidate, Double.POSITIVE_INFINITY, -1));
            }
        }
        return queue;
    }

    private void choose(int candidate, Tally tally, boolean[] isChosen) {
        tally.add(candidate);
        isChosen[candidate] = true;
        int[] rows = gains.rows[candidate];
        double[] values = gains.gains[candidate];
        for (int at = 0; at < rows.length; at++) {
            reached[rows[at]] = gains.form == Form.BEST_SUM
                    ? Math.max(reached[rows[at]], values[at])
                    : reached[rows[at]] + values[at];
        }
    }

    private double rank(int candidate) {
        double gain = added(candidate);
        double cost = rules.cost[candidate];
        return !byCost ? gain : cost > 0.0 ? gain / cost : gain > 0.0 ? Double.MAX_VALUE : 0.0;
    }

    private double added(int candidate) {
        int[] rows = gains.rows[candidate];
        double[] values = gains.gains[candidate];
        double sum = 0.0;
        for (int at = 0; at < rows.length; at++) {
            double before = reached[rows[at]];
            sum += gains.form == Form.BEST_SUM
                    ? Math.max(0.0, values[at] - before)
                    : -gains.weight[rows[at]] * Math.exp(-before) * Math.expm1(-values[at]);
        }
        return sum;
    }
}
