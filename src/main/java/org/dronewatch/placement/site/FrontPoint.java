package org.dronewatch.placement.site;

import java.util.List;
import java.util.Optional;

/**
 * The best layout that was found for a budget, and how it differs from the one for the next lower budget.
 *
 * @param <L> a layout for some objective
 * @param budget the budget for which the layout was sought; the bound of the layout holds for all budgets up to this
 *     one
 * @param layout the layout that was found; it may cost less
 * @param added names of the sensors that the previous layout does not have, in the order of the file; if there is no
 *     previous layout, all but those that are kept
 * @param removed names of the sensors that only the previous layout has
 * @param gain where the layout is better than the previous one; empty if it is not better anywhere
 */
public record FrontPoint<L extends PlacedLayout>(
        double budget, L layout, List<String> added, List<String> removed, Optional<SectorGain> gain) {
    /** Copies the lists. */
    public FrontPoint {
        added = List.copyOf(added);
        removed = List.copyOf(removed);
    }

    /** This point, with what else is known of the layout. */
    FrontPoint<L> with(L described) {
        return new FrontPoint<>(budget, described, added, removed, gain);
    }

    /** What the layout costs. */
    public double cost() {
        return layout.result().cost();
    }
}
