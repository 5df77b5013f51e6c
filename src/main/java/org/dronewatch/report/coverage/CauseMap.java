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

    /** The fill of a cell: what covers it, or the dominant cause of the miss, in a single look. */
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
        return coverage.field().sensors().isEmpty()
                ? CauseFills.NO_SENSOR
                : CauseFills.of(coverage.cause(height, column, row));
    }

    /**
     * The fill of a cell. If the drone has to be detected within a time, what is covered counts as detected, since the
     * cause is that of a single look.
     */
    MapSheet.Fill fill(int column, int row) {
        if (inputs.within().isEmpty() || !coverage.isKnown(height, column, row)) {
            return fill(coverage, height, column, row);
        }
        if (coverage.isCovered(height, column, row)) {
            return CauseFills.of(Cause.DETECTED);
        }
        Cause cause = coverage.cause(height, column, row);
        return cause == Cause.DETECTED ? CauseFills.LATER : CauseFills.of(cause);
    }

    /** Writes the legend below the title, and the caption. */
    void writeLegend(MapSheet sheet) {
        String above = Numbers.text(numbers.height()) + " m";
        sheet.line("drone '" + inputs.drone() + "' at " + above + " above the ground,");
        sheet.line(inputs.headingInWords() + ";");
        if (inputs.within().isPresent()) {
            writeWithin(sheet);
        } else {
            sheet.line("detection, or dominant cause of the miss:");
            sheet.space();
            writeEntry(sheet, Cause.DETECTED, numbers.causes().getOrDefault(Cause.DETECTED, 0));
            numbers.causes().forEach((cause, cells) -> {
                if (cause != Cause.DETECTED) {
                    writeEntry(sheet, cause, cells);
                }
            });
        }
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

    /** Where the drone is detected in time, and elsewhere the causes of a missed look. */
    private void writeWithin(MapSheet sheet) {
        sheet.line("detection within " + inputs.timeInWords() + ", elsewhere the");
        sheet.line("dominant cause of a single missed look:");
        sheet.space();
        String detected = "detected within " + inputs.timeInWords() + ": " + share(numbers.covered());
        sheet.entry(CauseFills.of(Cause.DETECTED), detected);
        elsewhere().forEach((cause, cells) -> {
            if (cause == Cause.DETECTED) {
                sheet.entry(CauseFills.LATER, "detected given more time: " + share(cells));
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
