package org.dronewatch.report.placement;

import java.util.List;
import java.util.Optional;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.PlacedLayout;

/** What a search for placements found, and what became of the attacks that were to be flown against it. */
interface FoundPlaceResults extends PlaceResults {
    /** What the search found. */
    PlaceResults found();

    @Override
    default BudgetFront<? extends PlacedLayout> front() {
        return found().front();
    }

    @Override
    default PlaceMeasure measure() {
        return found().measure();
    }

    @Override
    default Optional<String> shortfall() {
        return found().shortfall();
    }

    @Override
    default Optional<String> worstLoss() {
        return found().worstLoss();
    }

    /** The lines of the search; the tables of attacks are those of the command {@code campaign}. */
    @Override
    default List<String> lines() {
        return found().lines();
    }

    @Override
    default List<String> reproduction(String layout) {
        return found().reproduction(layout);
    }
}
