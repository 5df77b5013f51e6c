package org.dronewatch.placement.site;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import org.dronewatch.parallel.Workers;
import org.dronewatch.placement.SolverLimits;

/**
 * Finds layouts that cost less than the best one, for one objective.
 *
 * @param <L> a layout for that objective
 */
public interface CheaperLayouts<L extends PlacedLayout> {
    /** The best layout for the whole budget. */
    L best();

    /** The best layout for a lower budget; empty if none complies with the conditions, or the search is stopped. */
    Optional<L> within(double budget, SolverLimits limits);

    /**
     * A layout with another bound, in the unit of the values of its result. A bound that is worse than the value of the
     * layout is replaced by that value.
     */
    L bounded(L layout, double bound);

    /**
     * Where a layout is better than the best one for the next lower budget; empty if it is not better anywhere.
     *
     * @param before the layout for the next lower budget; empty if there is none
     */
    Optional<SectorGain> gain(Optional<L> before, L after);

    /**
     * Whether a layout is better than some value by more than the search can resolve: false if the values are equal, or
     * if they are estimates that differ by less than the gap of the search.
     */
    default boolean isBetter(L layout, double value, SolverLimits limits) {
        return layout.value() > value;
    }

    /**
     * A layout completed with the figures that are stated only for the whole budget, such as those of its parts; by
     * default, the layout unchanged.
     */
    default L described(L layout) {
        return layout;
    }

    /**
     * Calls an action for each of several budgets, in any order, on the {@link Workers} of the calling thread.
     *
     * @param budgets number of budgets
     * @param action receives the index of each budget, from 0
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    default void forEach(int budgets, IntConsumer action) {
        Workers.forEach(budgets, action);
    }
}
