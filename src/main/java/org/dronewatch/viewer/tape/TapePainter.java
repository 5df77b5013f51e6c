package org.dronewatch.viewer.tape;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.viewer.part.Scaled;
import org.jogamp.vecmath.Point2d;

/**
 * Paints the {@linkplain Tape measuring tape} over a picture of the site: solid as far as the line of sight is clear,
 * with a cross where it is blocked, and dashed beyond the cross.
 *
 * @param pixels returns the pixel at which a position is drawn; empty if it is outside the picture
 */
public record TapePainter(Function<Position, Optional<Point2d>> pixels) {
    /** Colours for all types of colour vision: Okabe and Ito, Color Universal Design, 2008. */
    private static final Color CLEAR = new Color(0x0072b2);

    private static final Color BLOCKED = new Color(0xd55e00);
    private static final Color HALO = Color.WHITE;
    private static final Color LABEL = new Color(0x20262e);

    /** Points of the line whose visibility is examined: in perspective, some of them may be behind the viewer. */
    private static final int PIECES = 64;

    private static final double WIDTH = 2.5;
    private static final double END = 4.5;

    /** Paints a tape; without a reading, as if its line of sight were clear. */
    public void paint(Graphics2D g, Tape tape, Optional<TapeReading> reading) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        Position from = tape.from().place();
        Position to = tape.to().place();
        Optional<Position> cross = reading.flatMap(TapeReading::blocked).map(found -> found.at());
        line(g, from, cross.orElse(to), CLEAR, false);
        cross.ifPresent(at -> line(g, at, to, BLOCKED, true));
        pixels.apply(from).ifPresent(at -> end(g, at, CLEAR));
        pixels.apply(to).ifPresent(at -> end(g, at, cross.isEmpty() ? CLEAR : BLOCKED));
        cross.flatMap(pixels).ifPresent(at -> cross(g, at));
        pixels.apply(from.plus(to.minus(from).times(0.5)))
                .ifPresent(at -> label(g, at, String.format(Locale.ROOT, "%.1f m", tape.distance())));
    }

    /** A straight line remains straight in perspective: it is drawn from its first to its last visible point. */
    private void line(Graphics2D g, Position from, Position to, Color colour, boolean dashed) {
        List<Point2d> visible = IntStream.rangeClosed(0, PIECES)
                .mapToObj(i -> pixels.apply(from.plus(to.minus(from).times(i / (double) PIECES))))
                .flatMap(Optional::stream)
                .toList();
        if (visible.isEmpty()) {
            return;
        }
        Point2d first = visible.get(0);
        Point2d last = visible.get(visible.size() - 1);
        Line2D path = new Line2D.Double(first.x, first.y, last.x, last.y);
        g.setStroke(new BasicStroke((float) scaled(WIDTH + 2.0)));
        g.setColor(HALO);
        g.draw(path);
        float dash = (float) scaled(7.0);
        float width = (float) scaled(WIDTH);
        g.setStroke(
                dashed
                        ? new BasicStroke(
                                width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1f, new float[] {dash, dash}, 0f)
                        : new BasicStroke(width));
        g.setColor(colour);
        g.draw(path);
    }

    private static void end(Graphics2D g, Point2d at, Color colour) {
        double radius = scaled(END);
        Ellipse2D disc = new Ellipse2D.Double(at.x - radius, at.y - radius, 2.0 * radius, 2.0 * radius);
        g.setColor(HALO);
        g.fill(disc);
        g.setColor(colour);
        g.setStroke(new BasicStroke((float) scaled(WIDTH)));
        g.draw(disc);
    }

    private static void cross(Graphics2D g, Point2d at) {
        double half = scaled(END + 2.0);
        Path2D cross = new Path2D.Double();
        cross.moveTo(at.x - half, at.y - half);
        cross.lineTo(at.x + half, at.y + half);
        cross.moveTo(at.x - half, at.y + half);
        cross.lineTo(at.x + half, at.y - half);
        g.setStroke(new BasicStroke((float) scaled(WIDTH + 2.5)));
        g.setColor(HALO);
        g.draw(cross);
        g.setStroke(new BasicStroke((float) scaled(WIDTH)));
        g.setColor(BLOCKED);
        g.draw(cross);
    }

    private static void label(Graphics2D g, Point2d at, String text) {
        g.setFont(Scaled.font(1.0));
        FontMetrics metrics = g.getFontMetrics();
        int pad = Scaled.px(4);
        int x = (int) at.x + Scaled.px(10);
        int y = (int) at.y - Scaled.px(10);
        g.setColor(LABEL);
        g.fillRoundRect(
                x - pad,
                y - metrics.getAscent() - pad / 2,
                metrics.stringWidth(text) + 2 * pad,
                metrics.getHeight() + pad,
                pad,
                pad);
        g.setColor(HALO);
        g.drawString(text, x, y);
    }

    private static double scaled(double pixels) {
        return pixels * Scaled.factor();
    }
}
