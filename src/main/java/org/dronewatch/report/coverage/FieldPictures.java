package org.dronewatch.report.coverage;

import java.awt.Color;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectableHeights;
import org.dronewatch.analysis.field.VisibleHeights;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.FieldSurvey;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.coverage.table.CoverageSite;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.sheet.ColourMix;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.report.sheet.ReliefShade;
import org.dronewatch.sensor.Cause;

/** Maps of a site's coverage: the dominant cause at each height, the least visible height, and the warning. */
final class FieldPictures {
    /** The colour of the line for the lowest height, on a pale map. */
    private static final Color NEAR_GROUND = new Color(0xd55e00);

    private static final Color HIGH_UP = new Color(0x0072b2);

    private static final String DETECTABLE = "min-height.png";
    private static final String VISIBLE = "visible-height.png";
    private static final String WARNING = "warning.png";

    private final int[] ground;
    private final List<Position> sensors;
    private final WarningMap warnings;
    private final List<String> credits;
    private final CoverageInputs inputs;

    /**
     * Maps of one site, whose ground is drawn on the {@link org.dronewatch.parallel.Workers} of the calling thread.
     *
     * @param inputs the inputs of the coverage
     * @param grid grid of the maps
     */
    FieldPictures(CoverageSite site, CoverageInputs inputs, FieldGrid grid) {
        this.ground = MapSheet.ground(site.stage().world(), grid);
        this.sensors = site.sensors();
        this.warnings = new WarningMap(site, inputs);
        this.credits = site.stage().credits();
        this.inputs = inputs;
    }

    /** The maps of what was found, by the names of their files, in the order in which a reader needs them. */
    Map<String, MapSheet> all(FieldSurvey survey) {
        Map<String, MapSheet> maps = new LinkedHashMap<>();
        FieldSummary summary = survey.summary();
        for (int height = 0; height < summary.heights().size(); height++) {
            maps.put(causeName(summary.heights().get(height).height()), causes(summary, height));
        }
        survey.detectable().ifPresent(found -> maps.put(DETECTABLE, detectableHeights(found)));
        survey.visible().ifPresent(found -> maps.put(VISIBLE, visibleHeights(found)));
        survey.warnings().ifPresent(found -> maps.put(WARNING, warnings.sheet(survey.grid(), ground, found)));
        return maps;
    }

    private static String causeName(double height) {
        return "cause-" + Numbers.text(height) + ".png";
    }

    private MapSheet causes(FieldSummary summary, int height) {
        MapSheet sheet = new MapSheet(summary.coverage().field().grid());
        CauseMap map = new CauseMap(summary, height, inputs);
        sheet.drawMap(ground, map::fill, sensors);
        sheet.credits(credits);
        sheet.title(inputs.scene());
        map.writeLegend(sheet);
        sheet.explainSensors();
        return sheet;
    }

    /** The least height at which any sensor has a clear line of sight. */
    MapSheet visibleHeights(VisibleHeights visible) {
        return heights(
                visible.grid(),
                visible::height,
                "The lowest height above the ground at which there is a clear line of sight to a sensor.",
                List.of(
                        "lowest height above the ground that",
                        "any sensor sees, by the line of sight alone,",
                        "whatever its range and field of view:"));
    }

    /** The least height at which a sensor detects the drone. */
    MapSheet detectableHeights(DetectableHeights detectable) {
        return heights(
                detectable.grid(),
                detectable::height,
                "The lowest height above the ground at which a sensor detects the drone.",
                List.of(
                        "lowest height above the ground at which",
                        "a sensor detects the drone '" + inputs.drone() + "',",
                        inputs.headingInWords()
                                + inputs.within()
                                        .map(time -> ", within " + inputs.timeInWords())
                                        .orElse("") + inputs.withProbability() + ":"));
    }

    /** A height for each column. */
    private interface Heights {
        double at(int column, int row);
    }

    private MapSheet heights(FieldGrid grid, Heights least, String caption, List<String> words) {
        MapSheet sheet = new MapSheet(grid);
        sheet.drawMap(
                ground,
                (column, row) -> grid.isOutside(column, row) ? CauseFills.OUTSIDE : fill(grid, least.at(column, row)),
                sensors);
        sheet.credits(credits);
        sheet.title(inputs.scene());
        words.forEach(sheet::line);
        sheet.space();
        double below = 0.0;
        for (double bound : HeightFills.bounds(grid)) {
            sheet.entry(HeightFills.of(grid, bound), Numbers.text(below) + " to " + metres(bound));
            below = bound;
        }
        sheet.entry(HeightFills.of(grid, Double.NaN), "none up to " + metres(below));
        if (Arrays.stream(ground).anyMatch(ReliefShade::isNothing)) {
            sheet.entry((u, v, any) -> fill(grid, Double.NaN).at(u, v, ReliefShade.NOTHING.getRGB()), "no ground");
        }
        if (grid.count(grid::isOutside) > 0) {
            sheet.entry(CauseFills.OUTSIDE, CellState.OUTSIDE.inWords(false));
        }
        sheet.space();
        sheet.line("cells of " + metres(grid.cell()));
        sheet.explainSensors();
        sheet.caption(caption);
        return sheet;
    }

    /** The fill of a least height, m; a pattern where there is no ground from which to measure it. */
    private static MapSheet.Fill fill(FieldGrid grid, double height) {
        MapSheet.Fill fill = HeightFills.of(grid, height);
        return Double.isNaN(height)
                ? (u, v, below) -> (ReliefShade.isNothing(below) ? CauseFills.of(Cause.UNKNOWN) : fill).at(u, v, below)
                : fill;
    }

    /** The colour of the line for a height, given by its index. */
    static Color ofHeight(int number, int heights) {
        return ColourMix.of(NEAR_GROUND, HIGH_UP, heights == 1 ? 0.0 : (double) number / (heights - 1));
    }

    /** A length with its unit. */
    static String metres(double length) {
        return String.format(Locale.ROOT, "%s m", Numbers.text(length));
    }
}
