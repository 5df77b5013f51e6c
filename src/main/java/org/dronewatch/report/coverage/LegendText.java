package org.dronewatch.report.coverage;

import java.awt.FontMetrics;
import java.util.List;
import org.dronewatch.render.Credits;

/** Text of a legend in lines that fit: names may be of any length. */
final class LegendText {
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

    /** A text in one line, without its middle if it is too long. */
    static String shortened(String text, FontMetrics metrics, int most) {
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
