package org.dronewatch.placement.site;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.SiteCandidate;

/**
 * The best layout that was found for a plan. Values are fractions of the airspace, that is, of the rows of
 * {@link CoveredCells}, each weighted with the weight of its cell.
 *
 * @param plan what was asked for
 * @param grid the cells
 * @param headings number of headings on which each cell counts
 * @param rows the number of cells times the number of headings
 * @param problem the problem, whose rows have a mean weight of 1; under several conditions, the rows are repeated for
 *     each condition
 * @param result result of the search, whose values are sums of the weights of rows
 * @param zones the protected zones that have a weight, and all other cells; empty if no zone has one
 * @param assessed number of candidates that were assessed, the first ones of the plan
 * @param present the scene's own sensors; empty if it has none, or the search was interrupted before they were assessed
 * @param complete whether every candidate and the scene's own sensors were assessed, and the search ran to completion
 */
public record SitePlacement(
        PlacePlan plan,
        FieldGrid grid,
        int headings,
        int rows,
        PlacementProblem problem,
        PlacementResult result,
        List<ZoneRows> zones,
        int assessed,
        Optional<PresentLayout> present,
        boolean complete)
        implements PlacedLayout {
    private static final double ROUNDING = 1e-9;

    /** This placement with another layout. */
    SitePlacement with(PlacementResult other) {
        return new SitePlacement(
                plan, grid, headings, rows, problem, other, zones, assessed, present, complete && other.complete());
    }

    /** This placement with another bound, in rows; none below the value. */
    SitePlacement within(double bound) {
        return with(new PlacementResult(
                result.chosen(), result.value(), Math.max(result.value(), bound), result.cost(), result.complete()));
    }

    /** What is covered of each zone that has a weight, and of all other cells; empty if no zone has one. */
    public List<ZoneCoverage> byZone() {
        return zones.stream()
                .map(zone -> new ZoneCoverage(
                        zone.zone(),
                        zone.weight(),
                        zone.rows().cardinality() / headings,
                        zone.covered(problem, result.chosen()),
                        zone.present()))
                .toList();
    }

    /**
     * The fraction of all rows that some rows make up by their weights, exactly 1 for all of them.
     *
     * @param weight sum of the weights of these rows
     * @param rows sum of the weights of all rows
     */
    static double fraction(double weight, int rows) {
        return Math.abs(weight - rows) <= ROUNDING * rows ? 1.0 : weight / rows;
    }

    private double fraction(double weight) {
        return fraction(weight, rows);
    }

    /** The number of cells that count. */
    public int cells() {
        return rows / headings;
    }

    /** The fraction of the airspace that a layout covers in the scene as it is, and under each condition. */
    private double[] byCondition(List<Integer> layout) {
        return DoubleStream.of(problem.sums(layout)).map(this::fraction).toArray();
    }

    @Override
    public Map<String, Double> byCondition() {
        Map<String, Double> byName = new LinkedHashMap<>();
        double[] fractions = byCondition(result.chosen());
        for (int number = 1; number < fractions.length; number++) {
            byName.put(plan.conditions().get(number - 1).name(), fractions[number]);
        }
        return byName;
    }

    @Override
    public double asItIs() {
        return byCondition(result.chosen())[0];
    }

    /** The fraction of the airspace that the layout covers. */
    @Override
    public double value() {
        return fraction(result.value());
    }

    /** The fraction that no layout exceeds. */
    @Override
    public double bound() {
        return fraction(result.bound());
    }

    /** The fraction of the airspace that a chosen sensor covers by itself. */
    @Override
    public OptionalDouble alone(SiteCandidate sensor) {
        PlacementProblem once = new PlacementProblem(problem.table(), problem.objective(), PlacementConditions.NONE);
        return OptionalDouble.of(fraction(once.value(List.of(plan.candidates().indexOf(sensor)))));
    }

    /** The fraction that remains covered without each of the sensors, by their names, in the order of the file. */
    @Override
    public Map<String, Double> withoutEach() {
        Map<String, Double> remaining = new LinkedHashMap<>();
        for (Integer lost : result.chosen()) {
            List<Integer> rest = problem.losses().remaining(result.chosen(), lost);
            remaining.put(plan.candidates().get(lost).name(), fraction(problem.value(rest)));
        }
        return remaining;
    }

    @Override
    public OptionalDouble together(List<SiteCandidate> sensors) {
        List<Integer> numbers = sensors.stream().map(plan.candidates()::indexOf).toList();
        return OptionalDouble.of(fraction(problem.value(numbers)));
    }

    @Override
    public Optional<EarlyPurchases> early() {
        return EarlyPurchases.of(this, problem, this::fraction);
    }

    @Override
    public List<PlaceStep> purchases() {
        return new BuyingOrder(
                        number -> plan.candidates().get(number).candidate().cost(), problem::value, some -> 0.0)
                .steps(this, this::fraction);
    }
}
