package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleUnaryOperator;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.plan.SiteCandidate;

/**
 * The largest number of purchases, fewer than all, after which the layout does not yet comply with the conditions.
 *
 * @param count number of purchases, 1 or more
 * @param afterLoss the value that remains after the worst loss, in the unit of the objective; empty unless it is too
 *     low
 * @param uncued names of the sensors bought so far that need a cue but get none from the others
 */
public record EarlyPurchases(int count, OptionalDouble afterLoss, List<String> uncued) {
    /**
     * Those of a layout; empty if it complies after each purchase.
     *
     * @param unit converts a value of the problem to the unit of the objective
     */
    static Optional<EarlyPurchases> of(PlacedLayout layout, PlacementProblem problem, DoubleUnaryOperator unit) {
        List<String> names =
                layout.plan().candidates().stream().map(SiteCandidate::name).toList();
        List<Integer> bought = new ArrayList<>(FrontSearch.kept(layout));
        List<PlaceStep> steps = layout.purchases();
        Optional<EarlyPurchases> last = Optional.empty();
        for (int count = 1; count < steps.size(); count++) {
            bought.add(names.indexOf(steps.get(count - 1).added()));
            if (!problem.isAllowed(bought)) {
                OptionalDouble remaining = problem.survivesLoss(bought)
                        ? OptionalDouble.empty()
                        : OptionalDouble.of(unit.applyAsDouble(problem.valueAfterWorstLoss(bought)));
                last = Optional.of(new EarlyPurchases(count, remaining, problem.lacking(bought)));
            }
        }
        return last;
    }
}
