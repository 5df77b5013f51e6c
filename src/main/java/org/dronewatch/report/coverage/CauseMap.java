package org.dronewatch.report.coverage;

import java.util.EnumMap;
import java.util.Map;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.analysis.field.FieldSummary;
import org.dronewatch.analysis.field.HeightSummary;
import org.dronewatch.report.Numbers;
import org.dronewatch.sensor.Cause;

/** The map of the dominant causes at one height: how its cells are filled, and its legend. */
final class CauseMap {
    private final FieldCoverage coverage;
    private final int height;
    private final HeightSummary numbers;
    private final CoverageInputs inputs;

    /**
     * The map of a height, given by its number.
     *
     * @param inputs what the coverage was asked for
     */
    CauseMap(FieldSummary summary, int height, CoverageInputs inputs) {
        this.coverage = summary.coverage();
        this.height = height;
        this.numbers = summary.heights().get(height);
        this.inputs = inputs;
    }

    /**
     * The fill of a cell: what is covered with the probability that is asked for counts as detected, whatever the cause
     * in a single look is; elsewhere the dominant cause.
     */
    static MapSheet.Fill fill(FieldCoverage coverage, int height, int column, int row) {
        if (coverage.field().isOutside(height, column, row)) {
            return CauseFills.OUTSIDE;
        }
        if (coverage.field().isInside(height, column, row)) {
            return CauseFills.INSIDE;
        }
        if (coverage.isUnknown(height, column, row)) {
            return CauseFills.of(Cause.UNKNOWN);
        }
        if (coverage.field().sensors().isEmpty()) {
            return CauseFills.NO_SENSOR;
        }
        if (coverage.isCovered(height, column, row)) {
            return CauseFills.of(Cause.DETECTED);
        }
        Cause cause = coverage.cause(height, column, row);
        return cause == Cause.DETECTED ? CauseFills.TOO_RARELY : CauseFills.of(cause);
    }

    /** The fill of a cell. */
    MapSheet.Fill fill(int column, int row) {
        return fill(coverage, height, column, row);
    }

    /** Writes the legend below the title, and the caption. */
    void writeLegend(MapSheet sheet) {
        String above = Numbers.text(numbers.height()) + " m";
        sheet.line("drone '" + inputs.drone() + "' at " + above + " above the ground,");
        sheet.line(inputs.headingInWords() + ";");
        writeCauses(sheet);
        sheet.space();
        sheet.line("percentages of the known area"
                + inputs.area().map(name -> " in '" + name + "'").orElse(""));
        if (numbers.unknown() > 0) {
            sheet.entry(CauseFills.of(Cause.UNKNOWN), "unknown");
        }
        if (numbers.inside() > 0) {
            sheet.entry(CauseFills.INSIDE, "inside something solid");
        }
        sheet.line("cells of " + Numbers.text(coverage.field().grid().cell()) + " m");
        sheet.caption("At " + above + " above the ground: where the drone is detected, and the main reason elsewhere.");
    }

    /** Where the drone is detected as is asked for, and elsewhere the causes of a missed look. */
    private void writeCauses(MapSheet sheet) {
        boolean isWithin = inputs.within().isPresent();
        String within = isWithin ? " within " + inputs.timeInWords() : "";
        if (!inputs.hasDefaultProbability()) {
            sheet.line("detection" + within + " with a probability of");
            sheet.line(Numbers.text(inputs.covered()) + " or more, elsewhere the dominant");
            sheet.line("cause of a single missed look:");
        } else if (isWithin) {
            sheet.line("detection" + within + ", elsewhere the");
            sheet.line("dominant cause of a single missed look:");
        } else {
            sheet.line("detection, or dominant cause of the miss:");
        }
        sheet.space();
        sheet.entry(CauseFills.of(Cause.DETECTED), "detected" + within + ": " + share(numbers.covered()));
        elsewhere().forEach((cause, cells) -> {
            if (cause == Cause.DETECTED) {
                sheet.entry(CauseFills.TOO_RARELY, CauseFills.tooRarely(isWithin) + ": " + share(cells));
            } else {
                writeEntry(sheet, cause, cells);
            }
        });
    }

    /** The number of cells that are not covered by their cause. */
    private Map<Cause, Integer> elsewhere() {
        Map<Cause, Integer> elsewhere = new EnumMap<>(Cause.class);
        FieldGrid grid = coverage.field().grid();
        for (int cell = 0; cell < grid.cells(); cell++) {
            int column = cell % grid.columns();
            int row = cell / grid.columns();
            if (coverage.isKnown(height, column, row) && !coverage.isCovered(height, column, row)) {
                elsewhere.merge(coverage.cause(height, column, row), 1, Integer::sum);
            }
        }
        return elsewhere;
    }

    private void writeEntry(MapSheet sheet, Cause cause, int cells) {
        sheet.entry(CauseFills.of(cause), CoverageTable.name(cause) + ": " + share(cells));
    }

    private String share(int cells) {
        return (numbers.known() == 0 ? "-" : CoverageTable.percent(cells, numbers.known())) + (cells == 0 ? "" : " %");
    }
}
