package org.dronewatch.report.sheet;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.report.file.Numbers;

/** The scale bar and the north arrow on a square map. */
final class MapFrame {
    private static final int MARGIN = 24;
    private static final int GAP = 4;
    private static final Color PALE = new Color(255, 255, 255, 200);
    private static final Font LETTER = new Font(Font.SANS_SERIF, Font.BOLD, 19);
    private static final Font TEXT = new Font(Font.SANS_SERIF, Font.PLAIN, 15);

    private MapFrame() {}

    /**
     * Draws the scale bar, of 1, 2 or 5 times a power of ten and about a fifth of the map, and the north arrow; north
     * is up.
     *
     * @param size of the map, pixels
     * @param side length of the map's side, m
     */
    static void draw(Graphics2D g, int size, double side) {
        double length = length(side);
        int pixels = (int) Math.round(length / side * size);
        int y = size - MARGIN;
        g.setColor(PALE);
        g.fill(scale(size, side));
        g.setColor(Color.BLACK);
        g.setStroke(new BasicStroke(3f));
        g.drawLine(MARGIN, y, MARGIN + pixels, y);
        g.setFont(TEXT);
        g.drawString(Numbers.text(length) + " m", MARGIN, y - 10);
        g.setColor(PALE);
        g.fill(arrow(size));
        g.setColor(Color.BLACK);
        g.fillPolygon(new int[] {size - 36, size - 46, size - 26}, new int[] {18, 46, 46}, 3);
        g.setFont(LETTER);
        g.drawString("N", size - 43, 70);
    }

    private static double length(double side) {
        double wanted = 0.2 * side;
        double power = Math.pow(10.0, Math.floor(Math.log10(wanted)));
        return wanted >= 5 * power ? 5 * power : wanted >= 2 * power ? 2 * power : power;
    }

    private static Rectangle scale(int size, double side) {
        int pixels = (int) Math.round(length(side) / side * size);
        return new Rectangle(MARGIN - 12, size - MARGIN - 34, pixels + 24, 46);
    }

    private static Rectangle arrow(int size) {
        return new Rectangle(size - 58, 12, 44, 66);
    }

    /**
     * Where a label has to be to cover neither of them: as near as possible to where it should be.
     *
     * @param label rectangle of the label on the map, pixels
     * @param size of the map, pixels
     * @param side side of the mapped square, m
     */
    static Rectangle beside(Rectangle label, int size, double side) {
        Rectangle moved = label;
        for (Rectangle taken : List.of(arrow(size), scale(size, side))) {
            if (moved.intersects(taken)) {
                moved = beside(moved, taken, new Rectangle(size, size));
            }
        }
        return moved;
    }

    private static Rectangle beside(Rectangle label, Rectangle taken, Rectangle map) {
        return Stream.of(
                        new Rectangle(taken.x - GAP - label.width, label.y, label.width, label.height),
                        new Rectangle(taken.x + taken.width + GAP, label.y, label.width, label.height),
                        new Rectangle(label.x, taken.y - GAP - label.height, label.width, label.height),
                        new Rectangle(label.x, taken.y + taken.height + GAP, label.width, label.height))
                .filter(map::contains)
                .min(Comparator.comparingDouble(place -> place.getLocation().distance(label.getLocation())))
                .orElse(label);
    }
}
