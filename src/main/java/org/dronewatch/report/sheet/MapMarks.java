package org.dronewatch.report.sheet;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;

/** The lines and marks of maps. */
final class MapMarks {
    static final BasicStroke SOLID = new BasicStroke(3f);

    static final BasicStroke DASHES =
            new BasicStroke(2.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1f, new float[] {4f, 4f}, 0f);

    /** Half a side of a square, pixels. */
    private static final int SQUARE = 5;

    private MapMarks() {}

    /** A white square with a black edge. */
    static void square(Graphics2D g, int u, int v) {
        g.setColor(Color.WHITE);
        g.fillRect(u - SQUARE, v - SQUARE, 2 * SQUARE, 2 * SQUARE);
        g.setColor(Color.BLACK);
        g.setStroke(new BasicStroke(2f));
        g.drawRect(u - SQUARE, v - SQUARE, 2 * SQUARE, 2 * SQUARE);
    }

    /** A black dot with a white edge. */
    static void dot(Graphics2D g, int u, int v) {
        g.setColor(Color.WHITE);
        g.fillOval(u - 6, v - 6, 12, 12);
        g.setColor(Color.BLACK);
        g.fillOval(u - 4, v - 4, 8, 8);
    }
}
