package org.dronewatch.terrain;

import java.util.Arrays;

/**
 * A Delaunay triangulation of posts of a grid, to which posts are added one at a time (Lawson, Software for C1 surface
 * interpolation, 1977). Column and row are whole numbers, so that every decision is exact. Four posts of one square are
 * joined along its north-west diagonal; four other posts on one circle keep the diagonal that they have.
 *
 * <p>The corners of a triangle run in the sense from east, the direction of columns, to south, that of rows: clockwise
 * on a map whose rows go south. Not thread-safe.
 */
final class Triangulation {
    /** The sums of the circle's test stay within 63 bits up to here. */
    static final int MAX_SIDE = 20_000;

    private static final int NONE = -1;

    /** Triangles to begin a search from lie in the squares of a coarse grid. */
    private static final int BUCKETS = 128;

    private final int columns;
    private final int rows;
    private final int[] hints = new int[BUCKETS * BUCKETS];

    /** Three posts of each triangle, by row * columns + column. */
    private int[] corners;

    /** The triangle beyond the edge opposite to each corner. */
    private int[] neighbours;

    private int count;

    private final TriangleStack toCheck = new TriangleStack();
    private final TriangleStack touched = new TriangleStack();

    /** The two triangles of a rectangle of posts, whose four corners are in the triangulation from the start. */
    Triangulation(int columns, int rows) {
        this.columns = columns;
        this.rows = rows;
        corners = new int[3 * 1024];
        neighbours = new int[3 * 1024];
        int east = columns - 1;
        int south = (rows - 1) * columns;
        set(0, 0, east, south + east, NONE, 1, NONE);
        set(1, 0, south + east, south, NONE, NONE, 0);
        count = 2;
    }

    int count() {
        return count;
    }

    int corner(int triangle, int k) {
        return corners[3 * triangle + k];
    }

    /** The triangles that the last post made or changed: it is a corner of each. */
    TriangleStack touched() {
        return touched;
    }

    private void set(int t, int a, int b, int c, int beyondA, int beyondB, int beyondC) {
        int at = 3 * t;
        corners[at] = a;
        corners[at + 1] = b;
        corners[at + 2] = c;
        neighbours[at] = beyondA;
        neighbours[at + 1] = beyondB;
        neighbours[at + 2] = beyondC;
    }

    private int newTriangle() {
        if (3 * count == corners.length) {
            corners = Arrays.copyOf(corners, 2 * corners.length);
            neighbours = Arrays.copyOf(neighbours, 2 * neighbours.length);
        }
        return count++;
    }

    /** Twice the area of three posts: positive where they run as the corners of triangles do. */
    private long area(int a, int b, int c) {
        long ax = a % columns;
        long ay = a / columns;
        return (b % columns - ax) * (c / columns - ay) - (b / columns - ay) * (c % columns - ax);
    }

    /** A triangle that holds a post, perhaps on its edge. */
    int find(int post) {
        int bucket = bucket(post);
        int t = hints[bucket];
        while (true) {
            int next = NONE;
            for (int k = 0; k < 3 && next == NONE; k++) {
                if (area(corners[3 * t + (k + 1) % 3], corners[3 * t + (k + 2) % 3], post) < 0) {
                    next = neighbours[3 * t + k];
                }
            }
            if (next == NONE) {
                hints[bucket] = t;
                return t;
            }
            t = next;
        }
    }

    private int bucket(int post) {
        return (int) ((long) (post / columns) * BUCKETS / rows) * BUCKETS
                + (int) ((long) (post % columns) * BUCKETS / columns);
    }

    /**
     * Adds a post.
     *
     * @param triangle that holds it, perhaps on an edge; it is none of the corners
     */
    void insert(int post, int triangle) {
        touched.clear();
        toCheck.clear();
        int onEdge = NONE;
        for (int k = 0; k < 3; k++) {
            if (area(corners[3 * triangle + (k + 1) % 3], corners[3 * triangle + (k + 2) % 3], post) == 0) {
                onEdge = k;
            }
        }
        if (onEdge == NONE) {
            splitInThree(post, triangle);
        } else {
            splitEdge(post, triangle, onEdge);
        }
        while (!toCheck.isEmpty()) {
            legalise(toCheck.pop());
        }
        hints[bucket(post)] = touched.get(0);
    }

    private void splitInThree(int post, int t) {
        int a = corners[3 * t];
        int b = corners[3 * t + 1];
        int c = corners[3 * t + 2];
        int beyondA = neighbours[3 * t];
        int beyondB = neighbours[3 * t + 1];
        int beyondC = neighbours[3 * t + 2];
        int u = newTriangle();
        int v = newTriangle();
        set(t, post, b, c, beyondA, u, v);
        set(u, post, c, a, beyondB, v, t);
        set(v, post, a, b, beyondC, t, u);
        replace(beyondB, t, u);
        replace(beyondC, t, v);
        check(t);
        check(u);
        check(v);
    }

    /** Splits the edge opposite to corner k, with the triangles on either side of it. */
    private void splitEdge(int post, int t, int k) {
        int a = corners[3 * t + k];
        int b = corners[3 * t + (k + 1) % 3];
        int c = corners[3 * t + (k + 2) % 3];
        int other = neighbours[3 * t + k];
        int beyondB = neighbours[3 * t + (k + 1) % 3];
        int beyondC = neighbours[3 * t + (k + 2) % 3];
        int u = newTriangle();
        // t keeps the side of b, u takes that of c.
        set(t, post, a, b, beyondC, NONE, u);
        set(u, post, c, a, beyondB, t, NONE);
        replace(beyondB, t, u);
        if (other != NONE) {
            int j = indexOfNeighbour(other, t);
            int d = corners[3 * other + j];
            // Seen from there the edge runs from c to b.
            int beyondC2 = neighbours[3 * other + (j + 1) % 3];
            int beyondB2 = neighbours[3 * other + (j + 2) % 3];
            int v = newTriangle();
            set(other, post, d, c, beyondB2, u, v);
            set(v, post, b, d, beyondC2, other, t);
            replace(beyondC2, other, v);
            neighbours[3 * t + 1] = v;
            neighbours[3 * u + 2] = other;
            check(other);
            check(v);
        }
        check(t);
        check(u);
    }

    private void check(int t) {
        toCheck.push(t);
        touched.push(t);
    }

    private void replace(int triangle, int former, int now) {
        if (triangle != NONE) {
            neighbours[3 * triangle + indexOfNeighbour(triangle, former)] = now;
        }
    }

    private int indexOfNeighbour(int triangle, int neighbour) {
        int at = 3 * triangle;
        return neighbours[at] == neighbour ? 0 : neighbours[at + 1] == neighbour ? 1 : 2;
    }

    /** Turns the edge opposite to the new post, which is the first corner, if that makes the triangles better. */
    private void legalise(int t) {
        int u = neighbours[3 * t];
        if (u == NONE) {
            return;
        }
        int j = indexOfNeighbour(u, t);
        int post = corners[3 * t];
        int a = corners[3 * t + 1];
        int b = corners[3 * t + 2];
        int d = corners[3 * u + j];
        long inside = inCircle(post, a, b, d);
        if (inside < 0 || inside == 0 && !isSquareCutTheOtherWay(post, a, b, d)) {
            return;
        }
        // Seen from u the edge runs from b to a.
        int beyondB = neighbours[3 * u + (j + 1) % 3];
        int beyondA = neighbours[3 * u + (j + 2) % 3];
        int atA = neighbours[3 * t + 1];
        int atB = neighbours[3 * t + 2];
        set(t, post, a, d, beyondB, u, atB);
        set(u, post, d, b, beyondA, atA, t);
        replace(beyondB, u, t);
        replace(atA, t, u);
        toCheck.push(t);
        toCheck.push(u);
        touched.push(u);
    }

    /** Whether the edge from a to b is the north-east diagonal of the square that the four posts are. */
    private boolean isSquareCutTheOtherWay(int post, int a, int b, int d) {
        int dx = a % columns - b % columns;
        int dy = a / columns - b / columns;
        int ex = post % columns - d % columns;
        int ey = post / columns - d / columns;
        return dx * dy == -1 && ex * ey == 1;
    }

    /** Positive where d lies inside the circle through a, b and c, zero on it. */
    private long inCircle(int a, int b, int c, int d) {
        long dx = d % columns;
        long dy = d / columns;
        long ax = a % columns - dx;
        long ay = a / columns - dy;
        long bx = b % columns - dx;
        long by = b / columns - dy;
        long cx = c % columns - dx;
        long cy = c / columns - dy;
        return (ax * ax + ay * ay) * (bx * cy - by * cx)
                + (bx * bx + by * by) * (cx * ay - cy * ax)
                + (cx * cx + cy * cy) * (ax * by - ay * bx);
    }
}
