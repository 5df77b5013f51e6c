package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.dronewatch.analysis.field.FieldHeading;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.placement.site.LayoutFields;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.setting.Counted;

/** States in sentences what the layout that covers the most air is worth. */
final class CoverageSentences {
    private final CoveragePlaceResults results;
    private final SitePlacement best;
    private final int fold;

    CoverageSentences(CoveragePlaceResults results) {
        this.results = results;
        this.best = results.best();
        this.fold = best.plan().settings().conditions().fold();
    }

    /** What the layout covers, compared with the best possible, with today's sensors, and after a loss. */
    List<String> lines() {
        PlaceTable table = new PlaceTable(best, results.measure());
        List<String> lines = new ArrayList<>(List.of(worth()));
        new SilentDrone(best, results.measure()).sentence().ifPresent(lines::add);
        table.uncued().ifPresent(lines::add);
        table.byCondition().ifPresent(lines::add);
        table.present().ifPresent(lines::add);
        table.worstLoss().ifPresent(lines::add);
        results.fields().ifPresent(fields -> lines.add(together(fields)));
        return lines;
    }

    private String together(LayoutFields fields) {
        if (fields.heading() == FieldHeading.INBOUND) {
            return "All figures are for flight towards the protected zone.";
        }
        return "On the heading that is worst in each cell, the layout covers "
                + FrontWords.percent(LayoutFields.share(fields.layout(), fold)) + " of the known cells"
                + (fold > 1 ? " with " + fold + " sensors or more" : "") + today(fields) + ".";
    }

    /** What the scene's own sensors cover on the same heading, as a clause; an empty text if there are none. */
    private String today(LayoutFields fields) {
        return fields.present()
                .map(own -> "; the scene's own sensors cover " + FrontWords.percent(LayoutFields.share(own, fold)))
                .orElse("");
    }

    private String worth() {
        String covered = "The layout covers " + FrontWords.percent(best.value())
                + results.measure().whole() + " (" + Counted.of(best.cells(), "cell") + "), for "
                + PlaceTable.amount(best.result().cost(), best.plan());
        boolean isBest = best.value() == best.bound();
        return covered
                + (isBest
                        ? "; no layout within the budget covers more."
                        : "; no layout within the budget covers "
                                + FrontWords.moreThan(FrontWords.percent(best.bound())) + ".");
    }

    /** What the layout covers on the worst heading, and where it covers least; empty without a layout. */
    String leastCovered() {
        return results.fields()
                .map(fields -> {
                    HeightSummary least = leastCovered(fields);
                    return (best.headings() > 1 ? together(fields) + " On that heading" : "With all its sensors")
                            + ", the layout covers least at " + PlaceTable.text("%.0f", least.height())
                            + " m above the ground: " + new HeightFigures(least).covered() + " %"
                            + (fold > 1 ? ", counting every cell that at least one sensor covers." : ".");
                })
                .orElse("");
    }

    /** The height at which the layout covers the smallest fraction; the lowest of several that are equal. */
    static HeightSummary leastCovered(LayoutFields fields) {
        return fields.layout().heights().stream()
                .min(Comparator.comparingDouble(
                        height -> height.known() == 0 ? 1.0 : (double) height.covered() / height.known()))
                .orElseThrow();
    }
}
