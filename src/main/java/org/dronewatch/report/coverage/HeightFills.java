package org.dronewatch.report.coverage;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.report.sheet.ColourMix;
import org.dronewatch.report.sheet.MapSheet;

/**
 * The appearance of heights on a map: colours from light to dark, which keep their order in black and white, and
 * hatching where there is no such height.
 */
final class HeightFills {
    private static final Color LOWEST = new Color(0xfff3c4);
    private static final Color HIGHEST = new Color(0x2c4a86);
    private static final Color NONE = new Color(0x2b2b2b);

    /** Lines that distinguish "none" from the highest class in black and white. */
    private static final Color LINE = new Color(0xb8b8b8);

    private static final int PERIOD = 12;

    /** Most of a colour is that of its class: shades of the ground must not look like the class beside it. */
    private static final double STRENGTH = 0.92;

    private static final double LOWEST_BOUND = 2.5;

    private HeightFills() {}

    /** The fill of a height, m; NaN where there is none up to the top of the grid. */
    static MapSheet.Fill of(FieldGrid grid, double height) {
        List<Double> bounds = bounds(grid);
        int last = bounds.size() - 1;
        for (int i = 0; i <= last; i++) {
            if (height <= bounds.get(i)) {
                Color colour = ColourMix.of(LOWEST, HIGHEST, last == 0 ? 0.0 : (double) i / last);
                return (u, v, ground) -> ColourMix.of(ground, colour, STRENGTH);
            }
        }
        return (u, v, ground) -> ColourMix.of(ground, isLine(u, v) ? LINE : NONE, STRENGTH);
    }

    private static boolean isLine(int u, int v) {
        return (u + v + PERIOD / 2) % PERIOD < 2;
    }

    /** Upper bounds of the classes of height, m: each is twice the one below, and the last is the top of the grid. */
    static List<Double> bounds(FieldGrid grid) {
        double top = grid.heights().get(grid.heights().size() - 1);
        List<Double> bounds = new ArrayList<>();
        for (double bound = LOWEST_BOUND; bound < top; bound *= 2.0) {
            bounds.add(bound);
        }
        bounds.add(top);
        return bounds;
    }
}
