package org.dronewatch.app.search;

import java.util.Optional;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.CheaperWarnings;
import org.dronewatch.placement.site.LayoutWarnings;
import org.dronewatch.placement.site.LeftOut;
import org.dronewatch.placement.site.WarningPlacement;
import org.dronewatch.placement.site.WarningSearch;
import org.dronewatch.report.placement.PlaceResults;
import org.dronewatch.report.placement.WarningPlaceResults;

/** Finds the layout with the longest warning, and its warnings beside those of the scene's own sensors. */
final class WarningPlaceFinder implements PlaceFinder {
    @Override
    public PlaceResults find(PlaceTask task) {
        WarningSearch search = new WarningSearch(task.plan(), task.stage(), task.store(), task.solver());
        WarningPlacement best = task.during(
                "warnings of candidates",
                search.looks(),
                progress -> search.found(task.limits(), progress, task::assessed));
        BudgetFront<WarningPlacement> front = task.front(new CheaperWarnings(best, task.solver()));
        int sensors = front.best().chosen().size()
                + task.plan().present().enabledSensors().size();
        Optional<LayoutWarnings> warnings = !task.interruption().happened()
                ? task.during(
                        "warnings of the layout",
                        search.looks(sensors),
                        progress -> search.compared(front.best(), progress))
                : Optional.empty();
        boolean isMissing = warnings.isEmpty() && !front.best().chosen().isEmpty();
        return new WarningPlaceResults(task.checked(front, LeftOut.WARNINGS, isMissing), warnings);
    }
}
