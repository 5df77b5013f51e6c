package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleUnaryOperator;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementObjective;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.placement.plan.WarningMeasure;

/**
 * The layout of a plan with the longest warning time, taken either for the worst of all straight inbound flights or as
 * the mean over them. The warning time of a flight is 0 if the drone is not detected before it arrives.
 *
 * @param plan what was asked for
 * @param grid the cells; the length of their sides is the step of the flights
 * @param longest the longest warning time that can be found, that of a flight detected where it begins, s
 * @param problem the problem, with a row for each flight under each condition; for the worst warning time, its values
 *     are the amounts by which warning times are shorter than the longest, s
 * @param result result of the search, in the unit of the values of the problem
 * @param assessed number of candidates that were assessed, the first ones of the plan
 * @param present the scene's own sensors and their warning time, s; empty if the scene has none, or the search was
 *     interrupted before they were assessed
 * @param complete whether every candidate and the scene's own sensors were assessed, and the search ran to completion
 */
public record WarningPlacement(
        PlacePlan plan,
        FieldGrid grid,
        double longest,
        PlacementProblem problem,
        PlacementResult result,
        int assessed,
        Optional<PresentLayout> present,
        boolean complete)
        implements PlacedLayout {
    /** This placement with another layout. */
    WarningPlacement with(PlacementResult other) {
        return new WarningPlacement(
                plan, grid, longest, problem, other, assessed, present, complete && other.complete());
    }

    /** Which warning time counts: the worst or the mean. */
    public WarningMeasure measure() {
        return plan.settings().warning();
    }

    /** The number of flights, which are the same under each condition. */
    public int flights() {
        return problem.table().rows() / (1 + plan.conditions().size());
    }

    /**
     * The warning time of each flight under each condition, given by the sensor that counts: the first, or a later one
     * that has to confirm the detection, s.
     */
    double[] warnings(List<Integer> layout) {
        int fold = problem.conditions().fold();
        double[][] times = new double[problem.table().rows()][fold];
        for (int candidate : layout) {
            CandidateColumn column = problem.table().column(candidate);
            for (int at = 0; at < column.size(); at++) {
                double warning = measure() == WarningMeasure.WORST ? longest - column.value(at) : column.value(at);
                double[] its = times[column.row(at)];
                // In ascending order, so that the first is the one that counts.
                if (warning > its[0]) {
                    its[0] = warning;
                    Arrays.sort(its);
                }
            }
        }
        return Arrays.stream(times).mapToDouble(its -> its[0]).toArray();
    }

    /** The warning time that the layout gives in the scene as it is, and under each condition, s. */
    private List<Double> inScenes() {
        double[] all = warnings(result.chosen());
        List<Double> values = new ArrayList<>();
        for (int start = 0; start < all.length; start += flights()) {
            DoubleStream its = Arrays.stream(all, start, start + flights());
            values.add((measure() == WarningMeasure.WORST ? its.min() : its.average()).orElse(0.0));
        }
        return values;
    }

    @Override
    public Map<String, Double> byCondition() {
        List<Double> values = inScenes();
        Map<String, Double> byName = new LinkedHashMap<>();
        for (int number = 1; number < values.size(); number++) {
            byName.put(plan.conditions().get(number - 1).name(), values.get(number));
        }
        return byName;
    }

    @Override
    public double asItIs() {
        return inScenes().get(0);
    }

    private double seconds(double value) {
        return measure() == WarningMeasure.WORST ? longest - value : value;
    }

    /** The warning time that the layout gives, s. */
    @Override
    public double value() {
        return seconds(result.value());
    }

    /** The warning time that no layout exceeds, s. */
    @Override
    public double bound() {
        return seconds(result.bound());
    }

    /** The warning time that some candidates give, by their numbers, s. */
    private double warning(List<Integer> candidates) {
        return seconds(problem.value(candidates));
    }

    /**
     * The number of flights on which, under every condition, enough sensors of the layout detect the drone before it
     * arrives.
     */
    public long detected() {
        int[] counts = new int[problem.table().rows()];
        for (int one : result.chosen()) {
            CandidateColumn column = problem.table().column(one);
            for (int at = 0; at < column.size(); at++) {
                counts[column.row(at)]++;
            }
        }
        int fold = problem.conditions().fold();
        return IntStream.range(0, flights())
                .filter(flight -> IntStream.iterate(flight, row -> row < counts.length, row -> row + flights())
                        .allMatch(row -> counts[row] >= fold))
                .count();
    }

    /** The warning time that a sensor of the layout gives by itself, s. */
    @Override
    public OptionalDouble alone(SiteCandidate sensor) {
        PlacementProblem once = new PlacementProblem(problem.table(), problem.objective(), PlacementConditions.NONE);
        return OptionalDouble.of(seconds(once.value(List.of(plan.candidates().indexOf(sensor)))));
    }

    /** The warning time that remains without each of the sensors, by their names, in the order of the file, s. */
    @Override
    public Map<String, Double> withoutEach() {
        Map<String, Double> remaining = new LinkedHashMap<>();
        for (Integer lost : result.chosen()) {
            remaining.put(
                    plan.candidates().get(lost).name(), warning(problem.losses().remaining(result.chosen(), lost)));
        }
        return remaining;
    }

    @Override
    public OptionalDouble together(List<SiteCandidate> sensors) {
        List<Integer> numbers = sensors.stream().map(plan.candidates()::indexOf).toList();
        return OptionalDouble.of(warning(numbers));
    }

    @Override
    public Optional<EarlyPurchases> early() {
        return EarlyPurchases.of(this, problem, this::seconds);
    }

    /** {@inheritDoc} Where the shortest warning time is the same, the sum of all warning times counts. */
    @Override
    public List<PlaceStep> purchases() {
        return new BuyingOrder(
                        number -> plan.candidates().get(number).candidate().cost(), this::warning, otherwise())
                .steps(this, DoubleUnaryOperator.identity());
    }

    private ToDoubleFunction<List<Integer>> otherwise() {
        if (measure() == WarningMeasure.MEAN) {
            return some -> 0.0;
        }
        PlacementProblem all =
                new PlacementProblem(problem.table(), PlacementObjective.MEAN_IMPACT, problem.conditions());
        return some -> -all.value(some);
    }
}
