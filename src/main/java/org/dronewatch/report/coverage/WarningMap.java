package org.dronewatch.report.coverage;

import java.awt.Color;
import java.util.Arrays;
import java.util.List;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.Warning;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.coverage.table.CoverageSite;
import org.dronewatch.report.coverage.table.WarningTable;
import org.dronewatch.report.sheet.ColourMix;
import org.dronewatch.report.sheet.LineLayer;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.report.sheet.ProtectedOutlines;
import org.dronewatch.report.sheet.ReliefShade;
import org.dronewatch.sensor.Cause;
import org.dronewatch.setting.In;

/**
 * The map of the warning times of straight inbound flights: where the flights begin and, in a line for each height,
 * where the drone is first detected.
 */
public final class WarningMap {
    private static final Color START = Color.GRAY;

    /** The side of a map of flights, as a multiple of the distance at which they begin. */
    private static final double FRAME = 2.1;

    private final CoverageSite site;
    private final CoverageInputs inputs;

    /** A map for a site. */
    public WarningMap(CoverageSite site, CoverageInputs inputs) {
        this.site = site;
        this.inputs = inputs;
    }

    /**
     * The sheet with a line for each height that shows where straight inbound flights are first detected; the legend
     * states the shortest warning time at each height.
     *
     * @param grid the grid of the other maps
     * @param ground the ground of that grid, as {@link MapSheet#ground} returns it
     */
    public MapSheet sheet(FieldGrid grid, int[] ground, InboundWarnings warnings) {
        FieldGrid shown = showsAll(grid, warnings) ? grid : around(warnings);
        MapSheet sheet = new MapSheet(shown);
        int[] below = shown.equals(grid) ? ground : MapSheet.ground(site.stage().world(), shown);
        sheet.drawMap(below, (column, row) -> WarningMap::pale, site.sensors());
        sheet.credits(site.stage().credits());
        sheet.title(inputs.scene());
        sheet.line("where the drone '" + inputs.drone() + "', flying straight in");
        sheet.line("to " + (warnings.isZone() ? "the protected zone" : "the centroid of the sensors"));
        sheet.line("from up to " + FieldPictures.metres(warnings.reach()) + " away, is first detected"
                + inputs.withProbability() + ";");
        if (inputs.within().isPresent()) {
            sheet.line("it counts as detected " + inputs.timeInWords() + " after it");
            sheet.line("reaches the first place where a sensor covers it;");
        }
        sheet.line("shortest warning before it arrives:");
        sheet.space();
        sheet.outline(ProtectedOutlines.circle(warnings.target(), warnings.reach()), START);
        double[] heights = WarningTable.heights(warnings);
        for (int i = 0; i < heights.length; i++) {
            double height = heights[i];
            List<Warning> its = warnings.all().stream()
                    .filter(one -> one.height() == height)
                    .toList();
            LineLayer layer = new LineLayer(i, heights.length, FieldPictures.ofHeight(i, heights.length));
            sheet.outline(outline(warnings, its), layer);
            sheet.sample(layer, FieldPictures.metres(height) + ": " + WarningTable.leastAndOthers(its));
        }
        for (List<Position> zone : ProtectedOutlines.of(site.stage().protection())) {
            sheet.outline(zone, Color.BLACK);
        }
        sheet.sample(START, "where the flights begin");
        if (warnings.isZone()) {
            sheet.sample(Color.BLACK, "protected zone");
        }
        if (Arrays.stream(below).anyMatch(ReliefShade::isNothing)) {
            sheet.entry((u, v, any) -> pale(u, v, ReliefShade.NOTHING.getRGB()), "height of the ground unknown");
        }
        sheet.explainSensors();
        sheet.space();
        sheet.line("points at " + InboundWarnings.BEARINGS + " bearings, joined by lines;");
        sheet.line("where a line meets the zone, or the centroid:");
        sheet.line("no detection before the drone arrives");
        sheet.caption("Where a drone that flies in straight is first detected, by height.");
        return sheet;
    }

    /** The ground below the lines; a pattern where nothing is known of it. */
    private static int pale(int u, int v, int ground) {
        return ReliefShade.isNothing(ground)
                ? CauseFills.of(Cause.UNKNOWN).at(u, v, ground)
                : ColourMix.of(ground, Color.WHITE, 0.35);
    }

    /** Whether all flights begin on the map of a grid: their target may not be its centre, or they begin beyond it. */
    private static boolean showsAll(FieldGrid grid, InboundWarnings warnings) {
        Position target = warnings.target();
        double aside = Math.max(Math.abs(target.x() - grid.east()), Math.abs(target.y() - grid.north()));
        return grid.area().isEmpty() && aside + warnings.reach() <= 0.5 * grid.columns() * grid.cell();
    }

    private static FieldGrid around(InboundWarnings warnings) {
        double side = Math.min(FRAME * warnings.reach(), In.FARTHEST);
        Position middle = warnings.target();
        return new FieldGrid(middle.x(), middle.y(), side, side, FieldGrid.HEIGHTS);
    }

    private static List<Position> outline(InboundWarnings warnings, List<Warning> bearings) {
        return bearings.stream()
                .map(one -> ProtectedOutlines.around(
                        warnings.target(), one.bearing(), one.range().orElse(one.arrival())))
                .toList();
    }
}
