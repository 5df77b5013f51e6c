package org.dronewatch.viewer;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JViewport;
import javax.swing.Scrollable;
import javax.swing.SwingConstants;
import javax.swing.UIManager;
import org.dronewatch.render.KindColours;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.DetectionIntervals;
import org.dronewatch.run.DetectionIntervals.Interval;

/**
 * A run from its start to its end: a row for each sensor, with its name on the left, a bar while it detects a drone, a
 * triangle where it gains one and a stroke where it loses it; the part not simulated yet is paler. A click jumps to a
 * time. Rows keep a legible height: where there are too many, they scroll.
 */
final class TimeLine extends JPanel implements Scrollable {
    private static final long serialVersionUID = 1L;
    private static final int MARGIN = 10;
    private static final int GAP = 3;
    private static final int WANTED_WIDTH = 600;
    private static final int LOWEST = 64;
    private static final int HIGHEST = 230;
    private static final int NEAR = 6;

    /** The largest fraction of the window that it takes before its rows scroll. */
    private static final double MOST_OF_WINDOW = 0.28;

    private static final double NAME_FONT = 0.9;

    /** Names take at most this fraction of the width. */
    private static final double NAMES = 0.25;

    /** Labels of the axis are at least this far apart. */
    private static final int TICKS = 80;

    private final transient Playback playback;
    private final transient List<DetectionEvent> events = new ArrayList<>();
    private transient DetectionIntervals intervals = new DetectionIntervals();
    private transient RecordedRun run;
    private transient List<String> sensors = List.of();
    private transient KindColours colours;

    TimeLine(Playback playback) {
        this.playback = playback;
        setMinimumSize(Scaled.size(200, LOWEST));
        setToolTipText("");
        getAccessibleContext().setAccessibleName("timeline");
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                jump(e.getX());
            }

            @Override
            public void mouseDragged(MouseEvent e) {
                jump(e.getX());
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
    }

    /** This time line in a pane that scrolls its rows and keeps its axis in sight. */
    JScrollPane scrolling() {
        JScrollPane pane =
                new JScrollPane(this, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        // The axis is painted at the lower edge of what is in sight: copying what was painted would smear it.
        pane.getViewport().setScrollMode(JViewport.SIMPLE_SCROLL_MODE);
        pane.setBorder(null);
        return pane;
    }

    private FontMetrics nameMetrics() {
        return getFontMetrics(Scaled.font(NAME_FONT));
    }

    private int axisHeight() {
        return nameMetrics().getHeight() + Scaled.px(6);
    }

    /** Height of a row: that of a name. */
    double rowHeight() {
        return nameMetrics().getHeight();
    }

    /** As high as its rows. */
    @Override
    public Dimension getPreferredSize() {
        int rows = (int) Math.ceil(sensors.size() * rowHeight());
        return new Dimension(Scaled.px(WANTED_WIDTH), Math.max(Scaled.px(LOWEST), axisHeight() + 2 * GAP + rows));
    }

    /** As high as its rows, but no more than a part of the window. */
    @Override
    public Dimension getPreferredScrollableViewportSize() {
        int most = getTopLevelAncestor() == null
                ? Scaled.px(HIGHEST)
                : Math.min(Scaled.px(HIGHEST), (int)
                        (MOST_OF_WINDOW * getTopLevelAncestor().getHeight()));
        Dimension all = getPreferredSize();
        return new Dimension(all.width, Math.min(most, all.height));
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return (int) rowHeight();
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return orientation == SwingConstants.VERTICAL ? visible.height / 2 : visible.width;
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return getParent() instanceof JViewport viewport && viewport.getHeight() > getPreferredSize().height;
    }

    private void jump(int x) {
        if (run != null) {
            playback.jump(timeAt(x));
        }
    }

    /** Appends new events. */
    void update() {
        if (playback.run() != run) {
            run = playback.run();
            events.clear();
            intervals = new DetectionIntervals();
            sensors = run == null
                    ? List.of()
                    : List.copyOf(run.info().settings().sensors().keySet());
            revalidate();
            colours = run == null
                    ? null
                    : KindColours.of(run.info().settings().sensors().values());
        }
        if (run != null) {
            List<DetectionEvent> next = run.eventsFrom(events.size());
            events.addAll(next);
            next.forEach(intervals::add);
        }
        repaint();
    }

    /** Where times begin: right of the names, which take as much room as the longest, within limits. */
    int left() {
        FontMetrics metrics = nameMetrics();
        int longest = sensors.stream().mapToInt(metrics::stringWidth).max().orElse(0);
        return Scaled.px(MARGIN) + Math.min(longest, (int) (NAMES * getWidth())) + Scaled.px(MARGIN);
    }

    private int right() {
        return getWidth() - Scaled.px(MARGIN);
    }

    private double timeAt(int x) {
        return (x - left()) / (double) Math.max(1, right() - left()) * run.duration();
    }

    /** Where a time is, in pixels from the left. */
    double xOf(double time) {
        return left() + time / run.duration() * (right() - left());
    }

    /** The upper edge of a sensor's row. */
    double yOf(int row) {
        return GAP + row * rowHeight();
    }

    /** A sensor's name as it is written: its beginning and an ellipsis where there is no room for all of it. */
    String label(String sensor) {
        FontMetrics metrics = nameMetrics();
        int room = left() - 2 * Scaled.px(MARGIN);
        if (metrics.stringWidth(sensor) <= room) {
            return sensor;
        }
        String text = sensor;
        while (!text.isEmpty() && metrics.stringWidth(text + "\u2026") > room) {
            text = text.substring(0, text.length() - 1);
        }
        return text + "\u2026";
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setFont(Scaled.font(NAME_FONT));
        g.setColor(background());
        g.fillRect(0, 0, getWidth(), getHeight());
        if (run != null) {
            paintRows(g);
            int axis = bottom() - axisHeight();
            g.setColor(background());
            g.fillRect(0, axis, getWidth(), axisHeight());
            paintAxis(g, axis);
            paintNow(g, axis);
        }
        g.dispose();
    }

    private static Color background() {
        return UIManager.getColor("TextField.background");
    }

    /** The lower edge of the visible part, or of the whole in an image. */
    private int bottom() {
        boolean scrolled = getParent() instanceof JViewport && !isPaintingForPrint();
        Rectangle visible = getVisibleRect();
        return scrolled && !visible.isEmpty() ? visible.y + visible.height : getHeight();
    }

    private void paintRows(Graphics2D g) {
        double height = rowHeight();
        double reached = xOf(run.reached());
        g.setColor(shade(24));
        g.fill(new Rectangle2D.Double(left(), GAP, reached - left(), height * sensors.size()));
        for (int row = 0; row < sensors.size(); row++) {
            String sensor = sensors.get(row);
            Color colour =
                    colours.of(run.info().settings().sensors().get(sensor).kind());
            for (Interval held : intervals.ofSensor(sensor, run.reached())) {
                bar(g, row, xOf(held.from()), xOf(held.to()), colour);
            }
            paintName(g, row, sensor);
            paintMarks(g, row, sensor, colour);
        }
    }

    private void paintName(Graphics2D g, int row, String sensor) {
        String text = label(sensor);
        FontMetrics metrics = g.getFontMetrics();
        g.setColor(shade(220));
        float x = left() - Scaled.px(MARGIN) / 2f - metrics.stringWidth(text);
        g.drawString(text, x, (float) (yOf(row) + metrics.getAscent()));
    }

    private void bar(Graphics2D g, int row, double from, double to, Color colour) {
        g.setColor(new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), 130));
        g.fill(new Rectangle2D.Double(from, yOf(row) + 1, Math.max(1.0, to - from), rowHeight() - 2));
    }

    private void paintMarks(Graphics2D g, int row, String sensor, Color colour) {
        double top = yOf(row) + 0.5;
        double bottom = top + rowHeight() - 1.0;
        for (DetectionEvent event : events) {
            if (!event.observation().sensor().equals(sensor)) {
                continue;
            }
            double x = xOf(event.observation().arrival());
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

    private void paintAxis(Graphics2D g, int top) {
        FontMetrics metrics = g.getFontMetrics();
        double wanted = run.duration() * Scaled.px(TICKS) / Math.max(1, right() - left());
        double power = Math.pow(10.0, Math.floor(Math.log10(wanted)));
        double step = wanted <= power
                ? power
                : wanted <= 2 * power ? 2 * power : wanted <= 5 * power ? 5 * power : 10 * power;
        g.setColor(shade(160));
        for (int i = 0; i * step <= run.duration() * (1.0 + 1e-9); i++) {
            double x = xOf(i * step);
            g.fill(new Rectangle2D.Double(x - 0.5, top, 1, Scaled.px(4)));
            String text = String.format(Locale.ROOT, step < 1.0 ? "%.2g s" : "%.0f s", i * step);
            int left = (int)
                    Math.max(0, Math.min(getWidth() - metrics.stringWidth(text), x - 0.5 * metrics.stringWidth(text)));
            g.drawString(text, left, top + Scaled.px(4) + metrics.getAscent());
        }
    }

    private void paintNow(Graphics2D g, int axis) {
        double x = xOf(playback.time());
        double size = Scaled.px(5);
        double top = Math.max(0, axis - getVisibleRect().height);
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

    /** The whole name over a name, the event nearest to the pointer, else the sensor of the row and the time. */
    @Override
    public String getToolTipText(MouseEvent e) {
        if (run == null || sensors.isEmpty()) {
            return null;
        }
        int row = (int) Math.max(0, Math.min(sensors.size() - 1.0, (e.getY() - GAP) / rowHeight()));
        if (e.getX() < left()) {
            return sensors.get(row);
        }
        DetectionEvent nearest = null;
        double best = Scaled.px(NEAR);
        for (DetectionEvent event : events) {
            double distance = Math.abs(xOf(event.observation().arrival()) - e.getX());
            if (event.observation().sensor().equals(sensors.get(row)) && distance < best) {
                best = distance;
                nearest = event;
            }
        }
        return nearest == null
                ? sensors.get(row) + ", " + Texts.time(Math.max(0.0, timeAt(e.getX())))
                : Events.text(nearest);
    }
}
