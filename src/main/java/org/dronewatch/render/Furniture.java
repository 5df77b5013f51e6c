package org.dronewatch.render;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.canvas.DroneMark;
import org.dronewatch.render.canvas.KindColours;
import org.dronewatch.render.canvas.SensorMark;
import org.dronewatch.render.canvas.WatcherColours;

/** Annotations around a view: title, legend, scale bar, north arrow, levels of rays. */
final class Furniture {
    private static final Color PAPER = new Color(255, 255, 255, 222);
    private static final Color INK = new Color(0x20262e);
    private static final Color FAINT = new Color(0x6a737d);

    /** Colour of out-of-date annotations. */
    private static final Color STALE = new Color(0xb3261e);

    /** Length of the scale bar as a fraction of the view's width, approximately. */
    private static final double BAR = 0.16;

    private final Graphics2D g;
    private final int width;
    private final int height;
    private final double scale;
    private final int margin;
    private final List<Rectangle> occupied = new ArrayList<>();
    /** The height that the credits take up in the lower right corner, pixels. */
    private int credited;

    Furniture(Graphics2D g, int width, int height, double scale) {
        this.g = g;
        this.width = width;
        this.height = height;
        this.scale = scale;
        this.margin = px(12);
    }

    /** The area covered by the legend, to be kept free. */
    List<Rectangle> occupied() {
        return occupied;
    }

    private int px(double normal) {
        return (int) Math.round(normal * scale);
    }

    private void paper(int x, int y, int w, int h) {
        occupied.add(new Rectangle(x, y, w, h));
        g.setColor(PAPER);
        g.fillRoundRect(x, y, w, h, px(10), px(10));
        g.setColor(new Color(0, 0, 0, 28));
        g.setStroke(new BasicStroke((float) scale));
        g.drawRoundRect(x, y, w, h, px(10), px(10));
    }

    private Font font(int style, double size) {
        return new Font(Font.SANS_SERIF, style, px(size));
    }

    /**
     * Draws title and time and, below them, a line for each kind of sensor, one for what is protected, one for drones,
     * and those for flights.
     *
     * @param zone whether something is protected
     * @param flights what the colours of flights mean
     */
    void legend(SiteState state, KindColours colours, String view, boolean zone, Map<String, Color> flights) {
        Map<String, int[]> counts = new TreeMap<>();
        for (SensorMark sensor : state.sensors()) {
            int[] count = counts.computeIfAbsent(sensor.kind(), kind -> new int[2]);
            count[0]++;
            count[1] += sensor.detecting() ? 1 : 0;
        }
        List<String> texts = new ArrayList<>();
        List<Color> marks = new ArrayList<>();
        for (String kind : colours.kinds()) {
            int[] count = counts.getOrDefault(kind, new int[2]);
            texts.add(kind + ": " + count[0] + (count[1] > 0 ? ", " + count[1] + " detecting" : ""));
            marks.add(colours.of(kind));
        }
        if (zone) {
            texts.add("protected");
            marks.add(StateLines.ZONE);
        }
        int discs = texts.size();
        Map<String, Color> ofDrones =
                state.drones().isEmpty() && !flights.isEmpty() ? Map.of() : flying(state.drones());
        ofDrones.forEach((text, colour) -> {
            texts.add(text);
            marks.add(colour);
        });
        int rings = texts.size();
        flights.forEach((text, colour) -> {
            texts.add(text);
            marks.add(colour);
        });
        // Where only the lines of whole flights are drawn, they do not show a moment.
        boolean isMoment = !state.drones().isEmpty() || flights.isEmpty();
        String time = isMoment ? String.format(Locale.ROOT, "%s, %.2f s", view, state.time()) : view;
        g.setFont(font(Font.BOLD, 15));
        int w = g.getFontMetrics().stringWidth(state.title());
        g.setFont(font(Font.PLAIN, 12));
        FontMetrics metrics = g.getFontMetrics();
        w = Math.max(w, metrics.stringWidth(time));
        for (String text : texts) {
            w = Math.max(w, metrics.stringWidth(text) + px(20));
        }
        int line = px(19);
        paper(margin, margin, w + px(24), px(48) + line * texts.size() + px(8));
        int x = margin + px(12);
        int y = margin + px(22);
        g.setFont(font(Font.BOLD, 15));
        g.setColor(INK);
        g.drawString(state.title(), x, y);
        g.setFont(font(Font.PLAIN, 12));
        g.setColor(FAINT);
        g.drawString(time, x, y + px(18));
        y += px(20);
        for (int i = 0; i < texts.size(); i++) {
            y += line;
            double r = 4.5 * scale;
            g.setColor(marks.get(i));
            Ellipse2D dot = new Ellipse2D.Double(x + scale, y - 4.5 * scale - r, 2 * r, 2 * r);
            if (i >= rings) {
                float thick = (float) (3.0 * scale);
                float[] dashes = marks.get(i).equals(WatcherColours.NOBODY) ? new float[] {thick, thick} : null;
                g.setStroke(new BasicStroke(thick, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10.0f, dashes, 0.0f));
                g.draw(new Line2D.Double(x, y - 4.5 * scale, x + 14.0 * scale, y - 4.5 * scale));
            } else if (i >= discs) {
                g.setStroke(new BasicStroke((float) (2.2 * scale)));
                g.draw(dot);
            } else {
                g.fill(dot);
            }
            g.setColor(INK);
            g.drawString(texts.get(i), x + px(20), y);
        }
    }

    /** Draws a scale bar of 1, 2 or 5 times a power of ten metres. */
    void scaleBar(double metresPerPixel, boolean everywhere) {
        double wanted = BAR * width * metresPerPixel;
        double power = Math.pow(10.0, Math.floor(Math.log10(wanted)));
        double length = wanted >= 5 * power ? 5 * power : wanted >= 2 * power ? 2 * power : power;
        int pixels = (int) Math.round(length / metresPerPixel);
        String number = length >= 1.0
                ? String.format(Locale.ROOT, "%.0f m", length)
                : String.format(Locale.ROOT, "%.0f cm", 100.0 * length);
        String text = everywhere ? number : number + " at the centre";
        g.setFont(font(Font.PLAIN, 12));
        int w = Math.max(pixels, g.getFontMetrics().stringWidth(text)) + px(24);
        int h = px(36);
        int y = height - margin - h;
        paper(margin, y, w, h);
        g.setColor(INK);
        g.drawString(text, margin + px(12), y + px(16));
        g.setStroke(new BasicStroke((float) (2.5 * scale), BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER));
        double top = y + 26.0 * scale;
        double left = margin + 12.0 * scale;
        g.draw(new Line2D.Double(left, top, left + pixels, top));
        g.draw(new Line2D.Double(left, top - 4 * scale, left, top + 4 * scale));
        g.draw(new Line2D.Double(left + pixels, top - 4 * scale, left + pixels, top + 4 * scale));
    }

    /** Draws an arrow to the north as it lies in the picture; foreshortened where it points away from the eye. */
    void northArrow(Orbit orbit) {
        int size = px(58);
        int x0 = width - margin - size;
        paper(x0, margin, size, size);
        // The components of north in the picture: to the right, and upwards, the more so the more steeply the eye looks
        // down.
        double right = Math.sin(orbit.bearing());
        double up = -Math.cos(orbit.bearing()) * Math.max(0.25, Math.abs(Math.sin(orbit.elevation())));
        double length = Math.hypot(right, up);
        double reach = 14.0 * scale * Math.max(0.55, Math.min(1.0, length));
        double ux = right / length;
        double uy = -up / length;
        double cx = x0 + 0.5 * size;
        double cy = margin + 0.5 * size;
        Path2D arrow = new Path2D.Double();
        arrow.moveTo(cx + reach * ux, cy + reach * uy);
        arrow.lineTo(cx - 0.7 * reach * ux - 0.5 * reach * uy, cy - 0.7 * reach * uy + 0.5 * reach * ux);
        arrow.lineTo(cx - 0.35 * reach * ux, cy - 0.35 * reach * uy);
        arrow.lineTo(cx - 0.7 * reach * ux + 0.5 * reach * uy, cy - 0.7 * reach * uy - 0.5 * reach * ux);
        arrow.closePath();
        g.setColor(INK);
        g.fill(arrow);
        g.setFont(font(Font.BOLD, 11));
        FontMetrics metrics = g.getFontMetrics();
        g.drawString("N", (float) (cx + (reach + 6 * scale) * ux - 0.5 * metrics.stringWidth("N")), (float)
                (cy + (reach + 6 * scale) * uy + 0.36 * metrics.getAscent()));
    }

    /** Draws the credits for the data of the site, in the lower right corner. */
    void credits(List<String> credits) {
        g.setFont(font(Font.PLAIN, 10));
        FontMetrics metrics = g.getFontMetrics();
        List<String> lines = Credits.lines(credits, metrics, width / 2);
        if (lines.isEmpty()) {
            return;
        }
        int w = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0) + px(12);
        int h = px(13) * lines.size() + px(7);
        int x = width - margin - w;
        int y = height - margin - h;
        paper(x, y, w, h);
        g.setColor(INK);
        for (int i = 0; i < lines.size(); i++) {
            g.drawString(lines.get(i), x + px(6), y + px(13) * (i + 1));
        }
        credited = h + px(6);
    }

    /**
     * Draws the colours of levels, and states how many segments of rays are drawn and for which time they were traced.
     *
     * @param now time of the picture, s
     */
    void levels(RecordedRays rays, RayFilter filter, double now) {
        LevelScale levels = rays.scale();
        g.setFont(font(Font.PLAIN, 12));
        FontMetrics metrics = g.getFontMetrics();
        String count = String.format(Locale.ROOT, "%,d of %,d ray segments", filter.count(rays), rays.count());
        String whose = "sound from " + rays.drone() + " to " + rays.sensor();
        boolean old = Math.abs(now - rays.time()) >= 0.005;
        String when = String.format(
                Locale.ROOT,
                old ? "traced at %.2f s, %.2f s %s than this picture" : "traced at %.2f s",
                rays.time(),
                Math.abs(now - rays.time()),
                now > rays.time() ? "earlier" : "later");
        int bar = px(180);
        int text =
                Math.max(metrics.stringWidth(count), Math.max(metrics.stringWidth(whose), metrics.stringWidth(when)));
        int w = Math.max(bar, text) + px(24);
        int h = px(103);
        int x = width - margin - w;
        int y = height - margin - h - credited;
        paper(x, y, w, h);
        g.setColor(INK);
        g.drawString(whose, x + px(12), y + px(19));
        g.setColor(FAINT);
        g.drawString(count, x + px(12), y + px(36));
        g.setColor(old ? STALE : FAINT);
        g.drawString(when, x + px(12), y + px(53));
        for (int i = 0; i < bar; i++) {
            double level = levels.low() + (i + 0.5) / bar * (levels.high() - levels.low());
            g.setColor(new Color(levels.colour(level)));
            g.fillRect(x + px(12) + i, y + px(62), 1, px(12));
        }
        g.setColor(INK);
        double step = levels.high() - levels.low() > 30.0 ? 20.0 : levels.high() - levels.low() > 12.0 ? 10.0 : 5.0;
        for (double level = step * Math.ceil(levels.low() / step); level <= levels.high(); level += step) {
            double at = x + px(12) + (level - levels.low()) / (levels.high() - levels.low()) * bar;
            String mark = String.format(Locale.ROOT, level + step > levels.high() ? "%.0f dB" : "%.0f", level + 0.0);
            g.draw(new Line2D.Double(at, y + px(74), at, y + px(77)));
            int half = metrics.stringWidth(mark) / 2;
            int left = (int) Math.max(x + px(8), Math.min(x + w - px(8) - 2.0 * half, at - half));
            g.drawString(mark, left, y + px(90));
        }
    }

    /** A position as text, such as (12.0, 8.5, 143.2) m. */
    static String text(Position position) {
        return String.format(Locale.ROOT, "(%.1f, %.1f, %.1f) m", position.x(), position.y(), position.z());
    }

    /** The number of drones and, if there are any, of birds that fly, with their colours. */
    static Map<String, Color> flying(List<DroneMark> marks) {
        long birds =
                marks.stream().filter(mark -> mark.drone().settings().isBird()).count();
        long drones = marks.size() - birds;
        Map<String, Color> texts = new LinkedHashMap<>();
        if (drones > 0 || birds == 0) {
            texts.put(drones == 1 ? "drone" : "drones: " + drones, KindColours.DRONE);
        }
        if (birds > 0) {
            texts.put(birds == 1 ? "bird" : "birds: " + birds, KindColours.BIRD);
        }
        return texts;
    }
}
