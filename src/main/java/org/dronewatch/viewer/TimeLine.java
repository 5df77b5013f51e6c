package org.dronewatch.viewer;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.JPanel;
import javax.swing.UIManager;
import org.dronewatch.picture.KindColours;
import org.dronewatch.scene.DetectionEvent;
import org.dronewatch.sensor.Observation;

/**
 * A run from its start to its end: a row for each sensor with a bar while it detects a drone, a triangle where it gains one
 * and a stroke where it loses it; what has not been simulated yet is hatched. A click jumps to a time.
 */
final class TimeLine extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int MARGIN = 10;
    private static final int AXIS = 20;
    private static final int HIGHEST_ROW = 12;
    private static final int WANTED_WIDTH = 600;
    private static final int WANTED_ROW = 10;
    private static final int LOWEST = 64;
    private static final int HIGHEST = 170;
    private static final int NEAR = 6;
    private static final double LEGIBLE_ROW = 9.0;
    private static final int NAME_SIZE = 9;

    private final transient Playback playback;
    private final transient List<DetectionEvent> events = new ArrayList<>();
    private transient RecordedRun run;
    private transient List<String> sensors = List.of();
    private transient KindColours colours;

    TimeLine(Playback playback) {
        this.playback = playback;
        setMinimumSize(new Dimension(200, LOWEST));
        setToolTipText("");
        getAccessibleContext().setAccessibleName("time line");
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

    /** As high as its rows want, but no more than a fifth of the window. */
    @Override
    public Dimension getPreferredSize() {
        int most = getTopLevelAncestor() == null
                ? HIGHEST
                : Math.min(HIGHEST, getTopLevelAncestor().getHeight() / 5);
        return new Dimension(WANTED_WIDTH, Math.max(LOWEST, Math.min(most, AXIS + 8 + WANTED_ROW * sensors.size())));
    }

    private void jump(int x) {
        if (run != null) {
            playback.jump(timeAt(x));
        }
    }

    /** Takes over what is new. */
    void update() {
        if (playback.run() != run) {
            run = playback.run();
            events.clear();
            sensors = run == null
                    ? List.of()
                    : List.copyOf(run.info().settings().sensors().keySet());
            revalidate();
            colours = run == null
                    ? null
                    : KindColours.of(run.info().settings().sensors().values());
        }
        if (run != null) {
            events.addAll(run.eventsFrom(events.size()));
        }
        repaint();
    }

    private double timeAt(int x) {
        return (x - MARGIN) / (double) Math.max(1, getWidth() - 2 * MARGIN) * run.duration();
    }

    /** Where a time is, in pixels from the left. */
    double xOf(double time) {
        return MARGIN + time / run.duration() * (getWidth() - 2 * MARGIN);
    }

    private double rowHeight() {
        return Math.min(HIGHEST_ROW, (getHeight() - AXIS - 6.0) / Math.max(1, sensors.size()));
    }

    /** The upper edge of a sensor's row. */
    double yOf(int row) {
        return 3.0 + row * rowHeight();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(UIManager.getColor("TextField.background"));
        g.fillRect(0, 0, getWidth(), getHeight());
        if (run != null) {
            paintRows(g);
            paintAxis(g);
            paintNow(g);
        }
        g.dispose();
    }

    private void paintRows(Graphics2D g) {
        double height = rowHeight();
        double reached = xOf(run.reached());
        g.setColor(shade(24));
        g.fill(new Rectangle2D.Double(MARGIN, 3, reached - MARGIN, height * sensors.size()));
        for (int row = 0; row < sensors.size(); row++) {
            String sensor = sensors.get(row);
            Color colour =
                    colours.of(run.info().settings().sensors().get(sensor).kind());
            List<String> held = new ArrayList<>();
            double from = 0.0;
            for (DetectionEvent event : events) {
                Observation o = event.observation();
                if (!o.sensor().equals(sensor)) {
                    continue;
                }
                double x = xOf(o.arrival());
                if (event.gained()) {
                    from = held.isEmpty() ? x : from;
                    held.add(o.drone());
                } else {
                    held.remove(o.drone());
                    if (held.isEmpty()) {
                        bar(g, row, from, x, colour);
                    }
                }
            }
            if (!held.isEmpty()) {
                bar(g, row, from, reached, colour);
            }
            paintName(g, row, sensor);
            paintMarks(g, row, sensor, colour);
        }
    }

    /** Small, where there is room: the tool tip tells all of them. */
    private void paintName(Graphics2D g, int row, String sensor) {
        if (rowHeight() >= LEGIBLE_ROW) {
            g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, NAME_SIZE));
            g.setColor(shade(150));
            float right = getWidth() - MARGIN - 3f - g.getFontMetrics().stringWidth(sensor);
            g.drawString(sensor, right, (float) (yOf(row) + rowHeight() - 2.5));
        }
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
                triangle.lineTo(x + 6, 0.5 * (top + bottom));
                triangle.lineTo(x, bottom);
                triangle.closePath();
                g.fill(triangle);
            } else {
                g.fill(new Rectangle2D.Double(x - 0.75, top, 1.5, bottom - top));
            }
        }
    }

    private static Color shade(int alpha) {
        Color ink = UIManager.getColor("Label.foreground");
        return new Color(ink.getRed(), ink.getGreen(), ink.getBlue(), alpha);
    }

    private void paintAxis(Graphics2D g) {
        g.setFont(
                getFont() == null
                        ? new Font(Font.SANS_SERIF, Font.PLAIN, 11)
                        : getFont().deriveFont(11f));
        FontMetrics metrics = g.getFontMetrics();
        double wanted = run.duration() * 80.0 / Math.max(1, getWidth() - 2 * MARGIN);
        double power = Math.pow(10.0, Math.floor(Math.log10(wanted)));
        double step = wanted <= power
                ? power
                : wanted <= 2 * power ? 2 * power : wanted <= 5 * power ? 5 * power : 10 * power;
        int y = getHeight() - AXIS;
        g.setColor(shade(160));
        for (int i = 0; i * step <= run.duration() * (1.0 + 1e-9); i++) {
            double x = xOf(i * step);
            g.fill(new Rectangle2D.Double(x - 0.5, y, 1, 4));
            String text = String.format(Locale.ROOT, step < 1.0 ? "%.2g s" : "%.0f s", i * step);
            int left = (int)
                    Math.max(0, Math.min(getWidth() - metrics.stringWidth(text), x - 0.5 * metrics.stringWidth(text)));
            g.drawString(text, left, getHeight() - 4);
        }
    }

    private void paintNow(Graphics2D g) {
        double x = xOf(playback.time());
        g.setColor(
                UIManager.getColor("Component.accentColor") == null
                        ? new Color(0x2675bf)
                        : UIManager.getColor("Component.accentColor"));
        g.fill(new Rectangle2D.Double(x - 1, 0, 2, getHeight() - AXIS + 4.0));
        Path2D head = new Path2D.Double();
        head.moveTo(x - 5, 0);
        head.lineTo(x + 5, 0);
        head.lineTo(x, 7);
        head.closePath();
        g.fill(head);
    }

    /** The event nearest to the pointer, else the sensor of the row and the time. */
    @Override
    public String getToolTipText(MouseEvent e) {
        if (run == null || sensors.isEmpty()) {
            return null;
        }
        int row = (int) Math.max(0, Math.min(sensors.size() - 1.0, (e.getY() - 3) / rowHeight()));
        DetectionEvent nearest = null;
        double best = NEAR;
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
