package org.dronewatch.report.placement;

import java.util.Optional;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.placement.site.WarningPlacement;
import org.dronewatch.setting.Counted;

/** States in sentences what the layout with the longest warning is worth. */
final class WarningSentences {
    private final WarningPlacement best;
    private final PlaceMeasure measure;

    WarningSentences(WarningPlacement best, PlaceMeasure measure) {
        this.best = best;
        this.measure = measure;
    }

    /** The warning that the layout gives, compared with the best possible. */
    String worth() {
        int heights = best.grid().heights().size();
        String given = "The layout " + measure.claim(true, best.value()) + " for straight flights from "
                + InboundWarnings.BEARINGS + " bearings at " + Counted.of(heights, "height")
                + ", at a cost of " + PlaceTable.amount(best.result().cost(), best.plan());
        return given
                + (best.bound() <= best.value()
                        ? "; no layout within the budget gives more."
                        : "; no layout within the budget gives more than " + measure.text(best.bound()) + ".")
                + " " + detected();
    }

    /** That the tables count differently from the search that chose the layout, in a sentence; empty if they do not. */
    Optional<String> difference() {
        return fold() > 1
                ? Optional.of("In the tables of warnings, a warning begins when the first sensor detects the drone; the"
                        + " layout was chosen for warnings that begin only when " + fold()
                        + " sensors have detected it.")
                : Optional.empty();
    }

    private int fold() {
        return best.plan().settings().conditions().fold();
    }

    /** How many flights the layout detects at all, and the longest warning that can be found. */
    String detected() {
        String flights = best.detected() + " of " + Counted.of(best.flights(), "flight");
        return (fold() > 1
                        ? "In " + flights + ", " + fold() + " sensors or more detect the drone before it arrives"
                        : "The layout detects " + flights + " before they arrive")
                + (best.byCondition().isEmpty() ? "" : ", under every condition")
                + "; a flight that is detected where it begins gives a warning of at most "
                + measure.text(best.longest()) + ".";
    }
}
