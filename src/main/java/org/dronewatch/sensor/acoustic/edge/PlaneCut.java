package org.dronewatch.sensor.acoustic.edge;

import java.util.Arrays;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.EllipsoidQuery;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;

/**
 * The outline of a world in a plane through two points, near those points: the straight pieces in which the plane cuts
 * triangles, in coordinates u along the line from the first point to the second and v across it. Pieces that share a
 * corner or an edge of the mesh, by its coordinates, share an end. A plane that runs through corners is taken for one an
 * infinitesimal distance beside it, so that each triangle is cut in one piece or not at all.
 *
 * <p>Where sound runs in arcs, the outline is bent the other way, so that the arcs are straight lines in it; its pieces are
 * divided, as a flat ground becomes a bulge. One per thread.
 */
final class PlaneCut {
    /** Corners nearer to the plane than this, m, lie on it: shorter pieces would have no meaningful direction. */
    private static final double ON_PLANE = 1e-7;

    private final TriangleMesh mesh;
    private final EllipsoidQuery query;

    private double[] u = new double[256];
    private double[] v = new double[256];
    private Cone[] cones = new Cone[0];
    private int points;

    /** Points from this one on divide pieces: the mesh has no corner there. */
    private int firstDividing;

    private int[] ends = new int[512];
    private int pieces;

    /** Hash table with open addressing: one more than the index of a point, 0 for none. */
    private int[] table = new int[1024];

    private Position origin;
    private Position ahead;
    private Position side;
    private double straight;
    private double bulge;

    /** Corners of the current triangle, relative to the origin, with their heights above the plane. */
    private final double[][] corner = new double[3][3];

    private final double[] height = new double[3];
    private final double[] crossing = new double[3];

    PlaneCut(TriangleMesh mesh, EllipsoidQuery query) {
        this.mesh = mesh;
        this.query = query;
    }

    /**
     * Cuts the triangles that reach into an ellipsoid with two points as its foci.
     *
     * @param from the first point
     * @param to the second
     * @param ahead from the first to the second, of length 1
     * @param side in the plane, perpendicular to that, of length 1
     * @param sum of the distances from both points of a point on the ellipsoid, m
     * @param curvature of sound from one point to the other, either way, 1/m
     */
    void cut(Position from, Position to, Position ahead, Position side, double sum, double curvature) {
        this.origin = from;
        this.ahead = ahead;
        this.side = side;
        this.straight = from.distance(to);
        // The part of the vertical that lies in the plane.
        this.bulge = curvature * side.z();
        Position normal = ahead.cross(side);
        query.findAtPlane(from, to, sum, normal, ON_PLANE);
        points = 0;
        pieces = 0;
        reserve(query.count());
        for (int i = 0; i < query.count(); i++) {
            cut(query.triangle(i), normal);
        }
        firstDividing = points;
        if (bulge != 0.0) {
            bend();
        }
        for (int i = 0; i < points; i++) {
            cones[i].clear();
        }
        for (int i = 0; i < pieces; i++) {
            int a = ends[2 * i];
            int b = ends[2 * i + 1];
            double du = u[b] - u[a];
            double dv = v[b] - v[a];
            double length = Math.sqrt(du * du + dv * dv);
            cones[a].add(du / length, dv / length);
            cones[b].add(-du / length, -dv / length);
        }
    }

    /** Bends the outline by as much as arcs of sound are bent, the other way. */
    private void bend() {
        int undivided = pieces;
        for (int piece = 0; piece < undivided; piece++) {
            divide(piece);
        }
        for (int point = 0; point < points; point++) {
            v[point] += PathCurvature.sag(bulge, straight, u[point]);
        }
    }

    /** Divides the part of a piece that is bent into parts that are nearly straight. */
    private void divide(int piece) {
        int start = ends[2 * piece];
        int end = ends[2 * piece + 1];
        double startU = u[start];
        double startV = v[start];
        double along = u[end] - startU;
        double across = v[end] - startV;
        double low = Math.max(0.0, Math.min(startU, u[end]));
        double high = Math.min(straight, Math.max(startU, u[end]));
        if (!(low < high)) {
            return;
        }
        int parts = PathCurvature.pieces(bulge, high - low);
        int before = start;
        for (int cut = 0; cut <= parts; cut++) {
            double nextU = low + (high - low) * (along > 0.0 ? cut : parts - cut) / parts;
            double fraction = (nextU - startU) / along;
            if (fraction > 0.0 && fraction < 1.0) {
                int next = append(nextU, startV + fraction * across);
                ends[2 * piece] = before;
                ends[2 * piece + 1] = next;
                before = next;
                ends = pieces * 2 + 2 > ends.length ? Arrays.copyOf(ends, 2 * ends.length) : ends;
                ends[2 * pieces] = next;
                ends[2 * pieces + 1] = end;
                // The rest is the last piece, of which the next part is cut off.
                piece = pieces;
                pieces++;
            }
        }
    }

    private int append(double atU, double atV) {
        if (points == u.length || points == v.length) {
            u = Arrays.copyOf(u, 2 * points);
            v = Arrays.copyOf(v, 2 * points);
        }
        growCones(points + 1);
        u[points] = atU;
        v[points] = atV;
        return points++;
    }

    /** Whether the mesh has a corner or an edge at a point: not where a piece was only divided. */
    boolean isOfMesh(int point) {
        return point < firstDividing;
    }

    /** How far up across the line a point was moved for arcs to be straight, m. */
    double bulgeAt(double atU) {
        return PathCurvature.sag(bulge, straight, atU);
    }

    /** How many ends of pieces there are. */
    int points() {
        return points;
    }

    double u(int point) {
        return u[point];
    }

    double v(int point) {
        return v[point];
    }

    /** The directions of the pieces that meet at a point. */
    Cone cone(int point) {
        return cones[point];
    }

    /** Number of pieces. */
    int pieces() {
        return pieces;
    }

    /** The point at which a piece begins. */
    int start(int piece) {
        return ends[2 * piece];
    }

    /** The point at which a piece ends. */
    int end(int piece) {
        return ends[2 * piece + 1];
    }

    private void cut(int triangle, Position normal) {
        int above = 0;
        for (int k = 0; k < 3; k++) {
            double[] c = corner[k];
            c[0] = mesh.coordinate(triangle, k, 0) - origin.x();
            c[1] = mesh.coordinate(triangle, k, 1) - origin.y();
            c[2] = mesh.coordinate(triangle, k, 2) - origin.z();
            double over = c[0] * normal.x() + c[1] * normal.y() + c[2] * normal.z();
            height[k] = Math.abs(over) < ON_PLANE ? 0.0 : over;
            above += height[k] >= 0.0 ? 1 : 0;
        }
        if (above == 0 || above == 3) {
            return;
        }
        int alone = 0;
        while (height[alone] >= 0.0 != (above == 1)) {
            alone++;
        }
        int first = crossing(alone, (alone + 1) % 3);
        int second = crossing(alone, (alone + 2) % 3);
        if (first != second) {
            ends[2 * pieces] = first;
            ends[2 * pieces + 1] = second;
            pieces++;
        }
    }

    /** The point at which the plane cuts a side, the same from either end and for both triangles that share the side. */
    private int crossing(int one, int other) {
        double[] p = corner[one];
        double[] q = corner[other];
        if (height[one] == 0.0) {
            return point(p);
        }
        if (height[other] == 0.0) {
            return point(q);
        }
        boolean swap = isAfter(p, q);
        double[] from = swap ? q : p;
        double[] to = swap ? p : q;
        double ofFrom = height[swap ? other : one];
        double ofTo = height[swap ? one : other];
        double fraction = ofFrom / (ofFrom - ofTo);
        for (int axis = 0; axis < 3; axis++) {
            crossing[axis] = from[axis] + fraction * (to[axis] - from[axis]);
        }
        return point(crossing);
    }

    private static boolean isAfter(double[] p, double[] q) {
        return p[0] != q[0] ? p[0] > q[0] : p[1] != q[1] ? p[1] > q[1] : p[2] > q[2];
    }

    private int point(double[] at) {
        double pu = at[0] * ahead.x() + at[1] * ahead.y() + at[2] * ahead.z();
        double pv = at[0] * side.x() + at[1] * side.y() + at[2] * side.z();
        long bits = Double.doubleToLongBits(pu) * 0x9E3779B97F4A7C15L + Double.doubleToLongBits(pv);
        bits *= 0xC2B2AE3D27D4EB4FL;
        int slot = (int) (bits >>> 32) & (table.length - 1);
        while (table[slot] != 0) {
            int known = table[slot] - 1;
            if (u[known] == pu && v[known] == pv) {
                return known;
            }
            slot = (slot + 1) & (table.length - 1);
        }
        table[slot] = points + 1;
        u[points] = pu;
        v[points] = pv;
        return points++;
    }

    /** Makes room for the pieces of this many triangles: at most two points each. */
    private void reserve(int triangles) {
        int most = 2 * triangles;
        if (u.length < most) {
            u = new double[2 * most];
            v = new double[2 * most];
            ends = new int[2 * most];
        }
        growCones(most);
        int slots = Math.max(16, Integer.highestOneBit(Math.max(1, most)) * 4);
        if (table.length != slots) {
            table = new int[slots];
        } else {
            Arrays.fill(table, 0);
        }
    }

    private void growCones(int most) {
        int known = cones.length;
        if (known < most) {
            cones = Arrays.copyOf(cones, 2 * most);
            for (int i = known; i < cones.length; i++) {
                cones[i] = new Cone();
            }
        }
    }
}
