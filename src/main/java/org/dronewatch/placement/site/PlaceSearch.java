package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.CandidateTable;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementObjective;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.PlacementSolver;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.PlanConditions;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;

/**
 * Finds the best layout of a plan: what each candidate covers is assessed once, and then the best candidates are
 * chosen.
 */
public final class PlaceSearch {
    private final PlacePlan plan;
    private final CoveredCells cells;
    private final PlacementSolver solver;

    /** A search. */
    public PlaceSearch(PlacePlan plan, CoveredCells cells, PlacementSolver solver) {
        this.plan = plan;
        this.cells = cells;
        this.solver = solver;
    }

    /** The coverage that was assessed: of candidates, and of the scene's own sensors. */
    private record Assessed(
            List<CandidateColumn> columns, int assessed, Optional<List<CandidateColumn>> present, boolean isWhole) {}

    /**
     * The best layout that this search finds.
     *
     * @param limits limits on the choice among the candidates
     * @param progress receives the number of cells that were assessed since the last call
     * @param assessed called when the assessment of the candidates ends, possibly because this thread was interrupted;
     *     it should then clear the interrupt status
     * @throws InputException when no layout complies with the conditions
     * @throws CancellationException when this thread is interrupted before any candidate is assessed, or before the
     *     assessed candidates allow a layout that complies with the conditions
     */
    public SitePlacement found(SolverLimits limits, IntConsumer progress, Runnable assessed) {
        Assessed air = assess(progress);
        assessed.run();
        PlacementProblem problem = problem(air.columns());
        PlacementResult result = solver.solve(problem, limits)
                .orElseThrow(() -> air.isWhole() ? limits.none(this::impossible) : new CancellationException());
        // What was not assessed could cover everything.
        double bound = air.isWhole() ? result.bound() : cells.size();
        boolean isComplete = air.isWhole()
                && result.complete()
                && (air.present().isPresent() || plan.present().enabledSensors().isEmpty());
        return new SitePlacement(
                plan,
                cells.grid(),
                cells.headings(),
                cells.size(),
                problem,
                new PlacementResult(result.chosen(), result.value(), bound, result.cost(), isComplete),
                zones(air),
                air.assessed(),
                air.present().map(this::present),
                isComplete);
    }

    private InputException impossible() {
        return PlanConditions.impossible(
                plan,
                plan.settings()
                        .conditions()
                        .anyoneLost()
                        .map(loss -> "a coverage of " + Quantity.NUMBER.inWords(loss.fraction())));
    }

    private Assessed assess(IntConsumer progress) {
        List<CandidateColumn> columns = new ArrayList<>(cells.columns(progress));
        int assessed = columns.size();
        boolean isWhole = assessed == plan.candidates().size();
        while (columns.size() < plan.candidates().size()) {
            columns.add(new CandidateColumn(new int[0]));
        }
        Map<String, SensorSettings<?>> own = plan.present().enabledSensors();
        List<CandidateColumn> present = new ArrayList<>();
        try {
            if (isWhole) {
                own.forEach((name, sensor) -> present.add(cells.column(name, sensor, progress)));
            }
        } catch (CancellationException e) {
            return new Assessed(columns, assessed, Optional.empty(), true);
        }
        return new Assessed(
                columns, assessed, isWhole && !own.isEmpty() ? Optional.of(present) : Optional.empty(), isWhole);
    }

    private PlacementProblem problem(List<CandidateColumn> columns) {
        List<Candidate> candidates =
                plan.candidates().stream().map(SiteCandidate::candidate).toList();
        return new PlacementProblem(table(candidates, columns), objective(), conditions());
    }

    private CandidateTable table(List<Candidate> candidates, List<CandidateColumn> columns) {
        CandidateTable table = new CandidateTable(candidates, columns, cells.weights());
        return plan.conditions().isEmpty() ? table : table.withGroups(cells.conditions());
    }

    /** The worst condition counts; without one, the sum of all rows is the same and quicker to maximise. */
    private PlacementObjective objective() {
        return plan.conditions().isEmpty()
                ? PlacementObjective.COVERED_WEIGHT
                : PlacementObjective.LEAST_COVERED_WEIGHT;
    }

    private PlacementConditions conditions() {
        PlacementConditions conditions = PlanConditions.of(plan);
        return plan.settings()
                .conditions()
                .anyoneLost()
                .map(loss -> conditions.withAnyoneLost(loss.fraction() * cells.size()))
                .orElse(conditions);
    }

    /** The value of the scene's own sensors, on the same terms. */
    private PresentLayout present(List<CandidateColumn> columns) {
        PlacementProblem same = presentProblem(columns);
        return new PresentLayout(columns.size(), SitePlacement.fraction(same.value(all(same)), cells.size()));
    }

    private PlacementProblem presentProblem(List<CandidateColumn> columns) {
        List<Candidate> own = plan.present().enabledSensors().keySet().stream()
                .map(name -> new Candidate(name, 0.0))
                .toList();
        PlacementConditions conditions =
                PlacementConditions.NONE.withFold(plan.settings().conditions().fold());
        return new PlacementProblem(table(own, columns), objective(), conditions);
    }

    private static List<Integer> all(PlacementProblem problem) {
        return IntStream.range(0, problem.table().size()).boxed().toList();
    }

    private List<ZoneRows> zones(Assessed air) {
        Optional<PlacementProblem> present = air.present().map(this::presentProblem);
        return cells.zones().stream()
                .map(zone -> present.map(own -> zone.withPresent(own, all(own))).orElse(zone))
                .toList();
    }
}
