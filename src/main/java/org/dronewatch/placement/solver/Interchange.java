package org.dronewatch.placement.solver;

import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Swaps a chosen candidate for another as long as the sum of the rows' best gains increases. The best and second best
 * chosen candidate of each row give the effect of all swaps with a new candidate in one pass: R. A. Whitaker, INFOR 21
 * (1983); M. G. C. Resende and R. F. Werneck, A fast swap-based local search procedure for location problems (2007).
 * Not thread-safe.
 */
final class Interchange {
    private static final double ROUNDING = 1e-9;

    private final Gains gains;
    private final Rules rules;
    private final Tally tally;
    private final BooleanSupplier isStopped;
    private final double[] best;
    private final double[] second;

    /** By row: the position of the best in the choice; -1 for none. */
    private final int[] owner;

    /** By position in the choice: what is lost without it, and how much less by a swap with the candidate at hand. */
    private double[] loss;

    private double[] saved;
    private int[] chosen;

    Interchange(Gains gains, Rules rules, BooleanSupplier isStopped) {
        this.gains = gains;
        this.rules = rules;
        this.isStopped = isStopped;
        this.tally = new Tally(rules);
        best = new double[gains.rowCount()];
        second = new double[gains.rowCount()];
        owner = new int[gains.rowCount()];
    }

    /** The choice from which no swap leads to a better one; if the search is stopped, the best so far. */
    int[] swapped(int[] start) {
        chosen = start.clone();
        loss = new double[chosen.length];
        saved = new double[chosen.length];
        boolean isBetter = true;
        while (isBetter && !isStopped.getAsBoolean()) {
            isBetter = swap();
        }
        return chosen.clone();
    }

    /** Makes the best swap, if it increases the sum. */
    private boolean swap() {
        fill();
        boolean[] isChosen = new boolean[rules.size];
        double scale = 1.0;
        for (int candidate : chosen) {
            isChosen[candidate] = true;
        }
        for (double value : best) {
            scale += value;
        }
        double most = ROUNDING * scale;
        int in = -1;
        int out = -1;
        for (int candidate = 0; candidate < rules.size; candidate++) {
            double gained = isChosen[candidate] ? Double.NEGATIVE_INFINITY : gained(candidate);
            for (int at = 0; at < chosen.length && gained > most; at++) {
                double more = gained - loss[at] + saved[at];
                if (more > most && isAllowed(at, candidate)) {
                    most = more;
                    in = candidate;
                    out = at;
                }
            }
        }
        if (in >= 0) {
            chosen[out] = in;
        }
        return in >= 0;
    }

    private void fill() {
        Arrays.fill(best, 0.0);
        Arrays.fill(second, 0.0);
        Arrays.fill(owner, -1);
        Arrays.fill(loss, 0.0);
        for (int at = 0; at < chosen.length; at++) {
            int[] rows = gains.rows[chosen[at]];
            double[] values = gains.gains[chosen[at]];
            for (int k = 0; k < rows.length; k++) {
                int row = rows[k];
                if (values[k] > best[row]) {
                    second[row] = best[row];
                    best[row] = values[k];
                    owner[row] = at;
                } else if (values[k] > second[row]) {
                    second[row] = values[k];
                }
            }
        }
        for (int row = 0; row < best.length; row++) {
            if (owner[row] >= 0) {
                loss[owner[row]] += best[row] - second[row];
            }
        }
    }

    /**
     * What a candidate adds to the choice; afterwards, {@code saved} holds what it saves of the loss of each other
     * candidate.
     */
    private double gained(int candidate) {
        Arrays.fill(saved, 0.0);
        int[] rows = gains.rows[candidate];
        double[] values = gains.gains[candidate];
        double sum = 0.0;
        for (int k = 0; k < rows.length; k++) {
            int row = rows[k];
            sum += Math.max(0.0, values[k] - best[row]);
            if (owner[row] >= 0 && values[k] > second[row]) {
                saved[owner[row]] += Math.min(values[k], best[row]) - second[row];
            }
        }
        return sum;
    }

    private boolean isAllowed(int out, int in) {
        if (Arrays.binarySearch(rules.fixed, chosen[out]) >= 0) {
            return false;
        }
        tally.clear();
        for (int at = 0; at < chosen.length; at++) {
            if (at != out) {
                tally.add(chosen[at]);
            }
        }
        int[] swapped = chosen.clone();
        swapped[out] = in;
        return tally.fits(in) && rules.lacking(swapped) <= rules.lacking(chosen);
    }
}
