package org.dronewatch.render;

import java.awt.FontMetrics;
import java.util.ArrayList;
import java.util.List;

/** The credits that the data of a site require, as lines of text in a picture. */
public final class Credits {
    private Credits() {}

    /**
     * A line for each credit, or several for a long one.
     *
     * @param most width of a line in pixels; only a single word may be wider
     */
    public static List<String> lines(List<String> credits, FontMetrics metrics, int most) {
        List<String> lines = new ArrayList<>();
        for (String credit : credits) {
            StringBuilder line = new StringBuilder();
            for (String word : credit.strip().split("\\s+")) {
                if (!line.isEmpty() && metrics.stringWidth(line + " " + word) > most) {
                    lines.add(line.toString());
                    line.setLength(0);
                }
                line.append(line.isEmpty() ? "" : " ").append(word);
            }
            lines.add(line.toString());
        }
        return lines;
    }
}
