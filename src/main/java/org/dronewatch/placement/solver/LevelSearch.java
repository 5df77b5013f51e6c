package org.dronewatch.placement.solver;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * Proves which choice is best for the least of the rows' best gains, as in the p-centre problem: bisects the levels
 * that this least gain can have, and for each level searches for a choice that reaches it in every row: E. Minieka,
 * SIAM Review 12 (1970).
 */
final class LevelSearch {
    private final Gains gains;
    private final Incumbent incumbent;
    private final Cutoff cutoff;
    private final OptionalDouble needed;
    private final Start start;
    private final BooleanSupplier isStopped;
    private final int[][] rowCandidates;
    private final double[][] rowGains;

    LevelSearch(
            Gains gains,
            Incumbent incumbent,
            Cutoff cutoff,
            OptionalDouble needed,
            Start start,
            BooleanSupplier isStopped) {
        this.start = start;
        this.gains = gains;
        this.incumbent = incumbent;
        this.cutoff = cutoff;
        this.needed = needed;
        this.isStopped = isStopped;
        rowCandidates = new int[gains.rowCount()][];
        rowGains = new double[gains.rowCount()][];
        transpose();
    }

    private void transpose() {
        int[] counts = new int[gains.rowCount()];
        for (int[] rows : gains.rows) {
            for (int row : rows) {
                counts[row]++;
            }
        }
        for (int row = 0; row < counts.length; row++) {
            rowCandidates[row] = new int[counts[row]];
            rowGains[row] = new double[counts[row]];
        }
        Arrays.fill(counts, 0);
        for (int candidate = 0; candidate < gains.candidates(); candidate++) {
            for (int at = 0; at < gains.rows[candidate].length; at++) {
                int row = gains.rows[candidate][at];
                rowCandidates[row][counts[row]] = candidate;
                rowGains[row][counts[row]++] = gains.gains[candidate][at];
            }
        }
    }

    /**
     * Searches; returns the greatest level that had not been refuted when the search was stopped, or that of the choice
     * found.
     */
    double search() {
        start.found();
        double[] levels = levels();
        int low = -1;
        int high = levels.length - 1;
        while (low < high) {
            while (low < high && incumbent.isFound() && levels[low + 1] <= incumbent.value()) {
                low++;
            }
            if (low == high || cutoff.isHopeless(levels[high])) {
                break;
            }
            int middle = low + (high - low + 1) / 2;
            int[] chosen = new CoverSearch(incumbent.rules(), demands(levels[middle]), this::mending, isStopped).find();
            if (chosen != null) {
                incumbent.offer(chosen);
                low = middle;
            } else if (isStopped.getAsBoolean()) {
                return levels[high];
            } else {
                high = middle - 1;
            }
        }
        return Double.NEGATIVE_INFINITY;
    }

    /** All gains that a choice can have, ascending: none above that of choosing all. */
    private double[] levels() {
        double most = new Valuation(gains)
                .value(IntStream.range(0, gains.candidates()).toArray());
        return IntStream.concat(IntStream.of(-1), IntStream.range(0, gains.candidates()))
                .mapToObj(candidate -> candidate < 0 ? gains.floor : gains.gains[candidate])
                .flatMapToDouble(Arrays::stream)
                .filter(level -> level <= most)
                .sorted()
                .distinct()
                .toArray();
    }

    private List<Demand> demands(double level) {
        List<Demand> demands = new ArrayList<>();
        for (int row = 0; row < gains.rowCount(); row++) {
            if (gains.floor[row] < level) {
                demands.add(new Demand(reaching(row, level), gains.fold));
            }
            if (needed.isPresent() && gains.floor[row] < needed.getAsDouble()) {
                demands.add(new Demand(reaching(row, needed.getAsDouble()), gains.fold + 1));
            }
        }
        Rules rules = incumbent.rules();
        for (int kind = 0; kind < rules.kinds(); kind++) {
            int which = kind;
            if (rules.kindAtLeast[kind] > 0) {
                int[] ofKind = IntStream.range(0, rules.size)
                        .filter(candidate -> rules.kind[candidate] == which)
                        .toArray();
                demands.add(new Demand(ofKind, rules.kindAtLeast[kind]));
            }
        }
        return demands;
    }

    /**
     * If too few candidates of a choice reach what must remain of a row after a loss that also stops other candidates:
     * the candidates that reach it, and those that the stopped ones need; null if enough reach it.
     */
    private int[] mending(int[] chosen) {
        Rules rules = incumbent.rules();
        for (int lost : needed.isPresent() ? chosen : new int[0]) {
            if (rules.stopsOthers(chosen, lost)) {
                int[] remaining = rules.remaining(chosen, lost);
                for (int row = 0; row < gains.rowCount(); row++) {
                    int[] reaching = reaching(row, needed.getAsDouble());
                    long enough = IntStream.of(reaching)
                            .filter(candidate -> Rules.contains(remaining, candidate))
                            .count();
                    if (gains.floor[row] < needed.getAsDouble() && enough < gains.fold) {
                        IntStream served = IntStream.of(chosen)
                                .filter(one -> rules.needs[one] != null && !Rules.contains(remaining, one))
                                .flatMap(one -> IntStream.of(rules.needs[one]));
                        return IntStream.concat(IntStream.of(reaching), served)
                                .distinct()
                                .toArray();
                    }
                }
            }
        }
        return null;
    }

    private int[] reaching(int row, double level) {
        return IntStream.range(0, rowGains[row].length)
                .filter(at -> rowGains[row][at] >= level)
                .map(at -> rowCandidates[row][at])
                .toArray();
    }
}
