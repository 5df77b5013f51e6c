package org.dronewatch.sensor.radio;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.dronewatch.geometry.CutTriangle;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.EllipsoidQuery;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The section of a site in a plane through two points: the straight pieces in which the plane cuts triangles, in
 * coordinates u along the line from the first point to the second and t across it, m. Pieces that share an edge of the
 * mesh share a point; those that are connected on one side of the line form one body there, so that the two sides of a
 * valley with an antenna in it are two. A plane through corners is taken for one an infinitesimal distance beside it.
 * One per thread.
 */
final class Section {
    /** Corners nearer to the plane than this, m, lie on it. */
    private static final double ON_PLANE = 1e-7;

    private record Point(double u, double t) {}

    private final TriangleMesh mesh;
    private final EllipsoidQuery query;
    private final Map<Point, Integer> known = new HashMap<>();
    private final CutTriangle piece;

    private Position origin;
    private Position ahead;
    private Position side;
    private double length;

    private double[] u = new double[64];
    private double[] t = new double[64];

    /** Leads from each point to one of the same body, in the end to its representative. */
    private int[] body = new int[64];

    private int points;

    /** The two points and the triangle of each piece. */
    private int[] pieces = new int[192];

    private int count;

    /** Whether the body that a point represents ends at the line, and whether it goes on beyond what is looked at. */
    private boolean[] blocks = new boolean[64];

    private boolean[] openAbove = new boolean[64];
    private boolean[] openBelow = new boolean[64];
    private boolean isBlocked;

    Section(World world) {
        mesh = world.mesh();
        piece = new CutTriangle(mesh, ON_PLANE);
        query = new EllipsoidQuery(world.tree());
    }

    /**
     * Cuts the triangles that reach into an ellipsoid with the two ends of a line as its foci.
     *
     * @param from the beginning of the line
     * @param to its end
     * @param direction of the line, of length 1
     * @param across in the plane, perpendicular to that, of length 1: t grows that way
     * @param sum of the distances from both ends of a point on the ellipsoid, m
     */
    void cut(Position from, Position to, Position direction, Position across, double sum) {
        origin = from;
        ahead = direction;
        side = across;
        length = from.distance(to);
        known.clear();
        points = 0;
        count = 0;
        Position normal = direction.cross(across);
        query.findAtPlane(from, to, sum, normal, ON_PLANE);
        for (int i = 0; i < query.count(); i++) {
            cut(query.triangle(i), normal);
        }
        describeBodies(sum);
    }

    private void cut(int triangle, Position normal) {
        if (!piece.cut(triangle, origin, normal)) {
            return;
        }
        int first = point(piece.first());
        int second = point(piece.second());
        if (first == second) {
            return;
        }
        if (3 * count == pieces.length) {
            pieces = Arrays.copyOf(pieces, 6 * count);
        }
        pieces[3 * count] = first;
        pieces[3 * count + 1] = second;
        pieces[3 * count + 2] = triangle;
        count++;
        if (isAbove(first) == isAbove(second)) {
            body[representative(first)] = representative(second);
        }
    }

    private boolean isAbove(int point) {
        return t[point] > 0.0;
    }

    private int point(double[] at) {
        return point(along(at, ahead), along(at, side));
    }

    private static double along(double[] vector, Position unit) {
        return vector[0] * unit.x() + vector[1] * unit.y() + vector[2] * unit.z();
    }

    private int point(double along, double across) {
        Integer there = known.putIfAbsent(new Point(along + 0.0, across + 0.0), points);
        if (there != null) {
            return there;
        }
        if (points == u.length) {
            u = Arrays.copyOf(u, 2 * points);
            t = Arrays.copyOf(t, 2 * points);
            body = Arrays.copyOf(body, 2 * points);
            blocks = new boolean[2 * points];
            openAbove = new boolean[2 * points];
            openBelow = new boolean[2 * points];
        }
        u[points] = along;
        t[points] = across;
        body[points] = points;
        return points++;
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
        Arrays.fill(blocks, 0, points, false);
        Arrays.fill(openAbove, 0, points, false);
        Arrays.fill(openBelow, 0, points, false);
        isBlocked = false;
        for (int i = 0; i < points; i++) {
            double beyond = length - u[i];
            boolean isOutside = Math.hypot(u[i], t[i]) + Math.hypot(beyond, t[i]) > sum;
            // What rises behind an antenna obstructs nothing.
            markOpen(representative(i), isOutside && u[i] > 0.0 && beyond > 0.0, t[i]);
        }
        for (int i = 0; i < count; i++) {
            int a = pieces[3 * i];
            int b = pieces[3 * i + 1];
            for (double end : new double[] {0.0, length}) {
                boolean isCrossed = u[a] < end != u[b] < end;
                double there = isCrossed ? t[a] + (end - u[a]) * (t[b] - t[a]) / (u[b] - u[a]) : 0.0;
                int whole = representative(isAbove(a) == there > 0.0 ? a : b);
                markOpen(whole, isCrossed && Math.abs(there) > Visibility.MARGIN, there);
            }
            if (isAbove(a) != isAbove(b)) {
                double along = u[a] - t[a] * (u[b] - u[a]) / (t[b] - t[a]);
                boolean isBetween = along > Visibility.MARGIN && along < length - Visibility.MARGIN;
                blocks[representative(a)] |= isBetween;
                blocks[representative(b)] |= isBetween;
                isBlocked |= isBetween;
            }
        }
    }

    private void markOpen(int whole, boolean isOpen, double across) {
        openAbove[whole] |= isOpen && across > 0.0;
        openBelow[whole] |= isOpen && across < 0.0;
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
        return points;
    }

    double u(int point) {
        return u[point];
    }

    double t(int point) {
        return t[point];
    }

    /** The point that represents the body to which a point belongs. */
    int body(int point) {
        return representative(point);
    }

    /** Whether a body ends at the line, between its ends. */
    boolean blocks(int whole) {
        return blocks[whole];
    }

    /**
     * Whether a body goes on, above the line or below, beyond an end of it or beyond what was cut: no path leads round
     * it.
     */
    boolean isOpen(int whole, boolean above) {
        return above ? openAbove[whole] : openBelow[whole];
    }

    int pieces() {
        return count;
    }

    int start(int piece) {
        return pieces[3 * piece];
    }

    int end(int piece) {
        return pieces[3 * piece + 1];
    }

    int triangle(int piece) {
        return pieces[3 * piece + 2];
    }
}
