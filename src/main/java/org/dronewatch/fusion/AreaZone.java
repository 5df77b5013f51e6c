package org.dronewatch.fusion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.GroundPoint;
import org.dronewatch.world.SurfaceColumn;
import org.dronewatch.world.World;

/**
 * A protected area placed on the ground: an upright prism or cylinder in the world frame.
 *
 * @param name name of the area
 * @param settings settings of the area
 * @param bottom z coordinate of its bottom, m
 * @param top z coordinate of its top, m
 */
public record AreaZone(String name, ProtectedArea settings, double bottom, double top) {
    /** The ground is sampled in this number of steps along each side of the rectangle around the area. */
    private static final int STEPS = 24;

    /** A circle is drawn with this number of straight sides. */
    private static final int SIDES = 72;

    /**
     * The area on the ground of a world.
     *
     * @throws InputException with a one-line message when there is no ground below it
     */
    static AreaZone of(String name, ProtectedArea area, World world) {
        AreaZone flat = new AreaZone(name, area, 0.0, 0.0);
        List<GroundPoint> points = new ArrayList<>(flat.outline());
        area.centre().ifPresent(points::add);
        double minX = points.stream().mapToDouble(GroundPoint::x).min().orElseThrow();
        double maxX = points.stream().mapToDouble(GroundPoint::x).max().orElseThrow();
        double minY = points.stream().mapToDouble(GroundPoint::y).min().orElseThrow();
        double maxY = points.stream().mapToDouble(GroundPoint::y).max().orElseThrow();
        for (int i = 0; i < STEPS; i++) {
            for (int k = 0; k < STEPS; k++) {
                double x = minX + (maxX - minX) * (i + 0.5) / STEPS;
                double y = minY + (maxY - minY) * (k + 0.5) / STEPS;
                if (flat.beside(x, y) == 0.0) {
                    points.add(new GroundPoint(x, y));
                }
            }
        }
        double lowest = Double.POSITIVE_INFINITY;
        double highest = Double.NEGATIVE_INFINITY;
        for (GroundPoint point : points) {
            Optional<SurfaceColumn.Surface> ground =
                    SurfaceColumn.at(world, point.x(), point.y()).ground();
            if (ground.isPresent()) {
                lowest = Math.min(lowest, ground.get().z());
                highest = Math.max(highest, ground.get().z());
            }
        }
        if (lowest > highest) {
            throw new InputException(
                    "alert.zones." + name + ": there is no ground below it from which its height could be measured");
        }
        return new AreaZone(name, area, lowest + area.floor(), highest + area.height());
    }

    /**
     * The zone of a given name in plan view, with top and bottom at 0: an area from the settings, or the sphere as a
     * circle under the name {@link Protection#ZONE}; empty when there is no zone of that name.
     */
    public static Optional<AreaZone> inPlan(String name, AlertSettings alert) {
        Optional<ProtectedArea> area = Optional.ofNullable(alert.zones().get(name));
        return area.or(() -> alert.protect()
                        .filter(ball -> name.equals(Protection.ZONE))
                        .map(ball -> ProtectedArea.circle(
                                new GroundPoint(ball.centre().x(), ball.centre().y()), ball.radius(), ball.radius())))
                .map(its -> new AreaZone(name, its, 0.0, 0.0));
    }

    /** The names of the zones that {@link #inPlan} finds: those of the areas, then that of the sphere, if any. */
    public static List<String> namesInPlan(AlertSettings alert) {
        List<String> names = new ArrayList<>(alert.zones().keySet());
        alert.protect().ifPresent(ball -> names.add(Protection.ZONE));
        return names;
    }

    /** The corners of the zone's outline; a circle is approximated by a polygon whose corners lie on it. */
    public List<GroundPoint> outline() {
        if (!settings.area().isEmpty()) {
            return settings.area();
        }
        GroundPoint centre = settings.centre().orElseThrow();
        double radius = settings.radius().orElseThrow();
        List<GroundPoint> corners = new ArrayList<>();
        for (int i = 0; i < SIDES; i++) {
            double angle = 2.0 * Math.PI * i / SIDES;
            corners.add(new GroundPoint(
                    centre.x() + radius * StrictMath.cos(angle), centre.y() + radius * StrictMath.sin(angle)));
        }
        return corners;
    }

    /** The distance from a point to the zone's surface, m; 0 inside. */
    public double distance(Position position) {
        double above = Math.max(0.0, Math.max(bottom - position.z(), position.z() - top));
        return Math.hypot(above, beside(position.x(), position.y()));
    }

    /** Whether a point in plan view lies within the zone's outline. */
    public boolean covers(double x, double y) {
        return beside(x, y) == 0.0;
    }

    /** The distance in plan view, m; 0 inside. */
    private double beside(double x, double y) {
        if (settings.area().isEmpty()) {
            GroundPoint centre = settings.centre().orElseThrow();
            return Math.max(
                    0.0,
                    Math.hypot(x - centre.x(), y - centre.y())
                            - settings.radius().orElseThrow());
        }
        boolean isInside = false;
        double nearest = Double.POSITIVE_INFINITY;
        GroundPoint a = settings.area().get(settings.area().size() - 1);
        for (GroundPoint b : settings.area()) {
            if (a.y() > y != b.y() > y) {
                isInside ^= x < b.x() + (y - b.y()) / (a.y() - b.y()) * (a.x() - b.x());
            }
            double dx = b.x() - a.x();
            double dy = b.y() - a.y();
            double length = dx * dx + dy * dy;
            double share = length > 0.0 ? ((x - a.x()) * dx + (y - a.y()) * dy) / length : 0.0;
            double along = Math.min(1.0, Math.max(0.0, share));
            nearest = Math.min(nearest, Math.hypot(x - a.x() - along * dx, y - a.y() - along * dy));
            a = b;
        }
        return isInside ? 0.0 : nearest;
    }

    /**
     * The position along a straight segment at which the zone's surface is first reached.
     *
     * @param from start of the segment, m
     * @param to end of the segment, m
     * @return fraction of the segment before that position, 0 when the segment begins inside; empty when it stays
     *     outside
     */
    public OptionalDouble entry(Position from, Position to) {
        double first = 0.0;
        double last = 1.0;
        double climb = to.z() - from.z();
        if (climb == 0.0) {
            if (from.z() < bottom || from.z() > top) {
                return OptionalDouble.empty();
            }
        } else {
            double one = (bottom - from.z()) / climb;
            double other = (top - from.z()) / climb;
            first = Math.max(first, Math.min(one, other));
            last = Math.min(last, Math.max(one, other));
        }
        if (first > last) {
            return OptionalDouble.empty();
        }
        double dx = to.x() - from.x();
        double dy = to.y() - from.y();
        if (beside(from.x() + first * dx, from.y() + first * dy) == 0.0) {
            return OptionalDouble.of(first);
        }
        double share = settings.area().isEmpty() ? circle(from, dx, dy) : sides(from, dx, dy, first);
        return share >= first && share <= last ? OptionalDouble.of(share) : OptionalDouble.empty();
    }

    /**
     * The position at which a line from outside first meets the circle, as a fraction of the line; NaN if it does not.
     */
    private double circle(Position from, double dx, double dy) {
        GroundPoint centre = settings.centre().orElseThrow();
        double cx = centre.x() - from.x();
        double cy = centre.y() - from.y();
        double radius = settings.radius().orElseThrow();
        double a = dx * dx + dy * dy;
        double b = dx * cx + dy * cy;
        double left = b * b - a * (cx * cx + cy * cy - radius * radius);
        return a > 0.0 ? (b - Math.sqrt(left)) / a : Double.NaN;
    }

    /**
     * The position at which a line first crosses a side of the polygon, as a fraction of the line that is not below a
     * given one; infinity if it does not.
     */
    private double sides(Position from, double dx, double dy, double first) {
        double nearest = Double.POSITIVE_INFINITY;
        GroundPoint a = settings.area().get(settings.area().size() - 1);
        for (GroundPoint b : settings.area()) {
            double ex = b.x() - a.x();
            double ey = b.y() - a.y();
            double across = dx * ey - dy * ex;
            if (across != 0.0) {
                double share = ((a.x() - from.x()) * ey - (a.y() - from.y()) * ex) / across;
                double along = ((a.x() - from.x()) * dy - (a.y() - from.y()) * dx) / across;
                if (share >= first && along >= 0.0 && along <= 1.0) {
                    nearest = Math.min(nearest, share);
                }
            }
            a = b;
        }
        return nearest;
    }
}
