package org.dronewatch.sensor.radio;

import java.util.Arrays;
import org.dronewatch.geometry.CutTriangle;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.EllipsoidQuery;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The section of a site in a plane through two points: the straight pieces in which the plane cuts triangles, in
 * coordinates u along the line from the first point to the second and t across it, m. Pieces that share an edge of the
 * mesh share a point, and so do pieces that meet where a corner lies on the edge of another triangle. Those that are
 * connected on one side of the line form one body there, so that the two sides of a valley with an antenna in it are
 * two bodies. If the plane passes through corners of the mesh, it is treated as if it lay an infinitesimal distance to
 * one side of them. For use by one thread.
 */
final class Section {
    /** Corners nearer to the plane than this, m, lie on it. */
    private static final double ON_PLANE = 1e-7;

    /**
     * A body counts as complete only if it lies at least this far inside the ellipsoid, m, since its points are
     * rounded.
     */
    private static final double ROUNDING = 1e-6;

    private final EllipsoidQuery query;
    private final SectionPoints points;
    private final SectionPieces pieces = new SectionPieces();
    private final CutTriangle piece;

    private Position origin;
    private Position ahead;
    private Position side;
    private double length;

    /** For each point, another point of the same body; following these links leads to the body's representative. */
    private int[] body = new int[64];

    /** Whether the body that a point represents ends at the line. */
    private boolean[] blocks = new boolean[64];

    /** Whether the body goes on, above the line or below, beyond an end of the line. */
    private boolean[] endsAbove = new boolean[64];

    private boolean[] endsBelow = new boolean[64];

    /** Whether the body goes on, above the line or below, beyond the ellipsoid between the ends of the line. */
    private boolean[] outsideAbove = new boolean[64];

    private boolean[] outsideBelow = new boolean[64];

    /** Whether more of the body may lie beyond the ellipsoid, even if only behind an end of the line. */
    private boolean[] isPartial = new boolean[64];

    private boolean isBlocked;

    Section(World world) {
        query = new EllipsoidQuery(world.tree());
        points = new SectionPoints(CutTriangle.touching(world.mesh()));
        piece = new CutTriangle(query::coordinate, ON_PLANE);
    }

    /**
     * Cuts the triangles that reach into an ellipsoid with the two ends of a line as its foci.
     *
     * @param from the beginning of the line
     * @param to the end of the line
     * @param direction unit vector along the line
     * @param across the direction in the plane that is perpendicular to the line and in which t increases, of length 1
     * @param sum sum of the distances of a point on the ellipsoid from both ends, m
     */
    void cut(Position from, Position to, Position direction, Position across, double sum) {
        origin = from;
        ahead = direction;
        side = across;
        length = from.distance(to);
        points.clear();
        pieces.clear();
        Position normal = direction.cross(across);
        query.findAtPlane(from, to, sum, normal, ON_PLANE);
        for (int i = 0; i < query.count(); i++) {
            cut(i, normal);
        }
        describeBodies(sum);
    }

    /** Cuts one of the triangles that the query found. */
    private void cut(int number, Position normal) {
        if (!piece.cut(number, origin, normal)) {
            return;
        }
        int first = point(piece.first());
        int second = point(piece.second());
        if (first == second) {
            return;
        }
        pieces.add(first, second, query.triangle(number));
        if (isAbove(first) == isAbove(second)) {
            body[representative(first)] = representative(second);
        }
    }

    private boolean isAbove(int point) {
        return points.t(point) > 0.0;
    }

    private int point(double[] at) {
        int before = points.count();
        int number = points.number(along(at, ahead), along(at, side));
        if (number == before) {
            if (number == body.length) {
                grow(2 * number);
            }
            body[number] = number;
            pieces.addPoint(number);
        }
        return number;
    }

    private void grow(int size) {
        body = Arrays.copyOf(body, size);
        blocks = new boolean[size];
        endsAbove = new boolean[size];
        endsBelow = new boolean[size];
        outsideAbove = new boolean[size];
        outsideBelow = new boolean[size];
        isPartial = new boolean[size];
    }

    private static double along(double[] vector, Position unit) {
        return vector[0] * unit.x() + vector[1] * unit.y() + vector[2] * unit.z();
    }

    private int representative(int point) {
        int at = point;
        while (body[at] != at) {
            body[at] = body[body[at]];
            at = body[at];
        }
        return at;
    }

    private void describeBodies(double sum) {
        int all = points.count();
        for (boolean[] flags : new boolean[][] {blocks, endsAbove, endsBelow, outsideAbove, outsideBelow, isPartial}) {
            Arrays.fill(flags, 0, all, false);
        }
        isBlocked = false;
        for (int i = 0; i < all; i++) {
            body[i] = representative(i);
        }
        for (int i = 0; i < all; i++) {
            describePoint(i, sum);
        }
        for (int i = 0; i < pieces.count(); i++) {
            describePiece(pieces.start(i), pieces.end(i));
        }
    }

    private void describePoint(int i, double sum) {
        double u = points.u(i);
        double t = points.t(i);
        double beyond = length - u;
        int whole = body[i];
        // Anything that rises behind an antenna obstructs nothing.
        if (!(u > 0.0 && beyond > 0.0)) {
            isPartial[whole] = true;
            return;
        }
        // Quicker than hypot, which is needed only at the boundary.
        double about = Math.sqrt(u * u + t * t) + Math.sqrt(beyond * beyond + t * t);
        if (about < sum - 2.0 * ROUNDING) {
            return;
        }
        double detour = Math.hypot(u, t) + Math.hypot(beyond, t);
        isPartial[whole] |= detour > sum - ROUNDING;
        outsideAbove[whole] |= detour > sum && t > 0.0;
        outsideBelow[whole] |= detour > sum && t < 0.0;
    }

    private void describePiece(int a, int b) {
        findEnd(a, b, 0.0);
        findEnd(a, b, length);
        if (isAbove(a) != isAbove(b)) {
            double ta = points.t(a);
            double along = points.u(a) - ta * (points.u(b) - points.u(a)) / (points.t(b) - ta);
            boolean isBetween = along > Visibility.MARGIN && along < length - Visibility.MARGIN;
            blocks[body[a]] |= isBetween;
            blocks[body[b]] |= isBetween;
            isBlocked |= isBetween;
        }
    }

    private void findEnd(int a, int b, double end) {
        double ua = points.u(a);
        double ub = points.u(b);
        if (ua < end != ub < end) {
            double ta = points.t(a);
            double there = ta + (end - ua) * (points.t(b) - ta) / (ub - ua);
            int whole = body[isAbove(a) == there > 0.0 ? a : b];
            endsAbove[whole] |= there > Visibility.MARGIN;
            endsBelow[whole] |= there < -Visibility.MARGIN;
        }
    }

    /** Whether something crosses the line. */
    boolean isBlocked() {
        return isBlocked;
    }

    /** Length of the line, m. */
    double length() {
        return length;
    }

    int points() {
        return points.count();
    }

    double u(int point) {
        return points.u(point);
    }

    double t(int point) {
        return points.t(point);
    }

    /** The point that represents the body to which a point belongs. */
    int body(int point) {
        return body[point];
    }

    /** Whether a body ends at the line, between its ends. */
    boolean blocks(int whole) {
        return blocks[whole];
    }

    /**
     * Whether a body goes on, above the line or below, beyond an end of the line or beyond the part of the site that
     * was cut: no path leads round such a body.
     */
    boolean isOpen(int whole, boolean above) {
        return isEnding(whole, above) || (above ? outsideAbove[whole] : outsideBelow[whole]);
    }

    /**
     * Whether a body goes on, above the line or below, beyond an end of the line, however large the part of the site
     * that is cut.
     */
    boolean isEnding(int whole, boolean above) {
        return above ? endsAbove[whole] : endsBelow[whole];
    }

    /** Whether there may be more of a body, on one side of the line, than the part that was cut. */
    boolean isPartial(int whole, boolean above) {
        return isPartial[whole] && isAbove(whole) == above;
    }

    /** The pieces in which the plane cuts triangles, by the numbers of their points. */
    SectionPieces pieces() {
        return pieces;
    }
}
