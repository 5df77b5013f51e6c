package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldHeading;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.Gap;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.placement.plan.Cues;
import org.dronewatch.placement.site.LayoutFields;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.report.CompassPoint;
import org.dronewatch.report.coverage.table.CoverageTable;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.sensor.Cause;

/** The coverage of the layout and of the scene's own sensors, height by height. */
final class FieldsTable {
    private static final String ROW = "%10s  %8s  %8s  %11s  %11s  %10s  %10s";
    private static final double HECTARE = 1e4;

    private FieldsTable() {}

    /**
     * A table, and the largest gap of the layout in a sentence.
     *
     * @param layout the layout with this coverage
     */
    static List<String> lines(LayoutFields fields, SitePlacement layout) {
        int fold = layout.plan().settings().conditions().fold();
        List<String> lines = new ArrayList<>();
        lines.add("coverage" + byOne(fold) + heading(fields)
                + ", in % of the known cells, also after the worst loss of a sensor, and the" + " largest gap in ha:");
        lines.add(PlaceTable.text(ROW, "", "covered", "", "after loss", "", "gap", ""));
        lines.add(PlaceTable.text(ROW, "height", "today", "layout", "today", "layout", "today", "layout"));
        for (int height = 0; height < fields.layout().heights().size(); height++) {
            lines.add(row(fields, height));
        }
        lines.add(worstPlace(fields.layout()));
        lines.addAll(differences(layout));
        return lines;
    }

    private static String row(LayoutFields fields, int height) {
        HeightFigures layout = new HeightFigures(fields.layout().heights().get(height));
        Optional<HeightFigures> today =
                fields.present().map(its -> new HeightFigures(its.heights().get(height)));
        return PlaceTable.text(
                ROW,
                Numbers.text(fields.layout().heights().get(height).height()) + " m",
                today.map(HeightFigures::covered).orElse(HeightFigures.NONE),
                layout.covered(),
                today.map(HeightFigures::afterWorstLoss).orElse(HeightFigures.NONE),
                layout.afterWorstLoss(),
                today.map(HeightFigures::largestGap).orElse(HeightFigures.NONE),
                layout.largestGap());
    }

    /** {@code by one sensor or more}, with a space before it; an empty text where that is all that counts. */
    static String byOne(int fold) {
        return fold > 1 ? " by one sensor or more" : "";
    }

    /** How the table counts differently from the search that chose the layout, in sentences. */
    static List<String> differences(SitePlacement layout) {
        List<String> sentences = new ArrayList<>();
        int fold = layout.plan().settings().conditions().fold();
        if (fold > 1) {
            sentences.add("The coverage by height counts every cell that at least one sensor covers; the layout was"
                    + " chosen for what " + fold + " sensors or more cover.");
        }
        if (!new Cues(layout.plan()).uncuedWithout(layout.chosen()).isEmpty()) {
            sentences.add(
                    "After a loss, the coverage by height still counts sensors as turned to the drone, even if nothing"
                            + " cues them any longer.");
        }
        return sentences;
    }

    /** {@code on the heading that is worst in each cell}, with a space before it. */
    static String heading(LayoutFields fields) {
        return fields.heading() == FieldHeading.INBOUND
                ? " of inbound flight"
                : " on the heading that is worst in each cell";
    }

    /** The largest gap that a layout leaves: where it is, and why. */
    static String worstPlace(FieldSummary summary) {
        Optional<HeightSummary> worst = summary.heights().stream()
                .filter(height -> height.gap().isPresent())
                .max(Comparator.comparingDouble(
                        height -> height.gap().orElseThrow().area()));
        if (worst.isEmpty()) {
            return "The layout leaves no gap at these heights.";
        }
        Gap gap = worst.get().gap().orElseThrow();
        FieldGrid grid = summary.coverage().field().grid();
        double east = gap.x() - grid.east();
        double north = gap.y() - grid.north();
        double distance = Math.hypot(east, north);
        String where = distance < grid.cell()
                ? "at the centre of the area"
                : PlaceTable.text(
                        "%.0f m %s of the centre of the area",
                        distance, CompassPoint.of(StrictMath.atan2(east, north)));
        return "The layout's largest gap is " + PlaceTable.text("%.1f ha", gap.area() / HECTARE) + " at "
                + Numbers.text(worst.get().height()) + " m above the ground, " + where + "; the main cause: "
                + (gap.cause() == Cause.DETECTED
                        ? "too low a probability of detection"
                        : CoverageTable.name(gap.cause()))
                + ".";
    }
}
