package org.dronewatch.report.sheet;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.util.List;
import org.dronewatch.render.Credits;

/** Fits the text of a legend into lines, since names may be of any length. */
public final class LegendText {
    private static final String GAP = "\u2026";

    private LegendText() {}

    /**
     * Lines between words; a single word that is too long is shortened in its middle.
     *
     * @param most width of a line in pixels
     */
    static List<String> lines(String text, FontMetrics metrics, int most) {
        return Credits.lines(List.of(text), metrics, most).stream()
                .map(line -> shortened(line, metrics, most))
                .toList();
    }

    /**
     * Draws a text in as many lines as it needs.
     *
     * @param top y coordinate of the first line, pixels
     * @param most width of a line in pixels
     * @return the y coordinate of the last line, pixels
     */
    static int draw(Graphics2D g, String text, int x, int top, int most) {
        FontMetrics metrics = g.getFontMetrics();
        List<String> lines = lines(text, metrics, most);
        for (int i = 0; i < lines.size(); i++) {
            g.drawString(lines.get(i), x, top + i * metrics.getHeight());
        }
        return top + Math.max(0, lines.size() - 1) * metrics.getHeight();
    }

    /**
     * A text in one line, without its middle if it is too long.
     *
     * @param most width of the line in pixels
     */
    public static String shortened(String text, FontMetrics metrics, int most) {
        int[] points = text.codePoints().toArray();
        int kept = points.length;
        String shown = text;
        while (kept > 2 && metrics.stringWidth(shown) > most) {
            kept--;
            int tail = kept / 2;
            int head = kept - tail;
            shown = new String(points, 0, head) + GAP + new String(points, points.length - tail, tail);
        }
        return shown;
    }
}
