package org.dronewatch.positioner;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.Position;

/**
 * A positioner's search along a line on which a contact is. As seen by the positioner, the points of the line lie on an
 * arc, and the direction of a point is at the angle {@code atan2(h, r - a)} from that of the line, where h is the
 * distance of the positioner from the line, r the range of the point, and a the range at which the line is nearest to
 * the positioner. The stops of the search run from near to far, each at the point where the arc leaves the field of
 * view at the stop before; after the last stop, the search begins again. For one run, and for use by one thread.
 */
final class RangeScan {
    /** Distance between two stops as a fraction of the field of view. */
    private static final double OVERLAP = 0.8;

    /**
     * The time for which only the ranges that follow from the contact's size are searched, before the whole line is
     * searched once, s.
     */
    private static final double TRUST = 2.0;

    private static final double LOOKS = 1.5;

    /**
     * A line is interrupted where it comes clearly nearer to the positioner than the least range: nearer than this
     * fraction of it.
     */
    private static final double GRAZING = 0.9;

    /** The direction in which the positioner points, and the range up to which the line has then been searched, m. */
    private record Stop(Direction direction, double covered) {}

    private final PositionerSettings settings;
    private final Position position;
    private final ImageShape shape;
    private final double stay;

    private double searched;
    private double arrived = Double.NaN;
    private double begun = Double.NaN;
    private boolean isWhole;

    /**
     * A search that has not begun.
     *
     * @param position position of the positioner, m
     * @param interval time between two looks of its camera, s
     */
    RangeScan(PositionerSettings settings, Position position, ImageShape shape, double interval) {
        this.settings = settings;
        this.position = position;
        this.shape = shape;
        this.stay = Math.max(settings.rangeSearch().dwell(), LOOKS * interval);
    }

    /** Returns the search to its beginning. */
    void reset() {
        searched = 0.0;
        arrived = Double.NaN;
        begun = Double.NaN;
        isWhole = false;
    }

    /**
     * The direction in which to point.
     *
     * @param line the line on which the contact is now
     * @param now the present time, s
     * @param fov the field of view with which it searches, rad
     */
    Direction at(BearingLine line, double now, double fov) {
        if (Double.isNaN(begun)) {
            begun = now;
        }
        if (now - arrived >= stay) {
            searched = next(line, now, fov).covered();
            arrived = Double.NaN;
        }
        return next(line, now, fov).direction();
    }

    /**
     * Records that the positioner has reached the requested direction, with the field of view with which it searches;
     * must be called then.
     */
    void arrive(double now) {
        arrived = Double.isNaN(arrived) ? now : arrived;
    }

    private Stop next(BearingLine line, double now, double fov) {
        List<double[]> parts = parts(line);
        for (int i = 0; i < parts.size(); i++) {
            if (searched < parts.get(i)[1]) {
                // A part is done once its end has been reached, even if it grows later as the contact moves.
                double after = i + 1 < parts.size() ? parts.get(i + 1)[0] : Double.POSITIVE_INFINITY;
                return stop(line, Math.max(searched, parts.get(i)[0]), parts.get(i)[1], after, fov);
            }
        }
        searched = 0.0;
        isWhole = !isWhole && now - begun >= TRUST;
        begun = isWhole ? begun : now;
        return next(line, now, fov);
    }

    /**
     * The parts of the line that are to be searched: pairs of ranges between which the line is far enough from both
     * sensors, m.
     */
    private List<double[]> parts(BearingLine line) {
        double least = settings.rangeSearch().minRange();
        double near = isWhole ? least : Math.max(least, line.near());
        double far = isWhole ? Double.POSITIVE_INFINITY : Math.max(near, line.far());
        double nearest = position.minus(line.from()).dot(line.unit());
        double aside = aside(line).length();
        // A very small gap would let the search fall back across it as the line moves.
        if (aside > GRAZING * least) {
            return List.of(new double[] {near, far});
        }
        double hidden = Math.sqrt(least * least - aside * aside);
        List<double[]> parts = new ArrayList<>(2);
        if (near < nearest - hidden) {
            parts.add(new double[] {near, Math.min(far, nearest - hidden)});
        }
        if (far > nearest + hidden && far > near) {
            parts.add(new double[] {Math.max(near, nearest + hidden), far});
        }
        return parts.isEmpty() ? List.of(new double[] {near, far}) : parts;
    }

    /** The vector from the positioner to the nearest point of the line, m. */
    private Position aside(BearingLine line) {
        Position offset = line.from().minus(position);
        return offset.minus(line.unit().times(offset.dot(line.unit())));
    }

    private Stop stop(BearingLine line, double from, double to, double after, double fov) {
        Position aside = aside(line);
        double distance = aside.length();
        double nearest = position.minus(line.from()).dot(line.unit());
        Position across = distance > 0.0 ? aside.times(1.0 / distance) : anyAcross(line.unit());
        double start = Math.atan2(distance, from - nearest);
        double end = to == Double.POSITIVE_INFINITY ? 0.0 : Math.atan2(distance, to - nearest);
        double step = step(line.unit(), across, start, fov);
        boolean isLast = start - end <= step;
        double middle = isLast ? 0.5 * (start + end) : start - 0.5 * step;
        Position wanted = line.unit().times(Math.cos(middle)).plus(across.times(Math.sin(middle)));
        double covered = isLast ? after : nearest + distance / Math.tan(start - step);
        return new Stop(settings.tilted(Direction.of(wanted)), Math.max(covered, from));
    }

    /**
     * The angle that the field of view covers along the arc, rad: it depends on whether the arc is level or upright
     * there.
     */
    private double step(Position unit, Position across, double angle, double fov) {
        Position to = unit.times(Math.cos(angle)).plus(across.times(Math.sin(angle)));
        Position along = across.times(Math.cos(angle)).minus(unit.times(Math.sin(angle)));
        double level = Math.hypot(to.x(), to.y());
        // At a point straight up, all directions are level.
        double aside = level > 0.0 ? Math.abs(along.x() * to.y() - along.y() * to.x()) / level : 1.0;
        double upwards = Math.sqrt(Math.max(0.0, 1.0 - aside * aside));
        return OVERLAP * Math.min(shape.across(fov) / aside, shape.upwards(fov) / upwards);
    }

    private static Position anyAcross(Position unit) {
        Position level = unit.cross(new Position(0, 0, 1));
        return level.length() > 0.0 ? level.unit() : new Position(1, 0, 0);
    }
}
