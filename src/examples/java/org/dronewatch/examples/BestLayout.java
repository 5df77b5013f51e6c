package org.dronewatch.examples;

import java.nio.file.Path;
import java.util.List;
import org.dronewatch.placement.CandidateTable;
import org.dronewatch.placement.CandidateTableReader;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementObjective;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.solver.ExactSolver;

/**
 * The layout with the smallest mean impact that a budget allows.
 *
 * @param names names of the chosen candidates
 * @param result the proven optimum
 */
public record BestLayout(List<String> names, PlacementResult result) {
    /**
     * Chooses among the candidates of two CSV files.
     *
     * @param candidates the candidates with their costs
     * @param values the impact in each row for each candidate, such as the time of detection
     * @param budget greatest sum of costs
     */
    public static BestLayout of(Path candidates, Path values, double budget) {
        CandidateTable table = CandidateTableReader.read(candidates, values);
        PlacementConditions conditions = PlacementConditions.NONE.withBudget(budget);
        PlacementProblem problem = new PlacementProblem(table, PlacementObjective.MEAN_IMPACT, conditions);
        PlacementResult best =
                new ExactSolver().solve(problem, SolverLimits.NONE).orElseThrow();
        List<String> names = best.chosen().stream()
                .map(candidate -> table.candidates().get(candidate).name())
                .toList();
        return new BestLayout(names, best);
    }

    public static void main(String[] args) {
        BestLayout best = of(Path.of("candidates.csv"), Path.of("values.csv"), 1000.0);
        System.out.println(best.names() + ": impact " + best.result().value() + ", cost "
                + best.result().cost());
    }
}
