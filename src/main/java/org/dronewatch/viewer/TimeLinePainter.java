package org.dronewatch.viewer;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Locale;
import javax.swing.UIManager;
import org.dronewatch.render.canvas.KindColours;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.DetectionIntervals;
import org.dronewatch.run.DetectionIntervals.Interval;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.run.RecordedRun;

/** Paints a run on a time line: the rows of its sensors, the axis and the time shown. */
final class TimeLinePainter {
    /** Labels of the axis are at least this far apart. */
    private static final int TICKS = 80;

    private final TimeLine line;
    private final RecordedRun run;
    private final Graphics2D g;

    TimeLinePainter(TimeLine line, RecordedRun run, Graphics2D g) {
        this.line = line;
        this.run = run;
        this.g = g;
    }

    /** The rows of sensors: bars while they detect a drone, and marks where they gain and lose one. */
    void paintRows(
            List<String> sensors, KindColours colours, DetectionIntervals intervals, List<DetectionEvent> events) {
        double height = line.rowHeight();
        double reached = line.xOf(run.reached());
        g.setColor(shade(24));
        g.fill(new Rectangle2D.Double(line.left(), TimeLine.GAP, reached - line.left(), height * sensors.size()));
        for (int row = 0; row < sensors.size(); row++) {
            String sensor = sensors.get(row);
            Color colour =
                    colours.of(run.info().settings().sensors().get(sensor).kind());
            for (Interval held : intervals.ofSensor(sensor, run.reached())) {
                bar(row, line.xOf(held.from()), line.xOf(held.to()), colour);
            }
            paintName(row, sensor);
            paintMarks(row, sensor, colour, events);
        }
    }

    private void paintName(int row, String sensor) {
        String text = line.label(sensor);
        FontMetrics metrics = g.getFontMetrics();
        g.setColor(shade(220));
        float x = line.left() - Scaled.px(TimeLine.MARGIN) / 2f - metrics.stringWidth(text);
        g.drawString(text, x, (float) (line.yOf(row) + metrics.getAscent()));
    }

    private void bar(int row, double from, double to, Color colour) {
        g.setColor(new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), 130));
        g.fill(new Rectangle2D.Double(from, line.yOf(row) + 1, Math.max(1.0, to - from), line.rowHeight() - 2));
    }

    private void paintMarks(int row, String sensor, Color colour, List<DetectionEvent> events) {
        double top = line.yOf(row) + 0.5;
        double bottom = top + line.rowHeight() - 1.0;
        for (DetectionEvent event : events) {
            if (!event.observation().sensor().equals(sensor)) {
                continue;
            }
            double x = line.xOf(event.observation().arrival());
            g.setColor(event.gained() ? colour : UIManager.getColor("Label.foreground"));
            if (event.gained()) {
                Path2D triangle = new Path2D.Double();
                triangle.moveTo(x, top);
                triangle.lineTo(x + Scaled.px(6), 0.5 * (top + bottom));
                triangle.lineTo(x, bottom);
                triangle.closePath();
                g.fill(triangle);
            } else {
                // On whole pixels: a thin stroke between two is only half as dark.
                g.fill(new Rectangle2D.Double(Math.round(x) - 1.0, top, 2, bottom - top));
            }
        }
    }

    private static Color shade(int alpha) {
        Color ink = UIManager.getColor("Label.foreground");
        return new Color(ink.getRed(), ink.getGreen(), ink.getBlue(), alpha);
    }

    /** The axis of times, from an upper edge on. */
    void paintAxis(int top) {
        FontMetrics metrics = g.getFontMetrics();
        double wanted = run.duration() * Scaled.px(TICKS) / Math.max(1, line.right() - line.left());
        double power = Math.pow(10.0, Math.floor(Math.log10(wanted)));
        double step = wanted <= power
                ? power
                : wanted <= 2 * power ? 2 * power : wanted <= 5 * power ? 5 * power : 10 * power;
        g.setColor(shade(220));
        for (int i = 0; i * step <= run.duration() * (1.0 + 1e-9); i++) {
            double x = line.xOf(i * step);
            g.fill(new Rectangle2D.Double(x - 0.5, top, 1, Scaled.px(4)));
            String text = String.format(Locale.ROOT, step < 1.0 ? "%.2g s" : "%.0f s", i * step);
            int left = (int) Math.max(
                    0, Math.min(line.getWidth() - metrics.stringWidth(text), x - 0.5 * metrics.stringWidth(text)));
            g.drawString(text, left, top + Scaled.px(4) + metrics.getAscent());
        }
    }

    /** The line at the time shown, down to the axis. */
    void paintNow(int axis, double time) {
        double x = line.xOf(time);
        double size = Scaled.px(5);
        double top = Math.max(0, axis - line.getVisibleRect().height);
        g.setColor(
                UIManager.getColor("Component.accentColor") == null
                        ? new Color(0x2675bf)
                        : UIManager.getColor("Component.accentColor"));
        g.fill(new Rectangle2D.Double(x - 1, 0, 2, axis + 4.0));
        Path2D head = new Path2D.Double();
        head.moveTo(x - size, top);
        head.lineTo(x + size, top);
        head.lineTo(x, top + 1.4 * size);
        head.closePath();
        g.fill(head);
    }
}
