package org.dronewatch.report;

import java.awt.Color;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronewatch.analysis.FieldCoverage;
import org.dronewatch.analysis.FieldGrid;
import org.dronewatch.analysis.FieldSummary;
import org.dronewatch.analysis.HeightSummary;
import org.dronewatch.analysis.VisibleHeights;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Cause;
import org.dronewatch.world.World;

/** Maps of a site's coverage: the dominant cause at each height, and the least visible height. */
public final class FieldPictures {
    /** From light to dark, so that they keep their order in black and white; above the last one nothing is visible. */
    private static final Color LOWEST = new Color(0xfff3c4);

    private static final Color HIGHEST = new Color(0x2c4a86);
    private static final Color HIDDEN = new Color(0x2b2b2b);
    private static final double STRENGTH = 0.75;

    private final World world;
    private final List<Position> sensors;
    private final CoverageInputs inputs;

    /**
     * Maps of one site.
     *
     * @param sensors where they are, m
     * @param inputs what the coverage was asked for
     */
    public FieldPictures(World world, List<Position> sensors, CoverageInputs inputs) {
        this.world = world;
        this.sensors = List.copyOf(sensors);
        this.inputs = inputs;
    }

    /** The dominant causes at a height, given by its number. */
    MapSheet causes(FieldSummary summary, int height) {
        FieldCoverage coverage = summary.coverage();
        HeightSummary numbers = summary.heights().get(height);
        MapSheet sheet = new MapSheet(coverage.field().grid());
        sheet.drawMap(world, (column, row) -> fill(coverage, height, column, row), sensors);
        sheet.title(inputs.scene());
        sheet.line("drone '" + inputs.drone() + "' at " + metres(numbers.height()) + " above the ground,");
        sheet.line(inputs.heading().equals("inbound") ? "inbound;" : "on the " + inputs.heading() + " heading;");
        sheet.line("detection, or dominant cause of the miss:");
        sheet.space();
        entry(sheet, Cause.DETECTED, numbers);
        for (Map.Entry<Cause, Integer> cause : numbers.causes().entrySet()) {
            if (cause.getKey() != Cause.DETECTED) {
                entry(sheet, cause.getKey(), numbers);
            }
        }
        sheet.space();
        sheet.line("percentages of the known area");
        if (numbers.unknown() > 0) {
            sheet.entry(CauseFills.of(Cause.UNKNOWN), "unknown");
        }
        if (numbers.inside() > 0) {
            sheet.entry(CauseFills.INSIDE, "inside something solid");
        }
        sheet.line("cells of " + metres(coverage.field().grid().cell()));
        return sheet;
    }

    private static MapSheet.Fill fill(FieldCoverage coverage, int height, int column, int row) {
        if (coverage.field().isInside(height, column, row)) {
            return CauseFills.INSIDE;
        }
        return CauseFills.of(
                coverage.isUnknown(height, column, row) ? Cause.UNKNOWN : coverage.cause(height, column, row));
    }

    private static void entry(MapSheet sheet, Cause cause, HeightSummary numbers) {
        int cells = numbers.causes().getOrDefault(cause, 0);
        String share = numbers.known() == 0 ? "-" : CoverageTable.percent(cells, numbers.known());
        sheet.entry(CauseFills.of(cause), CoverageTable.name(cause) + ": " + share + (cells == 0 ? "" : " %"));
    }

    /** The least height at which any sensor has a free line of sight. */
    MapSheet visibleHeights(VisibleHeights visible) {
        FieldGrid grid = visible.grid();
        MapSheet sheet = new MapSheet(grid);
        sheet.drawMap(world, (column, row) -> fill(grid, visible.height(column, row)), sensors);
        sheet.title(inputs.scene());
        sheet.line("least height above the ground that");
        sheet.line("any sensor sees, by the line of sight alone,");
        sheet.line("whatever its range and field of view:");
        sheet.space();
        for (int i = 0; i < grid.heights().size(); i++) {
            String from = i == 0 ? "0" : Numbers.text(grid.heights().get(i - 1));
            double height = grid.heights().get(i);
            sheet.entry(fill(grid, height), from + " to " + metres(height));
        }
        sheet.entry(fill(grid, Double.NaN), "not up to there, or no ground");
        sheet.space();
        sheet.line("cells of " + metres(grid.cell()));
        return sheet;
    }

    private static MapSheet.Fill fill(FieldGrid grid, double height) {
        int last = grid.heights().size() - 1;
        for (int i = 0; i <= last; i++) {
            if (height <= grid.heights().get(i)) {
                Color colour = MapSheet.mixed(LOWEST, HIGHEST, last == 0 ? 0.0 : (double) i / last);
                return (u, v, ground) -> MapSheet.mixed(ground, colour, STRENGTH);
            }
        }
        return (u, v, ground) -> MapSheet.mixed(ground, HIDDEN, STRENGTH);
    }

    private static String metres(double length) {
        return String.format(Locale.ROOT, "%s m", Numbers.text(length));
    }
}
