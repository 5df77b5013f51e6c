package org.dronewatch.placement.solver;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.CandidateTable;
import org.dronewatch.placement.KindLimits;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementObjective;
import org.dronewatch.placement.PlacementProblem;

/** All choices of a small problem, valued straight from the definitions, with nothing shared with the solver. */
final class BruteForce {
    private final PlacementProblem problem;
    private final double[][] matrix;

    BruteForce(PlacementProblem problem) {
        this.problem = problem;
        CandidateTable table = problem.table();
        matrix = new double[table.rows()][table.size()];
        for (double[] row : matrix) {
            Arrays.fill(row, Double.NaN);
        }
        for (int candidate = 0; candidate < table.size(); candidate++) {
            CandidateColumn column = table.column(candidate);
            for (int at = 0; at < column.size(); at++) {
                matrix[column.row(at)][candidate] = column.value(at);
            }
        }
    }

    /** The best value of all choices that comply; not a number if none does. */
    double best() {
        double best = Double.NaN;
        for (int choice = 0; choice < 1 << problem.table().size(); choice++) {
            if (complies(choice)) {
                double value = value(choice);
                boolean isBetter = problem.objective().isGreatest() ? value > best : value < best;
                best = Double.isNaN(best) || isBetter ? value : best;
            }
        }
        return best;
    }

    boolean complies(int choice) {
        PlacementConditions conditions = problem.conditions();
        double cost = 0.0;
        Map<String, Integer> kinds = new HashMap<>();
        Map<String, Integer> places = new HashMap<>();
        for (int candidate = 0; candidate < problem.table().size(); candidate++) {
            Candidate one = problem.table().candidates().get(candidate);
            if ((choice >> candidate & 1) == 1) {
                cost += one.cost();
                kinds.merge(one.kind(), 1, Integer::sum);
                if (!one.exclusive().isEmpty()) {
                    places.merge(one.exclusive(), 1, Integer::sum);
                }
            } else if (one.fixed()) {
                return false;
            }
        }
        for (Map.Entry<String, KindLimits> limits : conditions.kinds().entrySet()) {
            int count = kinds.getOrDefault(limits.getKey(), 0);
            if (count < limits.getValue().atLeast() || count > limits.getValue().atMost()) {
                return false;
            }
        }
        return Integer.bitCount(choice) <= conditions.atMost()
                && cost <= conditions.budget()
                && places.values().stream().allMatch(count -> count == 1)
                && IntStream.range(0, problem.table().size())
                        .filter(candidate -> (choice >> candidate & 1) == 1)
                        .filter(candidate ->
                                !problem.table().candidates().get(candidate).fixed())
                        .allMatch(candidate -> isServed(choice, candidate))
                && survives(choice);
    }

    private boolean isServed(int choice, int candidate) {
        Set<String> needs = problem.conditions()
                .needsOneOf()
                .get(problem.table().candidates().get(candidate).name());
        return needs == null
                || IntStream.range(0, problem.table().size())
                        .filter(other -> (choice >> other & 1) == 1)
                        .anyMatch(other -> needs.contains(
                                problem.table().candidates().get(other).name()));
    }

    /** Those that had one that they need stop when the last of these has gone. */
    private int after(int choice, int lost) {
        int left = choice & ~(1 << lost);
        for (int round = 0; round < problem.table().size(); round++) {
            int before = left;
            for (int candidate = 0; candidate < problem.table().size(); candidate++) {
                if (isServed(choice, candidate) && !isServed(before, candidate)) {
                    left &= ~(1 << candidate);
                }
            }
        }
        return left;
    }

    private boolean survives(int choice) {
        if (problem.conditions().anyoneLost().isEmpty()) {
            return true;
        }
        double needed = problem.conditions().anyoneLost().getAsDouble();
        boolean survives = choice != 0 || isEnough(value(0), needed);
        for (int lost = 0; lost < problem.table().size(); lost++) {
            survives &= (choice >> lost & 1) == 0 || isEnough(value(after(choice, lost)), needed);
        }
        return survives;
    }

    private boolean isEnough(double value, double needed) {
        return problem.objective().isGreatest() ? value >= needed - 1e-9 : value <= needed + 1e-9;
    }

    double value(int choice) {
        double sum = 0.0;
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        double[] groups = new double[problem.table().groups()];
        for (int row = 0; row < matrix.length; row++) {
            double value = inRow(row, choice);
            sum += problem.table().weight(row) * value;
            groups[problem.table().group(row)] += problem.table().weight(row) * value;
            least = Math.min(least, value);
            greatest = Math.max(greatest, value);
        }
        return switch (problem.objective()) {
            case WORST_IMPACT -> greatest;
            case WEAKEST_ROW -> least;
            case LEAST_COVERED_WEIGHT -> Arrays.stream(groups).min().orElseThrow();
            default -> sum;
        };
    }

    private double inRow(int row, int choice) {
        List<Double> values = new ArrayList<>();
        double sum = 0.0;
        double missed = 1.0;
        for (int candidate = 0; candidate < matrix[row].length; candidate++) {
            double value = matrix[row][candidate];
            if ((choice >> candidate & 1) == 1 && !Double.isNaN(value)) {
                values.add(value);
                sum += value;
                missed *= 1.0 - value;
            }
        }
        values.sort(null);
        int fold = problem.conditions().fold();
        PlacementObjective objective = problem.objective();
        return switch (objective) {
            case WEAKEST_ROW -> sum;
            case JOINT_PROBABILITY -> 1.0 - missed;
            case COVERED_WEIGHT, LEAST_COVERED_WEIGHT -> values.size() < fold ? 0.0 : values.get(values.size() - fold);
            default ->
                Math.min(
                        problem.table().undetected(row),
                        values.size() < fold ? Double.POSITIVE_INFINITY : values.get(fold - 1));
        };
    }
}
