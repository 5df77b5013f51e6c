package org.dronewatch.placement;

import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Candidates, an objective, and conditions. A layout is given as a list of the indices of the chosen candidates in the
 * table. Immutable; thread-safe.
 */
public final class PlacementProblem {
    /** The value at which probabilities are capped. */
    public static final double CERTAIN = 1.0 - 1e-6;

    /** Sums of costs may exceed the budget by this fraction, to allow for rounding. */
    public static final double ROUNDING = 1e-12;

    private final CandidateTable table;
    private final PlacementObjective objective;
    private final PlacementConditions conditions;
    private final double[] undetected;
    private final CandidateLosses losses;

    /**
     * A problem.
     *
     * @throws IllegalArgumentException when the {@linkplain PlacementConditions#fold fold} is above 1 although the
     *     objective does not {@linkplain PlacementObjective#takesBest take the best value}, when a probability is above
     *     1, or when the objective is an impact and a row states neither an impact for every candidate nor one for the
     *     case that no candidate detects anything
     */
    public PlacementProblem(CandidateTable table, PlacementObjective objective, PlacementConditions conditions) {
        if (conditions.fold() > 1 && !objective.takesBest()) {
            throw new IllegalArgumentException("fold " + conditions.fold() + ": must be 1 for " + objective);
        }
        this.table = table;
        this.objective = objective;
        this.conditions = conditions;
        this.losses = new CandidateLosses(
                table.candidates().stream().map(Candidate::name).toList(), conditions);
        this.undetected = objective.isImpact() ? impactsWithout() : new double[table.rows()];
        if (objective == PlacementObjective.JOINT_PROBABILITY) {
            checkProbabilities();
        }
    }

    private double[] impactsWithout() {
        double[] worst = new double[table.rows()];
        int[] counts = new int[table.rows()];
        for (int candidate = 0; candidate < table.size(); candidate++) {
            CandidateColumn column = table.column(candidate);
            for (int at = 0; at < column.size(); at++) {
                worst[column.row(at)] = Math.max(worst[column.row(at)], column.value(at));
                counts[column.row(at)]++;
            }
        }
        for (int row = 0; row < worst.length; row++) {
            if (!Double.isNaN(table.undetected(row))) {
                worst[row] = table.undetected(row);
            } else if (counts[row] < table.size()) {
                throw new IllegalArgumentException("row " + row + ": impacts for " + counts[row] + " of " + table.size()
                        + " candidates only, and the impact without a detection is missing");
            }
        }
        return worst;
    }

    private void checkProbabilities() {
        for (int candidate = 0; candidate < table.size(); candidate++) {
            CandidateColumn column = table.column(candidate);
            for (int at = 0; at < column.size(); at++) {
                if (column.value(at) > 1.0) {
                    throw new IllegalArgumentException("probability " + column.value(at) + " of candidate "
                            + table.candidates().get(candidate).name() + ": must be at most 1");
                }
            }
        }
    }

    /** Candidates and what they contribute. */
    public CandidateTable table() {
        return table;
    }

    /** The objective. */
    public PlacementObjective objective() {
        return objective;
    }

    /** What a layout must comply with. */
    public PlacementConditions conditions() {
        return conditions;
    }

    /**
     * The impact in a row in which too few candidates detect anything: the one stated in the table or, if there is
     * none, the greatest impact of any candidate in that row; 0 if the objective has no impacts.
     */
    public double undetected(int row) {
        return undetected[row];
    }

    /** The sum of the costs of some candidates. */
    public double cost(List<Integer> chosen) {
        return chosen.stream()
                .mapToDouble(candidate -> table.candidates().get(candidate).cost())
                .sum();
    }

    /** Whether a layout complies with every condition. */
    public boolean isAllowed(List<Integer> chosen) {
        return chosen.size() <= conditions.atMost()
                && cost(chosen) <= conditions.budget() * (1.0 + ROUNDING)
                && hasFixed(chosen)
                && hasOneAtPlace(chosen)
                && hasKinds(chosen)
                && lacking(chosen).isEmpty()
                && survivesLoss(chosen);
    }

    private boolean hasFixed(List<Integer> chosen) {
        for (int candidate = 0; candidate < table.size(); candidate++) {
            if (table.candidates().get(candidate).fixed() && !chosen.contains(candidate)) {
                return false;
            }
        }
        return true;
    }

    private boolean hasOneAtPlace(List<Integer> chosen) {
        Set<String> taken = new HashSet<>();
        return chosen.stream()
                .map(candidate -> table.candidates().get(candidate).exclusive())
                .allMatch(place -> place.isEmpty() || taken.add(place));
    }

    private boolean hasKinds(List<Integer> chosen) {
        Map<String, Integer> counts = new HashMap<>();
        chosen.forEach(
                candidate -> counts.merge(table.candidates().get(candidate).kind(), 1, Integer::sum));
        return conditions.kinds().entrySet().stream().allMatch(limits -> {
            int count = counts.getOrDefault(limits.getKey(), 0);
            return count >= limits.getValue().atLeast()
                    && count <= limits.getValue().atMost();
        });
    }

    /**
     * The names of the chosen candidates, except fixed ones, that need at least one of certain others, none of which is
     * chosen.
     */
    public List<String> lacking(List<Integer> chosen) {
        List<String> names = chosen.stream()
                .map(candidate -> table.candidates().get(candidate).name())
                .toList();
        return chosen.stream()
                .map(table.candidates()::get)
                .filter(one -> !one.fixed())
                .map(Candidate::name)
                .filter(name -> conditions.needsOneOf().containsKey(name)
                        && Collections.disjoint(conditions.needsOneOf().get(name), names))
                .toList();
    }

    /** What determines which part of a layout still works after a loss. */
    public CandidateLosses losses() {
        return losses;
    }

    /** Whether enough remains after the worst loss of a single chosen candidate, if that is a condition. */
    public boolean survivesLoss(List<Integer> chosen) {
        if (conditions.anyoneLost().isEmpty()) {
            return true;
        }
        double needed = conditions.anyoneLost().getAsDouble();
        double remaining = valueAfterWorstLoss(chosen);
        double tolerance = 1e-9 * Math.max(1.0, Math.abs(needed));
        return objective.isGreatest() ? remaining >= needed - tolerance : remaining <= needed + tolerance;
    }

    /**
     * The value that remains after the loss of the chosen candidate whose loss is worst, according to
     * {@link CandidateLosses}; the value of an empty layout if none is chosen.
     */
    public double valueAfterWorstLoss(List<Integer> chosen) {
        double worst = chosen.isEmpty() ? value(chosen) : Double.NaN;
        for (Integer lost : chosen) {
            double value = value(losses.remaining(chosen, lost));
            boolean isWorse = objective.isGreatest() ? value < worst : value > worst;
            worst = Double.isNaN(worst) || isWorse ? value : worst;
        }
        return worst;
    }

    /** For a layout, the sum of weight times value over each group of rows. */
    public double[] sums(List<Integer> chosen) {
        return new LayoutValue(this, chosen).sums();
    }

    /** The value of the objective for a layout, whether it is allowed or not. */
    public double value(List<Integer> chosen) {
        return new LayoutValue(this, chosen).value();
    }
}
