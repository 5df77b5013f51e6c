package org.dronewatch.report.coverage;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import org.dronewatch.report.Numbers;

/** The scale and the arrow to the north on a square map. */
final class MapFrame {
    private static final int MARGIN = 24;
    private static final Color PALE = new Color(255, 255, 255, 200);
    private static final Font LETTER = new Font(Font.SANS_SERIF, Font.BOLD, 19);
    private static final Font TEXT = new Font(Font.SANS_SERIF, Font.PLAIN, 15);

    private MapFrame() {}

    /**
     * Draws them: a bar of 1, 2 or 5 times a power of ten, about a fifth of the map; north is up.
     *
     * @param size of the map, pixels
     * @param side length of its side, m
     */
    static void draw(Graphics2D g, int size, double side) {
        double wanted = 0.2 * side;
        double power = Math.pow(10.0, Math.floor(Math.log10(wanted)));
        double length = wanted >= 5 * power ? 5 * power : wanted >= 2 * power ? 2 * power : power;
        int pixels = (int) Math.round(length / side * size);
        int y = size - MARGIN;
        g.setColor(PALE);
        g.fillRect(MARGIN - 12, y - 34, pixels + 24, 46);
        g.setColor(Color.BLACK);
        g.setStroke(new BasicStroke(3f));
        g.drawLine(MARGIN, y, MARGIN + pixels, y);
        g.setFont(TEXT);
        g.drawString(Numbers.text(length) + " m", MARGIN, y - 10);
        g.setColor(PALE);
        g.fillRect(size - 58, 12, 44, 66);
        g.setColor(Color.BLACK);
        g.fillPolygon(new int[] {size - 36, size - 46, size - 26}, new int[] {18, 46, 46}, 3);
        g.setFont(LETTER);
        g.drawString("N", size - 43, 70);
    }
}
