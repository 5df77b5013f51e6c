package org.dronewatch.app.search;

import org.dronewatch.placement.plan.PlaceObjective;
import org.dronewatch.report.placement.PlaceResults;

/** Finds the best layout for one objective, and the other figures that are reported for it. */
public interface PlaceFinder {
    /** Finds the best layout, on the {@link org.dronewatch.parallel.Workers} of the calling thread. */
    PlaceResults find(PlaceTask task);

    /** The finder for an objective. */
    static PlaceFinder of(PlaceObjective objective) {
        return switch (objective) {
            case COVERAGE -> new CoveragePlaceFinder();
            case WARNING_TIME -> new WarningPlaceFinder();
            case WEAKEST_ROUTE -> new RoutePlaceFinder();
        };
    }
}
