package org.dronewatch.report.coverage;

import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.sheet.MapSheet;

/** The map of the dominant causes at one height: how its cells are filled, and its legend. */
public final class CauseMap {
    private final FieldGrid grid;
    private final HeightSummary numbers;
    private final CoverageInputs inputs;
    private final CauseLegend legend;

    /**
     * The map of the height with the given index, from 0 for the lowest.
     *
     * @param inputs the inputs of the coverage
     */
    public CauseMap(FieldSummary summary, int height, CoverageInputs inputs) {
        this.grid = summary.coverage().field().grid();
        this.numbers = summary.heights().get(height);
        this.inputs = inputs;
        this.legend = CauseLegend.of(summary.coverage(), height, numbers.known());
    }

    /** The fill of a cell, given by its column from the west and its row from the north, both from 0. */
    public MapSheet.Fill fill(int column, int row) {
        return legend.at(column, row).fill();
    }

    /** Writes the legend, below the title of the sheet, and sets the caption. */
    public void writeLegend(MapSheet sheet) {
        String above = Numbers.text(numbers.height()) + " m";
        sheet.line("drone '" + inputs.drone() + "' at " + above + " above the ground,");
        sheet.line(inputs.headingInWords() + ";");
        writeMeaning(sheet);
        sheet.space();
        legend.rows(within()).forEach(row -> sheet.entry(row.fill(), row.words()));
        sheet.space();
        sheet.line("percentages of the known area"
                + inputs.area().map(name -> " in '" + name + "'").orElse(""));
        sheet.line("cells of " + Numbers.text(grid.cell()) + " m");
        sheet.caption("At " + above + " above the ground: where the drone is detected, and elsewhere the main reason"
                + " why not.");
    }

    /** What the colours represent: detection as it is asked for, and elsewhere the causes of a missed look. */
    private void writeMeaning(MapSheet sheet) {
        if (!inputs.hasDefaultProbability()) {
            sheet.line("detection" + within() + " with a probability of");
            sheet.line(Numbers.text(inputs.covered()) + " or more, elsewhere the dominant");
            sheet.line("cause of a single missed look:");
        } else if (inputs.within().isPresent()) {
            sheet.line("detection" + within() + ", elsewhere the");
            sheet.line("dominant cause of a single missed look:");
        } else {
            sheet.line("detection, or dominant cause of the miss:");
        }
    }

    private String within() {
        return inputs.within().isPresent() ? " within " + inputs.timeInWords() : "";
    }
}
