package org.dronewatch.report.route;

import java.awt.Color;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.sheet.ColourMix;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.report.sheet.ProtectedOutlines;
import org.dronewatch.route.search.RouteGrid;
import org.dronewatch.route.search.TimeToGo;
import org.dronewatch.run.Stage;

/**
 * The map of the time that a drone needs to the end of a route, from light where it is long to dark where it is short,
 * so that the classes keep their order in black and white and for the colour-blind; and the line within which an alert
 * comes too late for the response.
 */
final class TimeToGoPicture {
    /** Like ColorBrewer's YlGnBu (C. A. Brewer, colorbrewer2.org), for any colour vision. */
    private static final Color LONG = new Color(0xffffcc);

    private static final Color MEDIUM = new Color(0x41b6c4);
    private static final Color SHORT = new Color(0x253494);
    private static final Color NOWHERE = new Color(0x2b2b2b);
    private static final Color LINE = new Color(0xd7191c);
    private static final Color ZONE = Color.BLACK;

    /** Most of a colour is that of its class: shades of the ground must not look like the class beside it. */
    private static final double STRENGTH = 0.85;

    /** Width of the line, pixels. */
    private static final double WIDTH = 5.0;

    private static final int MOST_CLASSES = 8;
    private static final List<Double> STEPS =
            List.of(1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1200.0);

    private final Stage stage;
    private final RouteInputs inputs;
    private final RouteGrid grid;

    /** The times at the nodes, by row from the south, then by column, s; NaN where no route leads to the end. */
    private final double[] times;

    private final double step;
    private final int classes;

    TimeToGoPicture(Stage stage, RouteInputs inputs, TimeToGo times) {
        this.stage = stage;
        this.inputs = inputs;
        this.grid = times.grid();
        this.times = IntStream.range(0, grid.columns() * grid.rows())
                .mapToDouble(node ->
                        times.at(node % grid.columns(), node / grid.columns()).orElse(Double.NaN))
                .toArray();
        double longest = Arrays.stream(this.times)
                .filter(time -> !Double.isNaN(time))
                .max()
                .orElse(0.0);
        this.step = STEPS.stream()
                .filter(one -> longest / one <= MOST_CLASSES)
                .findFirst()
                .orElse(Math.ceil(longest / MOST_CLASSES));
        this.classes = Math.max(1, (int) Math.ceil(longest / step));
    }

    /**
     * The map.
     *
     * @param ground as {@link MapSheet#ground} gives it
     */
    MapSheet sheet(int[] ground) {
        MapSheet sheet = new MapSheet(inputs.grid());
        sheet.drawMap(ground, (column, row) -> this::colour, inputs.sensors());
        for (List<Position> zone : ProtectedOutlines.of(stage.protection())) {
            sheet.outline(zone, ZONE);
        }
        sheet.title(inputs.scene());
        sheet.line("shortest time that the drone '" + inputs.drone() + "'");
        sheet.line("needs to reach " + inputs.targetInWords() + ",");
        sheet.line("from any height:");
        sheet.space();
        for (int number = classes - 1; number >= 0; number--) {
            Color colour = ofClass(number);
            sheet.entry(
                    (u, v, below) -> ColourMix.of(below, colour, STRENGTH),
                    Numbers.text(number * step) + " to " + Numbers.text((number + 1) * step) + " s");
        }
        if (Arrays.stream(times).anyMatch(Double::isNaN)) {
            sheet.entry((u, v, below) -> ColourMix.of(below, NOWHERE, STRENGTH), "no route from here");
        }
        sheet.space();
        if (inputs.response() > 0.0) {
            sheet.sample(LINE, (float) WIDTH, "response of " + Numbers.text(inputs.response()) + " s: inside this");
            sheet.line("line, an alert comes too late");
        }
        if (!stage.protection().isEmpty()) {
            sheet.sample(ZONE, "protected zone");
        }
        sheet.credits(stage.credits());
        sheet.caption("The time that the drone needs to reach " + inputs.targetInWords() + " by the fastest route"
                + (inputs.response() > 0.0
                        ? "; once it is inside the red line, an alert comes too late for the response."
                        : "; an alert must precede its arrival by at least the response time."));
        return sheet;
    }

    private Color ofClass(int number) {
        double part = classes == 1 ? 1.0 : (double) number / (classes - 1);
        return part < 0.5 ? ColourMix.of(SHORT, MEDIUM, 2.0 * part) : ColourMix.of(MEDIUM, LONG, 2.0 * part - 1.0);
    }

    private int colour(int u, int v, int ground) {
        double time = at(u, v);
        if (Double.isNaN(time)) {
            return ColourMix.of(ground, NOWHERE, STRENGTH);
        }
        // Where time changes evenly, its difference divided by the slope is the distance from the line in pixels.
        double slope = Math.hypot(at(u + 1, v) - time, at(u, v + 1) - time);
        double response = inputs.response();
        if (response > 0.0 && Math.abs(time - response) <= 0.5 * WIDTH * slope) {
            return LINE.getRGB();
        }
        int number = Math.max(0, Math.min(classes - 1, (int) (time / step)));
        return ColourMix.of(ground, ofClass(number), STRENGTH);
    }

    /** The time at a pixel of the map, interpolated between nodes, s; NaN where no route leads to the end. */
    private double at(int u, int v) {
        double column = clamp((u + 0.5) * grid.columns() / MapSheet.MAP - 0.5, grid.columns());
        double row = clamp((MapSheet.MAP - v - 0.5) * grid.rows() / MapSheet.MAP - 0.5, grid.rows());
        int left = Math.min((int) column, grid.columns() - 2);
        int below = Math.min((int) row, grid.rows() - 2);
        double right = column - left;
        double up = row - below;
        return (1.0 - up) * ((1.0 - right) * node(left, below) + right * node(left + 1, below))
                + up * ((1.0 - right) * node(left, below + 1) + right * node(left + 1, below + 1));
    }

    private static double clamp(double index, int count) {
        return Math.max(0.0, Math.min(count - 1.0, index));
    }

    private double node(int column, int row) {
        return times[row * grid.columns() + column];
    }
}
