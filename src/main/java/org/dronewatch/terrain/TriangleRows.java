package org.dronewatch.terrain;

/** The posts of a triangle row by row, those on its edges included. */
final class TriangleRows {
    private final long[] a = new long[3];
    private final long[] b = new long[3];
    private final long[] c = new long[3];
    private final int first;
    private final int last;
    private final int columns;
    private int west;
    private int east;

    TriangleRows(int columns, int... corners) {
        this.columns = columns;
        for (int k = 0; k < 3; k++) {
            long x = corners[k] % columns;
            long y = corners[k] / columns;
            int next = corners[(k + 1) % 3];
            long dx = next % columns - x;
            long dy = next / columns - y;
            // Twice the area with a point to the right of the edge: -dy x + dx y + c.
            a[k] = -dy;
            b[k] = dx;
            c[k] = dy * x - dx * y;
        }
        first = Math.min(corners[0], Math.min(corners[1], corners[2])) / columns;
        last = Math.max(corners[0], Math.max(corners[1], corners[2])) / columns;
    }

    int first() {
        return first;
    }

    int last() {
        return last;
    }

    /** Finds where a row begins and ends in the triangle. */
    void to(int row) {
        long low = 0;
        long high = columns - 1;
        for (int k = 0; k < 3; k++) {
            long rest = b[k] * row + c[k];
            if (a[k] > 0) {
                low = Math.max(low, -Math.floorDiv(rest, a[k]));
            } else if (a[k] < 0) {
                high = Math.min(high, Math.floorDiv(rest, -a[k]));
            }
        }
        west = (int) low;
        east = (int) high;
    }

    int west() {
        return west;
    }

    int east() {
        return east;
    }
}
