package org.dronewatch.report.coverage;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.survey.RemainingCoverage;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.SiteSkin;
import org.dronewatch.report.sheet.MapSheet;

/**
 * An overlay (skin) that shows the coverage at one height on ground and roofs, in the colours and patterns of the map
 * of causes. Cells whose coverage is lost because sensors are switched off are crossed out. Immutable.
 */
public final class CoverageSkin implements SiteSkin {
    private static final int SWATCH_WIDTH = 24;
    private static final int SWATCH_HEIGHT = 16;
    private static final int SWATCH_GROUND = 0xd8d4cc;

    /** The ground is paler than it is without the skin, so that its own colour does not mix with those of the skin. */
    private static final int PALEST = 255;

    private static final double PALER = 0.45;

    private final FieldGrid grid;
    private final CauseLegend shown;
    private final MapSheet.Fill[] fills;

    /**
     * An entry of the legend.
     *
     * @param swatch an example of the colour and the pattern
     * @param words what the colour means, with its fraction of the known cells
     */
    public record LegendEntry(BufferedImage swatch, String words) {}

    /** A cell of the overlay, by column from the west and row from the north, both from 0. */
    public record SkinCell(int column, int row) {}

    /** The overlay for the height of the given coverage. */
    public CoverageSkin(RemainingCoverage remaining) {
        this.grid = remaining.rest().field().grid();
        this.shown = new CauseLegend(
                grid,
                remaining.known(),
                (column, row) -> remaining.isLost(column, row)
                        ? CellState.LOST
                        : CellState.of(remaining.rest(), remaining.height(), column, row));
        this.fills = new MapSheet.Fill[grid.cells()];
        grid.forEachCell((column, row) ->
                fills[grid.cell(column, row)] = shown.at(column, row).fill());
    }

    @Override
    public int colour(double east, double north, int column, int row, int below) {
        int cell = cell(east, north);
        return cell < 0 ? below : fills[cell].at(column, row, pale(below)) & 0xffffff;
    }

    private int cell(double east, double north) {
        double half = 0.5 * grid.columns();
        int column = (int) Math.floor((east - grid.east()) / grid.cell() + half);
        int row = (int) Math.floor((grid.north() - north) / grid.cell() + half);
        boolean isIn = column >= 0 && row >= 0 && column < grid.columns() && row < grid.columns();
        return isIn ? grid.cell(column, row) : -1;
    }

    /** The grey of a colour, with the weights of ITU-R BT.601, paler. */
    private static int pale(int colour) {
        double luma = 0.299 * (colour >> 16 & 255) + 0.587 * (colour >> 8 & 255) + 0.114 * (colour & 255);
        int grey = (int) (PALER * PALEST + (1.0 - PALER) * luma + 0.5);
        return grey << 16 | grey << 8 | grey;
    }

    /** The cell above or below a point; empty outside the grid. */
    public Optional<SkinCell> cellAt(Position point) {
        int cell = cell(point.x(), point.y());
        return cell < 0 ? Optional.empty() : Optional.of(new SkinCell(grid.column(cell), grid.row(cell)));
    }

    /** The meaning of the colours that occur, with fractions of the known cells. */
    public List<LegendEntry> legend() {
        return shown.rows("").stream()
                .map(row -> new LegendEntry(swatch(row.fill()), row.words()))
                .toList();
    }

    private static BufferedImage swatch(MapSheet.Fill fill) {
        BufferedImage image = new BufferedImage(SWATCH_WIDTH, SWATCH_HEIGHT, BufferedImage.TYPE_INT_RGB);
        for (int v = 0; v < SWATCH_HEIGHT; v++) {
            for (int u = 0; u < SWATCH_WIDTH; u++) {
                image.setRGB(u, v, fill.at(u, v, SWATCH_GROUND));
            }
        }
        return image;
    }
}
