package org.dronewatch.report.placement;

import java.util.Optional;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.LayoutFields;
import org.dronewatch.placement.site.SitePlacement;

/**
 * What a placement found.
 *
 * @param front best layouts for several budgets
 * @param fields coverage of the layout and of the scene's own sensors; empty if the layout has no sensor, or the search
 *     was interrupted before they were assessed
 */
public record PlaceResults(BudgetFront front, Optional<LayoutFields> fields) {
    /** The best layout for the whole budget. */
    public SitePlacement best() {
        return front.best();
    }

    /** Whether nothing is missing. */
    public boolean complete() {
        return best().complete()
                && front.complete()
                && (fields.isPresent() || best().chosen().isEmpty());
    }
}
