package org.dronewatch.report.coverage;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.report.coverage.table.CoverageTable;
import org.dronewatch.report.sheet.MapSheet;

/** What the cells of a map of causes show, and its legend. Immutable. */
final class CauseLegend {
    private final FieldGrid grid;
    private final CellState[] cells;
    private final int known;

    /** What a cell shows. */
    interface States {
        CellState of(int column, int row);
    }

    /**
     * A row.
     *
     * @param fill the colour and the pattern
     * @param words what it means, with its fraction of the known cells
     */
    record LegendRow(MapSheet.Fill fill, String words) {}

    /**
     * A legend.
     *
     * @param known the number of known cells
     */
    CauseLegend(FieldGrid grid, int known, States states) {
        this.grid = grid;
        this.known = known;
        this.cells = new CellState[grid.cells()];
        grid.forEachCell((column, row) -> cells[grid.cell(column, row)] = states.of(column, row));
    }

    /** The legend of a height of a coverage, given by its number. */
    static CauseLegend of(FieldCoverage coverage, int height, int known) {
        return new CauseLegend(
                coverage.field().grid(), known, (column, row) -> CellState.of(coverage, height, column, row));
    }

    /** What a cell shows. */
    CellState at(int column, int row) {
        return cells[grid.cell(column, row)];
    }

    /**
     * The rows of all states that occur; there is always one for what is detected.
     *
     * @param within the time within which the drone has to be detected, with a space before it; empty for a single look
     */
    List<LegendRow> rows(String within) {
        SortedMap<CellState, Integer> counts = new TreeMap<>();
        counts.put(CellState.COVERED, 0);
        for (CellState cell : cells) {
            counts.merge(cell, 1, Integer::sum);
        }
        List<LegendRow> rows = new ArrayList<>();
        counts.forEach((state, count) -> rows.add(new LegendRow(state.fill(), inWords(state, count, within))));
        return rows;
    }

    private String inWords(CellState state, int count, String within) {
        String words = state.inWords(!within.isEmpty()) + (state.equals(CellState.COVERED) ? within : "");
        return state.isKnown() ? words + ": " + share(count) : words;
    }

    private String share(int count) {
        return count == 0 ? "nowhere" : CoverageTable.percent(count, known) + " %";
    }
}
