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
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JViewport;
import javax.swing.Scrollable;
import javax.swing.SwingConstants;
import javax.swing.UIManager;
import org.dronewatch.render.canvas.KindColours;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.DetectionIntervals;
import org.dronewatch.viewer.part.Scaled;
import org.dronewatch.viewer.part.Texts;
import org.dronewatch.viewer.run.Events;
import org.dronewatch.viewer.run.Playback;
import org.dronewatch.viewer.run.RecordedRun;

/**
 * A run from its start to its end: a row for each sensor, with its name on the left, a bar while it detects a drone, a
 * triangle where it gains one and a tick where it loses it; the part not simulated yet is paler. A click jumps to a
 * time. Rows keep a legible height: where there are too many, they scroll.
 */
final class TimeLine extends JPanel implements Scrollable {
    private static final long serialVersionUID = 1L;

    /** Free space on all sides, and between names and rows, at normal size, pixels. */
    static final int MARGIN = 10;

    /** Free space above the rows, pixels. */
    static final int GAP = 3;

    private static final int WANTED_WIDTH = 600;
    private static final int LOWEST = 64;
    private static final int HIGHEST = 230;
    private static final int NEAR = 6;

    /** The largest fraction of the window's height that the time line takes before its rows scroll. */
    private static final double MOST_OF_WINDOW = 0.28;

    private static final double NAME_FONT = 0.9;

    /** The greatest fraction of the width that names take up. */
    private static final double NAMES = 0.25;

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

    /** Puts this time line into a pane that scrolls its rows and keeps its axis in sight. */
    JScrollPane scrolling() {
        JScrollPane pane =
                new JScrollPane(this, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        // The axis is painted at the lower edge of the visible part: scrolling by copying pixels would smear it.
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

    /** A size as high as its rows. */
    @Override
    public Dimension getPreferredSize() {
        int rows = (int) Math.ceil(sensors.size() * rowHeight());
        return new Dimension(Scaled.px(WANTED_WIDTH), Math.max(Scaled.px(LOWEST), axisHeight() + 2 * GAP + rows));
    }

    /** A size as high as its rows, but no more than a part of the window. */
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
                    : List.copyOf(run.info().settings().enabledSensors().keySet());
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

    /** Where times begin: to the right of the names, which take as much room as the longest needs, within limits. */
    int left() {
        FontMetrics metrics = nameMetrics();
        int longest = sensors.stream().mapToInt(metrics::stringWidth).max().orElse(0);
        return Scaled.px(MARGIN) + Math.min(longest, (int) (NAMES * getWidth())) + Scaled.px(MARGIN);
    }

    /** Where times end. */
    int right() {
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
            TimeLinePainter painter = new TimeLinePainter(this, run, g);
            painter.paintRows(sensors, colours, intervals, events);
            int axis = bottom() - axisHeight();
            g.setColor(background());
            g.fillRect(0, axis, getWidth(), axisHeight());
            painter.paintAxis(axis);
            painter.paintNow(axis, playback.time());
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

    /**
     * Over a name, the whole name; elsewhere the event nearest to the pointer, or else the sensor of the row and the
     * time.
     */
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
