package org.dronewatch.fusion;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.GroundPoint;

/**
 * An area that drones must not reach, between two heights above the ground: a polygon, or a circle. Its floor is
 * measured from the lowest ground below the area and its top from the highest, so that, on a slope, the area covers the
 * full range of heights everywhere.
 *
 * @param area the 3 to 1000 corners of a polygon, in either winding order; omit it for a circle
 * @param centre the centre of a circle
 * @param radius the radius of a circle, above 0 and at most 100,000 m
 * @param floor height of its floor above the ground, 0 to 100,000 m; 0 unless set
 * @param height height of its top above the ground, above 0 and at most 100,000 m
 */
public record ProtectedArea(
        List<GroundPoint> area,
        Optional<GroundPoint> centre,
        @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) Optional<Double> radius,
        @In(value = Quantity.LENGTH, from = 0, to = In.FARTHEST) double floor,
        @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) double height) {
    private static final int MOST = 1000;

    /** An area smaller than this counts as a line, m2. */
    private static final double SMALLEST = 0.01;

    /** Checks the limits. */
    public ProtectedArea {
        Limits.check(ProtectedArea.class, area, centre, radius, floor, height);
        area = List.copyOf(area);
        if (!(floor < height)) {
            throw new IllegalArgumentException("floor " + floor + " m must be below the height, " + height + " m");
        }
        if (!area.isEmpty()) {
            checkPolygon(area);
        }
    }

    /** An area on the ground without an outline yet. */
    @Defaults("height")
    static ProtectedArea upTo(double height) {
        return new ProtectedArea(List.of(), Optional.empty(), Optional.empty(), 0.0, height);
    }

    /** An area with a polygonal outline, from the ground to a height above it, m. */
    public static ProtectedArea polygon(List<GroundPoint> corners, double height) {
        return new ProtectedArea(corners, Optional.empty(), Optional.empty(), 0.0, height);
    }

    /** An area with a circular outline of a given radius, m, from the ground to a height above it, m. */
    public static ProtectedArea circle(GroundPoint centre, double radius, double height) {
        return new ProtectedArea(List.of(), Optional.of(centre), Optional.of(radius), 0.0, height);
    }

    /** Checks that there is an outline, and only one. */
    void checkOutline(String name) {
        if (!area.isEmpty() && (centre.isPresent() || radius.isPresent())) {
            throw new IllegalArgumentException(
                    name + ": has both an area and a circle: leave out either 'area' or both 'centre' and 'radius'");
        }
        if (area.isEmpty() && (centre.isEmpty() || radius.isEmpty())) {
            throw new IllegalArgumentException(
                    name + ": needs an outline: either 'area', a list of corners, or both 'centre' and 'radius'");
        }
    }

    private static void checkPolygon(List<GroundPoint> corners) {
        int count = corners.size();
        if (count < 3 || count > MOST) {
            throw new IllegalArgumentException(
                    "area has " + Counted.of(count, "corner") + " but must have 3 to " + MOST);
        }
        for (int i = 0; i < count; i++) {
            for (int k = i + 2; k < count; k++) {
                if (cross(corners.get(i), corners.get(i + 1), corners.get(k), corners.get((k + 1) % count))) {
                    throw new IllegalArgumentException(String.format(
                            Locale.ROOT,
                            "area crosses itself: its side from corner %d to %d meets that from corner %d to %d",
                            i + 1,
                            i + 2,
                            k + 1,
                            (k + 1) % count + 1));
                }
            }
        }
        double twice = 0.0;
        for (int i = 1; i + 1 < count; i++) {
            twice += turn(corners.get(0), corners.get(i), corners.get(i + 1));
        }
        if (!(Math.abs(0.5 * twice) >= SMALLEST)) {
            throw new IllegalArgumentException(
                    "area encloses " + Math.abs(0.5 * twice) + " m2 but must enclose at least " + SMALLEST + " m2");
        }
    }

    /** Positive if the path through three points turns left at the second. */
    private static double turn(GroundPoint a, GroundPoint b, GroundPoint c) {
        return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    }

    private static boolean cross(GroundPoint a, GroundPoint b, GroundPoint c, GroundPoint d) {
        return turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
    }
}
