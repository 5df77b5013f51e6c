package org.dronewatch.render.canvas;

import java.awt.Color;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.geometry.Position;

/**
 * Lines through a site, such as routes, which are drawn in place of the paths of drones.
 *
 * @param lines the lines
 * @param legend the colours, by their meanings
 */
public record SiteLines(List<Line> lines, Map<String, Color> legend) {
    /** No lines. */
    public static final SiteLines NONE = new SiteLines(List.of(), Map.of());

    /** Copies the list and the map, whose order is kept. */
    public SiteLines {
        lines = List.copyOf(lines);
        legend = Collections.unmodifiableMap(new LinkedHashMap<>(legend));
    }

    /**
     * A line.
     *
     * @param words label written at the beginning of the line
     * @param pieces pieces of the line from its beginning to its end, at least one
     */
    public record Line(String words, List<Piece> pieces) {
        /** Copies the list. */
        public Line {
            pieces = List.copyOf(pieces);
        }
    }

    /**
     * A piece of a line.
     *
     * @param points two or more, m
     * @param colour colour of the piece
     * @param width width of the piece, in pixels of a screen of normal density
     */
    public record Piece(List<Position> points, Color colour, double width) {
        /** Copies the list. */
        public Piece {
            points = List.copyOf(points);
        }
    }

    /** Whether there are no lines. */
    public boolean isEmpty() {
        return lines.isEmpty();
    }

    /** Writes the label of each line at its beginning. */
    public void write(Symbols symbols) {
        lines.forEach(line -> symbols.note(line.pieces().get(0).points().get(0), line.words()));
    }
}
