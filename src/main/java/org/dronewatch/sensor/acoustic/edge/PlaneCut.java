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

    private static final int MOST_PARTS = 1000;

    private final TriangleMesh mesh;
    private final EllipsoidQuery query;

    private double[] u = new double[256];
    private double[] v = new double[256];
    private Cone[] cones = new Cone[0];
    private int points;

    /** The most by which the outline is higher or lower than the mesh within an ellipsoid, m. */
    private double greatestSag(double sum) {
        double beyond = 0.5 * (sum - straight);
        return Math.abs(curvature) * Math.max(0.125 * straight * straight, 0.5 * beyond * (straight + beyond));
    }

    /** Whether the mesh has a corner or an edge at a point; others divide pieces that are bent. */
    private boolean[] isOfMesh = new boolean[256];

    private int[] ends = new int[512];
    private int pieces;

    /** Hash table with open addressing: one more than the index of a point, 0 for none. */
    private int[] table = new int[1024];

    private Position origin;
    private Position ahead;
    private Position side;
    private double straight;
    private double curvature;

    /** Corners of the current triangle, relative to the origin, with their heights above the plane. */
    private final double[][] corner = new double[3][3];

    private final double[] height = new double[3];
    private final double[] crossing = new double[3];
    private final double[] surfaceNormal = new double[3];

    /** The points at which the sides of a bent triangle are cut, two for each side at most. */
    private final int[] crossed = new int[6];

    private int crossings;

    /** The pieces of parabolas: both ends, and how much farther across the line the surface is where it is higher by 1 m. */
    private int[] spanEnds = new int[128];

    private double[] steepness = new double[64];
    private int spans;
    private double[] divided = new double[64];

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
        this.curvature = curvature;
        Position normal = ahead.cross(side);
        query.findAtPlane(from, to, sum, normal, ON_PLANE + greatestSag(sum) * Math.abs(normal.z()));
        points = 0;
        pieces = 0;
        reserve(query.count());
        spans = 0;
        for (int i = 0; i < query.count(); i++) {
            if (curvature == 0.0) {
                cut(query.triangle(i), normal);
            } else {
                cutBent(query.triangle(i), normal);
            }
        }
        divideSpans();
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

    /** Whether the mesh has a corner or an edge at a point: not where a piece was only divided. */
    boolean isOfMesh(int point) {
        return isOfMesh[point];
    }

    /** How much higher across the line the outline is than the mesh, at a distance along the line, m. */
    double bulgeAt(double along) {
        return sag(along) * side.z();
    }

    /** How far arcs of sound run below the line, m; continued beyond its ends. */
    private double sag(double along) {
        return 0.5 * curvature * along * (straight - along);
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

    /** Cuts a triangle that is bent as the arcs of sound are, the other way: its sides are parabolas. */
    private void cutBent(int triangle, Position normal) {
        for (int k = 0; k < 3; k++) {
            double[] c = corner[k];
            c[0] = mesh.coordinate(triangle, k, 0) - origin.x();
            c[1] = mesh.coordinate(triangle, k, 1) - origin.y();
            c[2] = mesh.coordinate(triangle, k, 2) - origin.z();
            double over = along(c, normal) + sag(along(c, ahead)) * normal.z();
            height[k] = Math.abs(over) < ON_PLANE ? 0.0 : over;
        }
        crossings = 0;
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3;
            boolean swap = isAfter(corner[k], corner[next]);
            crossBent(swap ? next : k, swap ? k : next, normal.z());
        }
        mesh.normal(triangle, surfaceNormal);
        double across = along(surfaceNormal, side);
        // Surfaces are bent across the line only, as far as the vertical is across it.
        double raised = surfaceNormal[2] - along(surfaceNormal, ahead) * ahead.z();
        // Across the line there is one point of the plane and the surface at each distance along it, or all are at two.
        sortCrossings();
        for (int i = 0; i + 1 < crossings; i += 2) {
            if (crossed[i] != crossed[i + 1]) {
                addSpan(crossed[i], crossed[i + 1], across == 0.0 ? 0.0 : raised / across);
            }
        }
    }

    /** Finds where the plane cuts a bent side: once between corners on either side of it, otherwise twice or not at all. */
    private void crossBent(int one, int other, double vertical) {
        double[] from = corner[one];
        double[] to = corner[other];
        double ofFrom = height[one];
        double ofTo = height[other];
        double run = along(to, ahead) - along(from, ahead);
        // Height over the plane: (1 - t) ofFrom + t ofTo + bow t (1 - t).
        double bow = 0.5 * curvature * run * run * vertical;
        double half = 0.5 * (ofTo - ofFrom + bow);
        double root = Math.sqrt(Math.max(0.0, half * half + bow * ofFrom));
        // Of both roots one is computed without cancellation, and the other from their product.
        double greater = half >= 0.0 ? half + root : half - root;
        double first = bow == 0.0 ? Double.NaN : greater / bow;
        double second = greater == 0.0 ? Double.NaN : -ofFrom / greater;
        if (ofFrom >= 0.0 != ofTo >= 0.0) {
            if (ofFrom == 0.0 || ofTo == 0.0) {
                crossed[crossings++] = bent(ofFrom == 0.0 ? from : to);
            } else {
                boolean isSecond = second >= 0.0 && second <= 1.0;
                crossed[crossings++] = bent(from, to, isSecond ? second : first);
            }
        } else if (root > 0.0 && first > 0.0 && first < 1.0 && second > 0.0 && second < 1.0 && first != second) {
            crossed[crossings++] = bent(from, to, first);
            crossed[crossings++] = bent(from, to, second);
        }
    }

    private int bent(double[] from, double[] to, double fraction) {
        for (int axis = 0; axis < 3; axis++) {
            crossing[axis] = from[axis] + fraction * (to[axis] - from[axis]);
        }
        return bent(crossing);
    }

    private int bent(double[] at) {
        // Only across the line, so that what is straight remains a parabola over u.
        return point(along(at, ahead), along(at, side) + sag(along(at, ahead)) * side.z());
    }

    private void sortCrossings() {
        for (int i = 1; i < crossings; i++) {
            int point = crossed[i];
            int place = i;
            while (place > 0 && u[crossed[place - 1]] > u[point]) {
                crossed[place] = crossed[place - 1];
                place--;
            }
            crossed[place] = point;
        }
    }

    /** Adds what the plane cuts of a bent surface: a piece of a parabola, to be divided once all points of the mesh are known. */
    private void addSpan(int start, int end, double perSag) {
        if (spans == steepness.length) {
            spanEnds = Arrays.copyOf(spanEnds, 4 * spans);
            steepness = Arrays.copyOf(steepness, 2 * spans);
        }
        boolean isForward = u[start] <= u[end];
        spanEnds[2 * spans] = isForward ? start : end;
        spanEnds[2 * spans + 1] = isForward ? end : start;
        steepness[spans] = perSag;
        spans++;
    }

    /**
     * Divides the pieces of parabolas into parts that are nearly straight. They are divided at every point of the mesh that
     * lies on them, too: under a wall on bent ground there must be no gap.
     */
    private void divideSpans() {
        int ofMesh = points;
        for (int span = 0; span < spans; span++) {
            int start = spanEnds[2 * span];
            int end = spanEnds[2 * span + 1];
            double run = u[end] - u[start];
            int parts = Math.min(MOST_PARTS, PathCurvature.pieces(curvature * steepness[span], run));
            int divisions = 0;
            if (divided.length < parts + ofMesh) {
                divided = new double[2 * (parts + ofMesh)];
            }
            for (int part = 1; part < parts; part++) {
                divided[divisions++] = u[start] + run * part / parts;
            }
            for (int point = 0; point < ofMesh && parts > 1; point++) {
                if (u[point] > u[start]
                        && u[point] < u[end]
                        && Math.abs(v[point] - across(span, u[point])) < PathCurvature.EXACT) {
                    divided[divisions++] = u[point];
                }
            }
            Arrays.sort(divided, 0, divisions);
            int before = start;
            for (int division = 0; division < divisions; division++) {
                if (division == 0 || divided[division] != divided[division - 1]) {
                    int next = append(divided[division], across(span, divided[division]), false);
                    addPiece(before, next);
                    before = next;
                }
            }
            addPiece(before, end);
        }
    }

    /** How far across the line a bent surface is, m. */
    private double across(int span, double along) {
        int start = spanEnds[2 * span];
        int end = spanEnds[2 * span + 1];
        double share = (along - u[start]) / (u[end] - u[start]);
        double bow = 0.5 * curvature * (along - u[start]) * (u[end] - along);
        return v[start] + share * (v[end] - v[start]) + steepness[span] * bow;
    }

    private void addPiece(int start, int end) {
        if (2 * pieces + 2 > ends.length) {
            ends = Arrays.copyOf(ends, 2 * ends.length);
        }
        ends[2 * pieces] = start;
        ends[2 * pieces + 1] = end;
        pieces++;
    }

    private static double along(double[] vector, Position unit) {
        return vector[0] * unit.x() + vector[1] * unit.y() + vector[2] * unit.z();
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
        return point(along(at, ahead), along(at, side));
    }

    private int point(double pu, double pv) {
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
        return append(pu, pv, true);
    }

    private int append(double atU, double atV, boolean ofMesh) {
        if (points == u.length) {
            u = Arrays.copyOf(u, 2 * points);
            v = Arrays.copyOf(v, 2 * points);
            isOfMesh = Arrays.copyOf(isOfMesh, 2 * points);
        }
        growCones(points + 1);
        u[points] = atU;
        v[points] = atV;
        isOfMesh[points] = ofMesh;
        return points++;
    }

    /** Makes room for the pieces of this many triangles: at most two points each. */
    private void reserve(int triangles) {
        int most = (curvature == 0.0 ? 2 : 6) * triangles;
        if (u.length < most) {
            u = new double[2 * most];
            v = new double[2 * most];
            isOfMesh = new boolean[2 * most];
        }
        if (ends.length < 2 * most) {
            ends = new int[4 * most];
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
