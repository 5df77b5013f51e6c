package org.dronewatch.report.sheet;

import java.awt.BasicStroke;
import java.awt.Color;

/**
 * The style of one of several lines that may coincide, drawn in their order: each line is narrower than the lines below
 * it, so that all of them can be seen and distinguished even in black and white.
 *
 * @param number number of the line, from 0 for the lowest
 * @param of number of lines
 * @param colour colour of the line
 */
public record LineLayer(int number, int of, Color colour) {
    /** What separates a line from those below it. */
    static final Color EDGE = Color.WHITE;

    private static final float EDGE_WIDTH = 0.5f;

    private static final float NARROWEST = 2f;

    /** By how much a line is wider than the one above it, pixels, unless the lowest would become too wide. */
    private static final float STEP = 4f;

    /** By how much the lowest line is wider than the highest at most, pixels. */
    private static final float MOST = 16f;

    BasicStroke stroke() {
        return solid(width());
    }

    BasicStroke edge() {
        return solid(width() + 2f * EDGE_WIDTH);
    }

    private float width() {
        return NARROWEST + (of - 1 - number) * Math.min(STEP, MOST / Math.max(1, of - 1));
    }

    private static BasicStroke solid(float width) {
        return new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND);
    }
}
