package org.dronewatch.sensor.acoustic.edge;

import java.util.Arrays;

/**
 * The shortest path between two points around the outline of obstacles in a plane: a taut string. It is straight from
 * corner to corner of the outline, and at each corner it bends around the outline without crossing it. It is found by
 * A* over such legs. For use by one thread.
 */
final class RubberBand {
    /**
     * Distance at which the path passes a corner, m. This distance keeps legs that run along a face off that face; gaps
     * narrower than twice this distance are closed. It does not affect the lengths of paths.
     */
    private static final double PASSING = 5e-5;

    /**
     * Tolerance of the test whether the path bends around a corner, rad: a leg may enter the faces at its ends at up to
     * this angle, and the path may bend away from them by up to this angle.
     */
    private static final double TOUCHING = 1e-3;

    /**
     * A search that compares legs with pieces more often than this is abandoned: there may be no path, for instance out
     * of a closed building. None of 600 paths between random positions in a cathedral needs more.
     */
    private static final int MOST_COMPARISONS = 100_000;

    /**
     * The node at which the path begins; it ends at the last node, and the other nodes are the corners round which it
     * may go.
     */
    private static final int ORIGIN = 0;

    private int nodes;
    private int[] point = new int[64];
    private double[] u = new double[64];
    private double[] v = new double[64];
    private double[] passingU = new double[64];
    private double[] passingV = new double[64];
    private double[] toEnd = new double[64];
    private double[] length = new double[64];
    private int[] before = new int[64];
    private boolean[] closed = new boolean[64];

    private CutOutline cut;
    private final PieceStrips strips = new PieceStrips();

    private double pathLength;
    private int[] path = new int[16];
    private int corners;

    /**
     * Searches for the shortest path from the origin to a point on the u axis.
     *
     * @param outline the outline, which may not be crossed
     * @param distance distance of the far end, m
     * @param limit maximum length of a path, m
     * @return whether one was found
     */
    boolean find(CutOutline outline, double distance, double limit) {
        cut = outline;
        collectNodes(distance, limit);
        strips.sort(outline, distance, limit);
        int end = nodes - 1;
        closed[ORIGIN] = true;
        relax(ORIGIN, limit);
        while (strips.comparisons() < MOST_COMPARISONS) {
            int next = -1;
            double shortest = limit;
            for (int i = 1; i < nodes; i++) {
                if (!closed[i] && length[i] + toEnd[i] <= shortest) {
                    shortest = length[i] + toEnd[i];
                    next = i;
                }
            }
            if (next < 0) {
                return false;
            }
            closed[next] = true;
            if (next == end) {
                remember(end);
                return true;
            }
            if (!isInGap(next)) {
                relax(next, limit);
            }
        }
        return false;
    }

    /** Whether a piece ends at a corner so close to the next one that the path cannot pass between them. */
    private boolean isInGap(int node) {
        if (!cut.cone(point[node]).isOfOnePiece()) {
            return false;
        }
        double aheadU = passingU[node] - u[node];
        double aheadV = passingV[node] - v[node];
        return !strips.isClear(
                passingU[node] - aheadV, passingV[node] + aheadU, passingU[node] + aheadV, passingV[node] - aheadU);
    }

    /** Length of the path found last, m. */
    double length() {
        return pathLength;
    }

    /** Number of corners that the path goes round. */
    int corners() {
        return corners;
    }

    /** Coordinate along the line, m, of a corner of the path; 0 is the first from the origin. */
    double u(int corner) {
        return u[path[corner]];
    }

    /** Coordinate across the line, m, of a corner of the path. */
    double v(int corner) {
        return v[path[corner]];
    }

    /** The angle by which the outline bends at a corner of the path, rad. */
    double bend(int corner) {
        int at = point[path[corner]];
        return cut.isOfMesh(at) ? cut.cone(at).bend() : 0.0;
    }

    private void collectNodes(double distance, double limit) {
        reserve(cut.points() + 2);
        nodes = 0;
        add(-1, 0.0, 0.0, 0.0, 0.0, distance);
        for (int i = 0; i < cut.points(); i++) {
            double pu = cut.u(i);
            double pv = cut.v(i);
            double ahead = Math.sqrt((distance - pu) * (distance - pu) + pv * pv);
            Cone cone = cut.cone(i);
            if (Math.sqrt(pu * pu + pv * pv) + ahead <= limit && cone.isCorner()) {
                add(i, pu, pv, pu - PASSING * cone.middleU(), pv - PASSING * cone.middleV(), ahead);
            }
        }
        add(-1, distance, 0.0, distance, 0.0, 0.0);
        Arrays.fill(length, 0, nodes, Double.POSITIVE_INFINITY);
        length[ORIGIN] = 0.0;
        before[ORIGIN] = ORIGIN;
        Arrays.fill(closed, 0, nodes, false);
    }

    private void add(int number, double atU, double atV, double besideU, double besideV, double ahead) {
        point[nodes] = number;
        u[nodes] = atU;
        v[nodes] = atV;
        passingU[nodes] = besideU;
        passingV[nodes] = besideV;
        toEnd[nodes] = ahead;
        nodes++;
    }

    /**
     * Tries the legs from a node to all others, beginning with the leg to the end: once a path is known, only shorter
     * ones matter.
     */
    private void relax(int from, double limit) {
        int end = nodes - 1;
        double beforeU = u[from] - u[before[from]];
        double beforeV = v[from] - v[before[from]];
        double slackBefore = TOUCHING * Math.sqrt(beforeU * beforeU + beforeV * beforeV);
        for (int i = 0; i < end; i++) {
            int to = i == 0 ? end : i;
            if (closed[to]) {
                continue;
            }
            double du = u[to] - u[from];
            double dv = v[to] - v[from];
            double leg = Math.sqrt(du * du + dv * dv);
            double sum = length[from] + leg;
            if (sum < length[to]
                    && sum + toEnd[to] <= Math.min(limit, length[end])
                    && bendsAround(from, du, dv, leg, beforeU * dv - beforeV * du, slackBefore * leg)
                    && bendsAround(to, du, dv, leg, 0.0, 0.0)
                    && strips.isClear(passingU[from], passingV[from], passingU[to], passingV[to])) {
                length[to] = sum;
                before[to] = from;
            }
        }
    }

    /**
     * Whether the outline at a node lies on one side of a leg, to which the path turns there: a taut string has no
     * other legs. Only the shortest path to a node matters, so the turn at its end is known.
     *
     * @param turn positive if the path turns to the left where the leg begins
     * @param slack angle by which it may turn to the wrong side
     */
    private boolean bendsAround(int node, double du, double dv, double leg, double turn, double slack) {
        if (point[node] < 0) {
            return true;
        }
        Cone cone = cut.cone(point[node]);
        double first = du * cone.firstV() - dv * cone.firstU();
        double last = du * cone.lastV() - dv * cone.lastU();
        double touching = TOUCHING * leg;
        boolean isLeft = first >= -touching && last >= -touching;
        boolean isRight = first <= touching && last <= touching;
        return isLeft && turn >= -slack || isRight && turn <= slack;
    }

    private void remember(int end) {
        pathLength = length[end];
        corners = 0;
        for (int i = before[end]; i != ORIGIN; i = before[i]) {
            if (corners == path.length) {
                path = Arrays.copyOf(path, 2 * corners);
            }
            path[corners++] = i;
        }
        for (int i = 0; i < corners / 2; i++) {
            int swap = path[i];
            path[i] = path[corners - 1 - i];
            path[corners - 1 - i] = swap;
        }
    }

    private void reserve(int most) {
        if (u.length < most) {
            int size = 2 * most;
            point = new int[size];
            u = new double[size];
            v = new double[size];
            passingU = new double[size];
            passingV = new double[size];
            toEnd = new double[size];
            length = new double[size];
            before = new int[size];
            closed = new boolean[size];
        }
    }
}
