package org.dronewatch.app.search;

import java.util.Optional;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.CheaperCoverage;
import org.dronewatch.placement.site.CoveredCells;
import org.dronewatch.placement.site.LayoutFields;
import org.dronewatch.placement.site.LeftOut;
import org.dronewatch.placement.site.PlaceSearch;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.report.placement.CoveragePlaceResults;
import org.dronewatch.report.placement.PlaceResults;

/** Finds the layout that covers the most air, and its coverage beside that of the scene's own sensors. */
final class CoveragePlaceFinder implements PlaceFinder {
    @Override
    public PlaceResults find(PlaceTask task) {
        CoveredCells cells = new CoveredCells(task.plan(), task.stage(), task.store());
        PlaceSearch search = new PlaceSearch(task.plan(), cells, task.solver());
        SitePlacement best = task.during(
                "coverage of candidates",
                cells.looks(),
                progress -> search.found(task.limits(), progress, task::assessed));
        BudgetFront<SitePlacement> front = task.front(new CheaperCoverage(best, cells, task.solver()));
        int sensors = front.best().chosen().size()
                + task.plan().present().enabledSensors().size();
        Optional<LayoutFields> fields = !task.interruption().happened()
                ? task.during(
                        "coverage of the layout",
                        cells.looks(sensors),
                        progress -> LayoutFields.of(front.best(), cells, progress))
                : Optional.empty();
        boolean isMissing = fields.isEmpty() && !front.best().chosen().isEmpty();
        return new CoveragePlaceResults(task.checked(front, LeftOut.COVERAGE, isMissing), fields);
    }
}
