package org.dronewatch.render;

import java.awt.Color;
import java.util.List;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.Ray;
import org.dronewatch.render.canvas.DroneMark;
import org.dronewatch.render.canvas.FlightStretch;
import org.dronewatch.render.canvas.KindColours;
import org.dronewatch.render.canvas.LinePainter;
import org.dronewatch.render.canvas.OutlinePainter;
import org.dronewatch.render.canvas.SensorMark;
import org.dronewatch.render.canvas.SiteLines;
import org.dronewatch.render.canvas.WatcherColours;
import org.dronewatch.sensor.Outline;
import org.dronewatch.world.World;

/** Draws the lines of a site's state: fields of view, protected zones and flights. */
final class StateLines {
    /** The colour of protected zones. */
    static final Color ZONE = new Color(0xc0392b);

    private static final int TRACK = 0xd62f1f;
    private static final int TO_COME = 0x5a1a14;
    private static final int PLUMB = 0x20262e;

    private final LinePainter lines;
    private final double pixel;

    /**
     * Lines of one picture.
     *
     * @param pixel width of a pixel of the screen, in pixels of the canvas
     */
    StateLines(LinePainter lines, double pixel) {
        this.lines = lines;
        this.pixel = pixel;
    }

    /** Draws the protected zones. */
    void zones(Protection protection) {
        protection.zone().ifPresent(zone -> new OutlinePainter(lines, zone.radius())
                .draw(zone.centre(), new Outline.Ball(zone.radius()), 1.6 * pixel, ZONE.getRGB() & 0xffffff, 0.85));
        protection.areas().forEach(area -> new OutlinePainter(lines, 0.0)
                .draw(area, 1.6 * pixel, ZONE.getRGB() & 0xffffff, 0.85));
    }

    /**
     * Draws the fields of view.
     *
     * @param length length to which the fields of view of cameras are drawn, m
     */
    void outlines(SiteState state, KindColours colours, double length) {
        for (SensorMark sensor : state.sensors()) {
            boolean selected = state.selected().filter(sensor.id()::equals).isPresent();
            OutlinePainter painting = new OutlinePainter(lines, selected ? 3.0 * length : length);
            int colour = colours.of(sensor.kind()).getRGB() & 0xffffff;
            sensor.outline()
                    .ifPresent(outline -> painting.draw(
                            sensor.position(), outline, (selected ? 2.2 : 1.3) * pixel, colour, selected ? 0.95 : 0.6));
        }
    }

    /** Draws a plumb line, which shows a drone's height. */
    void plumbLine(DroneMark drone, World world) {
        Position at = drone.drone().origin();
        world.closestHit(new Ray(at, new Position(0, 0, -1))).ifPresent(ground -> {
            Position foot = new Position(at.x(), at.y(), at.z() - ground.distance());
            lines.line(at, foot, 1.4 * pixel, PLUMB, 0.8);
        });
    }

    /**
     * Draws parts of flights with a white edge, in the colours of the sensors that detect the drone there; dashed where
     * none does.
     *
     * @param dash length of a dash and of the gap behind it, m
     */
    void stretches(List<FlightStretch> stretches, WatcherColours watchers, double dash) {
        for (FlightStretch stretch : stretches) {
            draw(stretch, 5.5 * pixel, 0xffffff, dash);
        }
        for (FlightStretch stretch : stretches) {
            draw(stretch, 3.0 * pixel, watchers.of(stretch).getRGB() & 0xffffff, dash);
        }
    }

    /** Draws lines with a dark edge, in the colours of their pieces. */
    void lines(SiteLines drawn) {
        drawn.lines().forEach(line -> line.pieces().forEach(piece -> draw(piece, 2.0, PLUMB)));
        drawn.lines().forEach(line -> line.pieces()
                .forEach(piece -> draw(piece, 0.0, piece.colour().getRGB() & 0xffffff)));
    }

    private void draw(SiteLines.Piece piece, double wider, int colour) {
        for (int i = 1; i < piece.points().size(); i++) {
            lines.line(piece.points().get(i - 1), piece.points().get(i), (piece.width() + wider) * pixel, colour, 1.0);
        }
    }

    private void draw(FlightStretch stretch, double width, int colour, double dash) {
        List<Position> path = stretch.path();
        double flown = 0.0;
        for (int i = 1; i < path.size(); i++) {
            flown += path.get(i).distance(path.get(i - 1));
            if (!stretch.sensors().isEmpty() || (long) (flown / dash) % 2 == 0) {
                lines.line(path.get(i - 1), path.get(i), width, colour, 1.0);
            }
        }
    }

    /** Draws a drone's path: the past as a line, the future as dashes. */
    void flight(DroneMark drone) {
        boolean isBird = drone.drone().settings().isBird();
        List<Position> flown = drone.flown();
        for (int i = 1; i < flown.size(); i++) {
            lines.line(
                    flown.get(i - 1),
                    flown.get(i),
                    2.6 * pixel,
                    isBird ? KindColours.BIRD.getRGB() & 0xffffff : TRACK,
                    0.9);
        }
        List<Position> toCome = drone.toCome();
        for (int i = 1; i < toCome.size(); i++) {
            if (i / 5 % 2 == 0) {
                lines.line(
                        toCome.get(i - 1),
                        toCome.get(i),
                        2.0 * pixel,
                        isBird ? KindColours.BIRD.getRGB() & 0xffffff : TO_COME,
                        0.75);
            }
        }
    }
}
