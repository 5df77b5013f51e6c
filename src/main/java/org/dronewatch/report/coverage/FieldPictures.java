package org.dronewatch.report.coverage;

import java.awt.Color;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;
import org.dronewatch.analysis.field.DetectableHeights;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.analysis.field.FieldSummary;
import org.dronewatch.analysis.field.FieldSurvey;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.VisibleHeights;
import org.dronewatch.analysis.field.Warning;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.Numbers;
import org.dronewatch.world.World;

/** Maps of a site's coverage: the dominant cause at each height, the least visible height, and the warning. */
final class FieldPictures {
    /** Lines on a pale map. */
    private static final Color NEAR_GROUND = new Color(0xd55e00);

    /** Corners of the outline of a sphere. */
    private static final int CIRCLE = 72;

    private static final Color HIGH_UP = new Color(0x0072b2);

    private static final String DETECTABLE = "min-height.png";
    private static final String VISIBLE = "visible-height.png";
    private static final String WARNING = "warning.png";

    private final World world;
    private final int[] ground;
    private final List<Position> sensors;
    private final Protection protection;
    private final List<String> credits;
    private final CoverageInputs inputs;

    /**
     * Maps of one site, whose ground is drawn on the {@link org.dronewatch.parallel.Workers} of the calling thread.
     *
     * @param inputs what the coverage was asked for
     * @param grid of the maps
     */
    FieldPictures(CoverageSite site, CoverageInputs inputs, FieldGrid grid) {
        this.world = site.stage().world();
        this.ground = MapSheet.ground(world, grid);
        this.sensors = site.sensors();
        this.protection = site.stage().protection();
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
        survey.warnings().ifPresent(found -> maps.put(WARNING, warnings(survey.grid(), found)));
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
        return sheet;
    }

    /** The least height at which any sensor has a free line of sight. */
    MapSheet visibleHeights(VisibleHeights visible) {
        return heights(
                visible.grid(),
                visible::height,
                "The least height above the ground from which there is a free line of sight to a sensor.",
                List.of(
                        "least height above the ground that",
                        "any sensor sees, by the line of sight alone,",
                        "whatever its range and field of view:"));
    }

    /** The least height at which a sensor detects the drone. */
    MapSheet detectableHeights(DetectableHeights detectable) {
        return heights(
                detectable.grid(),
                detectable::height,
                "The least height above the ground at which a sensor detects the drone.",
                List.of(
                        "least height above the ground at which",
                        "a sensor detects the drone '" + inputs.drone() + "',",
                        inputs.headingInWords()
                                + inputs.within()
                                        .map(time -> ", within " + inputs.timeInWords())
                                        .orElse("") + ":"));
    }

    /** A height for each column. */
    private interface Heights {
        double at(int column, int row);
    }

    private MapSheet heights(FieldGrid grid, Heights least, String caption, List<String> words) {
        MapSheet sheet = new MapSheet(grid);
        sheet.drawMap(
                ground,
                (column, row) ->
                        grid.isOutside(column, row) ? CauseFills.OUTSIDE : HeightFills.of(grid, least.at(column, row)),
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
        sheet.entry(HeightFills.of(grid, Double.NaN), "not up to that height, or no ground");
        sheet.space();
        sheet.line("cells of " + metres(grid.cell()));
        sheet.caption(caption);
        return sheet;
    }

    /**
     * Where straight inbound flights are first detected, a line for each height, and where they must be detected for
     * the response to be in time.
     */
    MapSheet warnings(FieldGrid grid, InboundWarnings warnings) {
        FieldGrid shown = grid.area().isEmpty() ? grid : around(warnings);
        MapSheet sheet = new MapSheet(shown);
        sheet.drawMap(
                shown.equals(grid) ? ground : MapSheet.ground(world, shown),
                (column, row) -> (u, v, ground) -> MapSheet.mixed(ground, Color.WHITE, 0.35),
                sensors);
        sheet.credits(credits);
        sheet.title(inputs.scene());
        sheet.line("where a drone '" + inputs.drone() + "' that flies in straight");
        sheet.line("to " + (warnings.isZone() ? "the protected zone" : "the middle of the sensors"));
        sheet.line("is first detected, from up to " + metres(warnings.reach()) + ";");
        if (inputs.within().isPresent()) {
            sheet.line(inputs.timeInWords() + " after the first place where");
            sheet.line("a sensor covers it within this time;");
        }
        sheet.line("least warning until it arrives:");
        sheet.space();
        double[] heights = WarningTable.heights(warnings);
        for (int i = 0; i < heights.length; i++) {
            double height = heights[i];
            List<Warning> its = warnings.all().stream()
                    .filter(one -> one.height() == height)
                    .toList();
            Color colour = ofHeight(i, heights.length);
            sheet.outline(outline(warnings, its), colour, i + 1);
            sheet.sample(colour, i + 1, metres(height) + ": least " + WarningTable.least(its));
        }
        for (List<Position> zone : zones()) {
            sheet.outline(zone, Color.BLACK, 0);
        }
        if (warnings.isZone()) {
            sheet.sample(Color.BLACK, 0, "protected zone");
        }
        sheet.space();
        sheet.line("where a line meets the zone, or the middle:");
        sheet.line("no detection before the drone arrives");
        sheet.caption("Where a drone that flies in straight is first detected, by height.");
        return sheet;
    }

    /** The colour of a line for a height, given by its number. */
    static Color ofHeight(int number, int heights) {
        return MapSheet.mixed(NEAR_GROUND, HIGH_UP, heights == 1 ? 0.0 : (double) number / (heights - 1));
    }

    /** Flights to an area begin far outside it. */
    private static FieldGrid around(InboundWarnings warnings) {
        double side = 2.0 * warnings.reach();
        Position middle = warnings.target();
        return new FieldGrid(middle.x(), middle.y(), side, side, FieldGrid.HEIGHTS);
    }

    private static List<Position> outline(InboundWarnings warnings, List<Warning> bearings) {
        return bearings.stream()
                .map(one -> around(warnings.target(), one.bearing(), one.range().orElse(one.arrival())))
                .toList();
    }

    private static Position around(Position middle, double bearing, double distance) {
        return middle.plus(new Position(distance * Math.sin(bearing), distance * Math.cos(bearing), 0.0));
    }

    /** The outlines of the protected zones in plan view. */
    private List<List<Position>> zones() {
        List<List<Position>> outlines = new ArrayList<>();
        protection
                .zone()
                .ifPresent(ball -> outlines.add(IntStream.range(0, CIRCLE)
                        .mapToObj(i -> around(ball.centre(), 2.0 * Math.PI * i / CIRCLE, ball.radius()))
                        .toList()));
        protection
                .areas()
                .forEach(area -> outlines.add(area.outline().stream()
                        .map(corner -> new Position(corner.x(), corner.y(), 0.0))
                        .toList()));
        return outlines;
    }

    private static String metres(double length) {
        return String.format(Locale.ROOT, "%s m", Numbers.text(length));
    }
}
