package org.dronewatch.render;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.util.Locale;
import java.util.Optional;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.optics.CameraObject;
import org.jogamp.vecmath.Point2d;

/** Meridians and parallels on the plan of a site, with latitudes and longitudes at the right and lower edges. */
final class Graticule {
    /** The approximate number of lines that cross the shorter side of a picture. */
    private static final double LINES = 5.0;

    /** The number of points of a line: over 100 km, a parallel deviates by 100 m from a straight line. */
    private static final int POINTS = 32;

    private static final Color LINE = new Color(20, 30, 40, 70);
    private static final Color INK = new Color(20, 30, 40, 200);
    private static final Color PAPER = new Color(255, 255, 255, 170);

    private final Geodesy geodesy;
    private final Orbit orbit;
    private final CameraObject camera;
    private final int width;
    private final int height;
    private final double scale;

    /**
     * A graticule for one picture from above.
     *
     * @param width width of the picture in pixels
     * @param height height of the picture in pixels
     * @param scale scale of its letters
     */
    Graticule(Origin origin, Orbit orbit, int width, int height, double scale) {
        this.geodesy = new Geodesy(origin);
        this.orbit = orbit;
        this.camera = orbit.camera(width, height);
        this.width = width;
        this.height = height;
        this.scale = scale;
    }

    /**
     * The distance between lines, degrees: the smallest of 1, 2 and 5 times a power of ten that is not less than a
     * given distance.
     */
    static double step(double least) {
        double power = Math.pow(10.0, Math.floor(Math.log10(least)));
        for (double times : new double[] {1.0, 2.0, 5.0}) {
            if (times * power >= least * (1.0 - 1e-9)) {
                return times * power;
            }
        }
        return 10.0 * power;
    }

    void draw(Graphics2D g) {
        double metres = orbit.metresPerPixel(height);
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int corner = 0; corner < 4; corner++) {
            double right = (corner % 2 - 0.5) * width * metres;
            double up = (corner < 2 ? -0.5 : 0.5) * height * metres;
            GeoPoint place = geodesy.onEarth(orbit.panned(right, up).target());
            low[0] = Math.min(low[0], place.longitude());
            high[0] = Math.max(high[0], place.longitude());
            low[1] = Math.min(low[1], place.latitude());
            high[1] = Math.max(high[1], place.latitude());
        }
        // Across the date line, or about a pole, there are no plain intervals.
        if (high[0] - low[0] > 90.0 || high[1] > 89.0 || low[1] < -89.0) {
            return;
        }
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, (int) Math.round(11.0 * scale)));
        double share = LINES / Math.min(width, height);
        for (int axis = 0; axis < 2; axis++) {
            double perPixel = (high[axis] - low[axis]) / (axis == 0 ? width : height);
            double step = step(perPixel / share);
            int decimals = Math.max(0, (int) Math.ceil(-Math.log10(step) - 1e-9));
            for (long i = (long) Math.ceil(low[axis] / step); i * step <= high[axis]; i++) {
                line(g, axis, i * step, low[1 - axis], high[1 - axis], decimals);
            }
        }
    }

    private void line(Graphics2D g, int axis, double at, double from, double to, int decimals) {
        Path2D path = new Path2D.Double();
        Point2d edge = null;
        for (int i = 0; i <= POINTS; i++) {
            double along = from + (to - from) * i / POINTS;
            Optional<Point2d> pixel = axis == 0 ? pixel(at, along) : pixel(along, at);
            if (pixel.isEmpty()) {
                return;
            }
            Point2d point = pixel.get();
            if (path.getCurrentPoint() == null) {
                path.moveTo(point.x, point.y);
            } else {
                path.lineTo(point.x, point.y);
            }
            boolean isFarther = edge == null || (axis == 0 ? point.y > edge.y : point.x > edge.x);
            edge = isFarther ? point : edge;
        }
        g.setColor(LINE);
        g.setStroke(new BasicStroke((float) scale));
        g.draw(path);
        String hemisphere = axis == 0 ? at < 0.0 ? "W" : "E" : at < 0.0 ? "S" : "N";
        label(g, axis, edge, String.format(Locale.ROOT, "%." + decimals + "f\u00b0 %s", Math.abs(at), hemisphere));
    }

    /** Writes a label at the lower or the right edge, clear of what is in the corners. */
    private void label(Graphics2D g, int axis, Point2d edge, String text) {
        FontMetrics metrics = g.getFontMetrics();
        double x =
                axis == 0 ? edge.x - 0.5 * metrics.stringWidth(text) : width - metrics.stringWidth(text) - 6.0 * scale;
        double y = axis == 0 ? height - 6.0 * scale : edge.y + 0.4 * metrics.getAscent();
        boolean isClear = axis == 0 ? x > 0.25 * width && x < 0.85 * width : y > 0.15 * height && y < 0.9 * height;
        if (isClear) {
            g.setColor(PAPER);
            g.fillRect(
                    (int) (x - 2 * scale),
                    (int) (y - metrics.getAscent()),
                    (int) (metrics.stringWidth(text) + 4 * scale),
                    metrics.getHeight());
            g.setColor(INK);
            g.drawString(text, (float) x, (float) y);
        }
    }

    /** The pixel at which a place at the height of the orbit's target is drawn; empty if it cannot be drawn. */
    private Optional<Point2d> pixel(double longitude, double latitude) {
        Position target = orbit.target();
        double level = geodesy.onEarth(target).height();
        return camera.pixelOf(geodesy.inWorld(Math.toRadians(latitude), Math.toRadians(longitude), level)
                .toPoint3d());
    }
}
