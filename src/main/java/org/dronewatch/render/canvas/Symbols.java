package org.dronewatch.render.canvas;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.geom.Area;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.optics.CameraObject;

/**
 * Draws the symbols of sensors and drones over a picture, and their names where there is room: cameras as camera icons
 * whose lens widens in the viewing direction, radars as diamonds, omnidirectional sensors as discs, drones and birds as
 * rings. Symbols behind something are drawn pale.
 */
public final class Symbols {
    private static final Color DETECTING = new Color(0xffd23f);
    private static final Color PLATE = new Color(24, 28, 34, 190);
    private static final Color HIDDEN_PLATE = new Color(24, 28, 34, 110);
    private static final float HIDDEN = 0.45f;
    private static final double SIZE = 7.0;
    /** The greatest size of a sensor that the model of the site itself contains, m. */
    private static final double SENSOR = 0.1;

    /** Sensors closer together than this share a label, in pixels of a normal screen. */
    private static final double TOGETHER = 9.0;

    /** Maximum number of sensor names in one label. */
    private static final int MOST_NAMES = 4;

    private final Graphics2D g;
    private final CameraObject camera;
    private final LinePainter sight;
    private final double toPicture;
    private final double scale;
    private final List<Rectangle> taken = new ArrayList<>();
    private final List<Name> names = new ArrayList<>();
    private final double[] view = new double[3];

    private record Name(double x, double y, List<String> ids, boolean hidden, boolean selected) {
        /** A line for each name; if there are many, only the first ones, and the number of the others. */
        List<String> lines() {
            if (ids.size() <= MOST_NAMES) {
                return ids;
            }
            List<String> some = new ArrayList<>(ids.subList(0, MOST_NAMES - 1));
            some.add("+" + (ids.size() - MOST_NAMES + 1));
            return some;
        }
    }

    /**
     * Symbols in one picture.
     *
     * @param sight determines what is hidden
     * @param toPicture pixels of the picture per pixel of the camera's image
     * @param scale pixels of the picture per pixel of a screen of normal density
     */
    public Symbols(Graphics2D g, CameraObject camera, LinePainter sight, double toPicture, double scale) {
        this.g = g;
        this.camera = camera;
        this.sight = sight;
        this.toPicture = toPicture;
        this.scale = scale;
    }

    /** Keeps symbols and names out of some rectangles. */
    public void keepOff(List<Rectangle> areas) {
        taken.addAll(areas);
        Area free = new Area(new Rectangle(
                0, 0, (int) (toPicture * camera.width() + 0.5), (int) (toPicture * camera.height() + 0.5)));
        areas.forEach(area -> free.subtract(new Area(area)));
        g.clip(free);
    }

    private boolean project(Position point) {
        camera.toView(point.x(), point.y(), point.z(), view, 0);
        if (view[2] < CameraObject.NEAR) {
            return false;
        }
        double f = camera.focalLength();
        double column = 0.5 * camera.width() + f * view[0] / view[2];
        double row = 0.5 * camera.height() - f * view[1] / view[2];
        view[0] = toPicture * column;
        view[1] = toPicture * row;
        return column > -50 && row > -50 && column < camera.width() + 50 && row < camera.height() + 50;
    }

    /** Draws a sensor. */
    public void sensor(SensorMark mark, Color colour, boolean selected) {
        if (!project(mark.position())) {
            return;
        }
        double x = view[0];
        double y = view[1];
        boolean hidden = !sight.sees(mark.position(), SENSOR);
        Path2D shape = shape(mark, x, y);
        if (mark.detecting() || selected) {
            double glow = scale * (selected ? 14.0 : 12.0);
            g.setColor(mark.detecting() ? DETECTING : Color.WHITE);
            g.setStroke(new BasicStroke((float) (2.5 * scale)));
            g.draw(new Ellipse2D.Double(x - glow, y - glow, 2 * glow, 2 * glow));
        }
        g.setColor(faded(Color.WHITE, hidden));
        g.setStroke(new BasicStroke((float) (3.0 * scale), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(shape);
        g.setColor(faded(colour, hidden));
        g.fill(shape);
        name(x, y, mark.id(), hidden, selected);
    }

    private Path2D shape(SensorMark mark, double x, double y) {
        double s = SIZE * scale;
        Path2D path = new Path2D.Double();
        Outline outline = mark.outline().orElse(null);
        if (outline instanceof Outline.Frustum frustum) {
            path.append(new Rectangle2D.Double(-1.1 * s, -0.6 * s, 1.4 * s, 1.2 * s), false);
            path.moveTo(0.3 * s, -0.2 * s);
            path.lineTo(1.15 * s, -0.7 * s);
            path.lineTo(1.15 * s, 0.7 * s);
            path.lineTo(0.3 * s, 0.2 * s);
            path.closePath();
            double angle = 0.0;
            // A camera that looks at the eye, or away from it, has no direction in the picture.
            if (project(mark.position().plus(frustum.forward())) && Math.hypot(view[0] - x, view[1] - y) > 1e-6) {
                angle = Math.atan2(view[1] - y, view[0] - x);
            }
            path.transform(AffineTransform.getRotateInstance(angle));
        } else if (outline instanceof Outline.Sector) {
            path.moveTo(0.0, -s);
            path.lineTo(s, 0.0);
            path.lineTo(0.0, s);
            path.lineTo(-s, 0.0);
            path.closePath();
        } else {
            path.append(new Ellipse2D.Double(-0.8 * s, -0.8 * s, 1.6 * s, 1.6 * s), false);
        }
        path.transform(AffineTransform.getTranslateInstance(x, y));
        return path;
    }

    /** Draws a drone. */
    public void drone(DroneMark mark, boolean selected) {
        Position at = mark.drone().origin();
        if (!project(at)) {
            return;
        }
        double x = view[0];
        double y = view[1];
        boolean hidden = !sight.sees(at, mark.drone().radius());
        double r = scale * (selected ? 15.0 : 12.0);
        Ellipse2D ring = new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r);
        g.setStroke(new BasicStroke((float) (4.5 * scale)));
        g.setColor(faded(Color.WHITE, hidden));
        g.draw(ring);
        g.setStroke(new BasicStroke((float) (2.5 * scale)));
        g.setColor(faded(KindColours.of(mark.drone().settings()), hidden));
        g.draw(ring);
        if (mark.detected()) {
            g.setColor(DETECTING);
            double outer = r + 4.0 * scale;
            g.draw(new Ellipse2D.Double(x - outer, y - outer, 2 * outer, 2 * outer));
        }
        name(x, y, mark.drone().id(), hidden, selected);
    }

    /** Marks a point of a flight with a dot and writes a text beside it. */
    public void note(Position at, String words) {
        if (!project(at)) {
            return;
        }
        double x = view[0];
        double y = view[1];
        double r = 4.0 * scale;
        Ellipse2D dot = new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r);
        g.setStroke(new BasicStroke((float) (1.6 * scale)));
        g.setColor(Color.WHITE);
        g.fill(dot);
        g.setColor(WatcherColours.NOBODY);
        g.draw(dot);
        name(x, y, words, !sight.sees(at, 1.0), false);
    }

    private static Color faded(Color colour, boolean hidden) {
        int alpha = hidden ? Math.round(255 * HIDDEN) : 255;
        return new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), alpha);
    }

    /** Adds the name of a sensor to be written; sensors at one position share one label. */
    private void name(double x, double y, String id, boolean hidden, boolean selected) {
        for (int i = 0; i < names.size(); i++) {
            Name other = names.get(i);
            if (Math.hypot(other.x - x, other.y - y) < TOGETHER * scale) {
                List<String> ids = new ArrayList<>(other.ids);
                ids.add(selected ? 0 : ids.size(), id);
                names.set(i, new Name(other.x, other.y, ids, other.hidden && hidden, other.selected || selected));
                return;
            }
        }
        int room = (int) Math.round(SIZE * scale);
        taken.add(new Rectangle((int) x - room, (int) y - room, 2 * room, 2 * room));
        names.add(new Name(x, y, List.of(id), hidden, selected));
    }

    /** Writes the names, the most important first, each where it covers no other; those without room are left out. */
    public void writeNames() {
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, (int) Math.round(12 * scale)));
        names.sort((a, b) -> Boolean.compare(b.selected, a.selected) != 0
                ? Boolean.compare(b.selected, a.selected)
                : Boolean.compare(a.hidden, b.hidden));
        for (Name name : names) {
            write(name);
        }
    }

    private void write(Name name) {
        FontMetrics metrics = g.getFontMetrics();
        int pad = (int) Math.round(4 * scale);
        int gap = (int) Math.round(17 * scale);
        int width = name.lines().stream().mapToInt(metrics::stringWidth).max().orElse(0) + 2 * pad;
        int height = name.lines().size() * metrics.getHeight() + pad / 2;
        int x = (int) Math.round(name.x);
        int y = (int) Math.round(name.y);
        int[][] corners = {
            {x + gap, y - height / 2},
            {x - gap - width, y - height / 2},
            {x - width / 2, y - gap - height},
            {x - width / 2, y + gap},
            {x + gap, y - gap - height},
            {x + gap, y + gap},
            {x - gap - width, y - gap - height},
            {x - gap - width, y + gap}
        };
        for (int[] corner : corners) {
            Rectangle plate = new Rectangle(corner[0], corner[1], width, height);
            if (isFree(plate)) {
                taken.add(plate);
                g.setColor(name.hidden && !name.selected ? HIDDEN_PLATE : PLATE);
                g.fillRoundRect(plate.x, plate.y, width, height, 2 * pad, 2 * pad);
                g.setColor(Color.WHITE);
                for (int line = 0; line < name.lines().size(); line++) {
                    int base = plate.y + pad / 4 + line * metrics.getHeight() + metrics.getAscent();
                    g.drawString(name.lines().get(line), plate.x + pad, base);
                }
                return;
            }
        }
    }

    private boolean isFree(Rectangle plate) {
        Rectangle all = new Rectangle(
                0, 0, (int) (toPicture * camera.width() + 0.5), (int) (toPicture * camera.height() + 0.5));
        return all.contains(plate) && taken.stream().noneMatch(plate::intersects);
    }
}
