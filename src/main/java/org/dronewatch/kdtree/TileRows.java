package org.dronewatch.kdtree;

/**
 * Paints triangles into a tile row by row, from their functions: the inverse of the ray parameter on the triangle's plane,
 * and three edge functions that are zero or more inside. Each is linear in column and row: its value at the tile's corner,
 * what a column adds, what a row adds. A row of pixels is then an interval between the edges.
 */
final class TileRows {
    /** How near to a pixel's centre, in pixels, an edge must pass to be looked at once more. */
    private static final double NEAR_EDGE = 1e-6;

    private final TilePixels pixels;

    // The inverse of the ray parameter and the edge functions: at the tile's corner, what a column adds, what a row
    // adds.
    private double r;
    private double rx;
    private double ry;
    private double e;
    private double ex;
    private double ey;
    private double f;
    private double fx;
    private double fy;
    private double g;
    private double gx;
    private double gy;

    TileRows(TilePixels pixels) {
        this.pixels = pixels;
    }

    /** Sets the inverse of the ray parameter of the next triangle. */
    void setInverse(double atCorner, double ofColumn, double ofRow) {
        r = atCorner;
        rx = ofColumn;
        ry = ofRow;
    }

    /** Sets its first edge function. */
    void setFirstEdge(double atCorner, double ofColumn, double ofRow) {
        e = atCorner;
        ex = ofColumn;
        ey = ofRow;
    }

    /** Sets its second edge function. */
    void setSecondEdge(double atCorner, double ofColumn, double ofRow) {
        f = atCorner;
        fx = ofColumn;
        fy = ofRow;
    }

    /** Sets its third edge function. */
    void setThirdEdge(double atCorner, double ofColumn, double ofRow) {
        g = atCorner;
        gx = ofColumn;
        gy = ofRow;
    }

    /** Paints the part of the triangle that lies in a rectangle, borders included. */
    void paint(int triangle, int fromColumn, int toColumn, int fromRow, int toRow) {
        double atE = -1.0 / ex;
        double atF = -1.0 / fx;
        double atG = -1.0 / gx;
        for (int row = fromRow; row <= toRow; row++) {
            // The columns between the edges; a rising edge function bounds them from the left.
            double eRow = e + row * ey;
            double fRow = f + row * fy;
            double gRow = g + row * gy;
            double from = fromColumn;
            double to = toColumn;
            double at = eRow * atE;
            if (atE < 0.0) {
                from = at > from ? at : from;
            } else {
                to = at < to ? at : to;
            }
            at = fRow * atF;
            if (atF < 0.0) {
                from = at > from ? at : from;
            } else {
                to = at < to ? at : to;
            }
            at = gRow * atG;
            if (atG < 0.0) {
                from = at > from ? at : from;
            } else {
                to = at < to ? at : to;
            }
            if (from > to + NEAR_EDGE) {
                continue;
            }
            int first = atOrAfter(from);
            int last = atOrBefore(to);
            // Where an edge passes a pixel's centre within rounding, its sign decides.
            if (Math.abs(first - from) <= NEAR_EDGE
                    && first <= last
                    && (eRow + first * ex < 0.0 || fRow + first * fx < 0.0 || gRow + first * gx < 0.0)) {
                first++;
            }
            if (Math.abs(to - last) <= NEAR_EDGE
                    && first <= last
                    && (eRow + last * ex < 0.0 || fRow + last * fx < 0.0 || gRow + last * gx < 0.0)) {
                last--;
            }
            pixels.paint(row, first, last, r + row * ry, rx, triangle);
        }
    }

    /** The first pixel at or after a place of zero or more. */
    static int atOrAfter(double place) {
        return (int) (place + (1.0 - NEAR_EDGE));
    }

    /** The last pixel at or before a place; -1 for all places before the first pixel, however far. */
    static int atOrBefore(double place) {
        return place > -NEAR_EDGE ? (int) (place + NEAR_EDGE) : -1;
    }
}
