package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.layer.LayerStore;
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
import org.dronewatch.placement.plan.WarningMeasure;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;

/**
 * Finds the layout of a plan that gives the longest warning time for drones that fly straight to the protected zone.
 */
public final class WarningSearch {
    private final PlacePlan plan;
    private final ConditionedFlights flights;
    private final PlacementSolver solver;
    private final boolean isWorst;

    /**
     * A search.
     *
     * @param stage stage of the plan's scene
     * @param store store of earlier assessments
     * @throws InputException when the scene has no protected zone
     */
    public WarningSearch(PlacePlan plan, Stage stage, LayerStore store, PlacementSolver solver) {
        this.plan = plan;
        this.solver = solver;
        this.flights = new ConditionedFlights(plan, stage, store);
        this.isWorst = plan.settings().warning() == WarningMeasure.WORST;
    }

    /** The approximate number of cells at which sensors have to be assessed. */
    public long looks() {
        return looks(plan.candidates().size() + plan.present().enabledSensors().size());
    }

    /**
     * The best layout that this search finds.
     *
     * @param progress receives the number of cells that were assessed since the last call
     * @param assessed called when the assessment of the candidates ends, possibly because this thread was interrupted;
     *     it should then clear the interrupt status
     * @throws InputException when no layout complies with the conditions
     * @throws CancellationException when this thread is interrupted before any candidate is assessed, or before the
     *     assessed candidates allow a layout that complies with the conditions
     */
    public WarningPlacement found(SolverLimits limits, IntConsumer progress, Runnable assessed) {
        List<List<InboundWarnings>> warnings = new ArrayList<>();
        boolean isWhole = assess(warnings, progress);
        Map<String, SensorSettings<?>> own = plan.present().enabledSensors();
        Optional<List<List<InboundWarnings>>> present =
                isWhole && !own.isEmpty() ? each(own, progress) : Optional.empty();
        assessed.run();
        double longest = ConditionedFlights.longest(warnings.get(0));
        List<Candidate> candidates =
                plan.candidates().stream().map(SiteCandidate::candidate).toList();
        PlacementProblem problem = problem(candidates, warnings, longest, conditions(longest));
        PlacementResult result = solver.solve(problem, limits)
                .orElseThrow(() -> isWhole ? limits.none(this::impossible) : new CancellationException());
        double bound = isWhole ? result.bound() : isWorst ? 0.0 : longest;
        boolean isComplete = isWhole && result.complete() && (present.isPresent() || own.isEmpty());
        return new WarningPlacement(
                plan,
                flights.grid(),
                longest,
                problem,
                new PlacementResult(result.chosen(), result.value(), bound, result.cost(), isComplete),
                warnings.size(),
                present.map(all -> present(List.copyOf(own.keySet()), all, longest)),
                isComplete);
    }

    /** The approximate number of cells at which a given number of sensors has to be assessed. */
    public long looks(int sensors) {
        return flights.looks() * sensors;
    }

    /**
     * The warning times of a layout, to be compared with those of the scene's own sensors.
     *
     * @param progress receives the number of cells that were assessed since the last call
     * @return empty if the layout has no sensor, or this thread is interrupted; it then stays interrupted
     */
    public Optional<LayoutWarnings> compared(WarningPlacement placement, IntConsumer progress) {
        return LayoutWarnings.of(placement, flights.asItIs(), progress);
    }

    /** Assesses each candidate by itself; returns false if it was interrupted after the first one. */
    private boolean assess(List<List<InboundWarnings>> warnings, IntConsumer progress) {
        try {
            plan.candidates().forEach(one -> warnings.add(flights.of(Map.of(one.name(), one.sensor()), progress)));
            return true;
        } catch (CancellationException e) {
            if (warnings.isEmpty()) {
                throw e;
            }
            return false;
        }
    }

    private Optional<List<List<InboundWarnings>>> each(Map<String, SensorSettings<?>> sensors, IntConsumer progress) {
        List<List<InboundWarnings>> warnings = new ArrayList<>();
        try {
            sensors.forEach((name, sensor) -> warnings.add(flights.of(Map.of(name, sensor), progress)));
            return Optional.of(warnings);
        } catch (CancellationException e) {
            return Optional.empty();
        }
    }

    /** The value of the scene's own sensors, on the same terms. */
    private PresentLayout present(List<String> names, List<List<InboundWarnings>> warnings, double longest) {
        List<Candidate> own =
                names.stream().map(name -> new Candidate(name, 0.0)).toList();
        PlacementConditions conditions =
                PlacementConditions.NONE.withFold(plan.settings().conditions().fold());
        double value = problem(own, warnings, longest, conditions)
                .value(IntStream.range(0, own.size()).boxed().toList());
        return new PresentLayout(own.size(), isWorst ? longest - value : value);
    }

    private PlacementProblem problem(
            List<Candidate> candidates,
            List<List<InboundWarnings>> warnings,
            double longest,
            PlacementConditions conditions) {
        List<CandidateColumn> columns = new ArrayList<>();
        for (int candidate = 0; candidate < candidates.size(); candidate++) {
            columns.add(
                    candidate < warnings.size()
                            ? ConditionedFlights.column(
                                    warnings.get(candidate),
                                    isWorst ? OptionalDouble.of(longest) : OptionalDouble.empty())
                            : new CandidateColumn(new int[0], new double[0]));
        }
        double[] weights = new double[flights.size()];
        Arrays.fill(weights, 1.0 / flights.asItIs().size());
        double[] undetected = new double[weights.length];
        Arrays.fill(undetected, longest);
        CandidateTable table = new CandidateTable(candidates, columns, weights, undetected);
        boolean isGrouped = !isWorst && !plan.conditions().isEmpty();
        return new PlacementProblem(
                isGrouped ? table.withGroups(flights.conditions()) : table, objective(), conditions);
    }

    /** The worst condition counts; the worst of all flights is also that under the worst condition. */
    private PlacementObjective objective() {
        if (isWorst) {
            return PlacementObjective.WORST_IMPACT;
        }
        return plan.conditions().isEmpty()
                ? PlacementObjective.COVERED_WEIGHT
                : PlacementObjective.LEAST_COVERED_WEIGHT;
    }

    private PlacementConditions conditions(double longest) {
        PlacementConditions conditions = PlanConditions.of(plan);
        return plan.settings()
                .conditions()
                .anyoneLost()
                .map(loss -> conditions.withAnyoneLost(isWorst ? longest - loss.seconds() : loss.seconds()))
                .orElse(conditions);
    }

    private InputException impossible() {
        return PlanConditions.impossible(
                plan,
                plan.settings()
                        .conditions()
                        .anyoneLost()
                        .map(loss -> "a warning of " + Quantity.DURATION.inWords(loss.seconds())));
    }
}
