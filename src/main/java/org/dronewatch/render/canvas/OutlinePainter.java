package org.dronewatch.render.canvas;

import java.util.List;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Outline;
import org.dronewatch.world.GroundPoint;

/** Draws the sensors' fields of view as lines in the world: frustums, sectors and spheres. */
public final class OutlinePainter {
    /** The number of straight lines with which a full turn is drawn. */
    private static final int STEPS = 72;

    private final LinePainter lines;
    private final double length;

    /**
     * A painter of one picture.
     *
     * @param length maximum length to which frustums are drawn, m; sectors are drawn up to three times as far, but no
     *     field of view beyond its range
     */
    public OutlinePainter(LinePainter lines, double length) {
        this.lines = lines;
        this.length = length;
    }

    /**
     * Draws one sensor's field of view.
     *
     * @param at position of the sensor, m
     * @param width width of the lines, pixels
     * @param colour red, green and blue in the lowest 24 bits
     * @param share opacity of the lines, 0 to 1
     */
    public void draw(Position at, Outline outline, double width, int colour, double share) {
        if (outline instanceof Outline.Frustum frustum) {
            drawFrustum(at, frustum, width, colour, share);
        } else if (outline instanceof Outline.Sector sector) {
            drawSector(at, sector, width, colour, share);
        } else if (outline instanceof Outline.Ball ball) {
            drawBall(at, ball.radius(), width, colour, share);
        }
    }

    /**
     * Draws the edges of a protected area.
     *
     * @param width width of the lines, pixels
     * @param colour red, green and blue in the lowest 24 bits
     * @param share opacity of the lines, 0 to 1
     */
    public void draw(AreaZone area, double width, int colour, double share) {
        List<GroundPoint> outline = area.outline();
        int stride = Math.max(1, outline.size() / 12);
        for (int i = 0; i < outline.size(); i++) {
            GroundPoint a = outline.get(i);
            GroundPoint b = outline.get((i + 1) % outline.size());
            Position low = new Position(a.x(), a.y(), area.bottom());
            Position high = new Position(a.x(), a.y(), area.top());
            lines.line(low, new Position(b.x(), b.y(), area.bottom()), width, colour, share);
            lines.line(high, new Position(b.x(), b.y(), area.top()), width, colour, share);
            if (i % stride == 0) {
                lines.line(low, high, width, colour, share);
            }
        }
    }

    private void drawFrustum(Position at, Outline.Frustum frustum, double width, int colour, double share) {
        List<Position> corners = frustum.corners(at, Math.min(length, frustum.far()));
        for (int i = 0; i < corners.size(); i++) {
            lines.line(at, corners.get(i), width, colour, share);
            lines.line(corners.get(i), corners.get((i + 1) % corners.size()), width, colour, share);
        }
    }

    /** Draws the outer edge of a sector at its top, middle and bottom, and its sides unless it goes all round. */
    private void drawSector(Position at, Outline.Sector sector, double width, int colour, double share) {
        double range = Math.min(sector.maxRange(), 3.0 * length);
        double first = sector.azimuth() - 0.5 * sector.azimuthWidth();
        boolean round = sector.azimuthWidth() > 2.0 * Math.PI - 1e-6;
        int steps = Math.max(2, (int) Math.ceil(STEPS * sector.azimuthWidth() / (2.0 * Math.PI)));
        for (int level = -1; level <= 1; level++) {
            double elevation = sector.elevation() + 0.5 * level * sector.elevationWidth();
            double weight = level == 0 ? share : 0.6 * share;
            for (int i = 0; i < steps; i++) {
                double from = first + sector.azimuthWidth() * i / steps;
                double to = first + sector.azimuthWidth() * (i + 1) / steps;
                lines.line(
                        pointAt(at, from, elevation, range), pointAt(at, to, elevation, range), width, colour, weight);
            }
            for (int side = 0; side <= 1 && !round; side++) {
                double azimuth = first + side * sector.azimuthWidth();
                lines.line(
                        pointAt(at, azimuth, elevation, Math.min(range, sector.minRange())),
                        pointAt(at, azimuth, elevation, range),
                        width,
                        colour,
                        weight);
            }
        }
    }

    private static Position pointAt(Position at, double azimuth, double elevation, double range) {
        double level = range * Math.cos(elevation);
        return at.plus(new Position(level * Math.sin(azimuth), level * Math.cos(azimuth), range * Math.sin(elevation)));
    }

    /** Draws the three great circles of a ball. */
    private void drawBall(Position at, double radius, double width, int colour, double share) {
        for (int i = 0; i < STEPS; i++) {
            double a = 2.0 * Math.PI * i / STEPS;
            double b = 2.0 * Math.PI * (i + 1) / STEPS;
            double ca = radius * Math.cos(a);
            double sa = radius * Math.sin(a);
            double cb = radius * Math.cos(b);
            double sb = radius * Math.sin(b);
            lines.line(at.plus(new Position(ca, sa, 0)), at.plus(new Position(cb, sb, 0)), width, colour, share);
            lines.line(at.plus(new Position(ca, 0, sa)), at.plus(new Position(cb, 0, sb)), width, colour, share);
            lines.line(at.plus(new Position(0, ca, sa)), at.plus(new Position(0, cb, sb)), width, colour, share);
        }
    }
}
