package org.dronewatch.kdtree;

/**
 * Paints triangles into the pixels of a tile, nearest surface wins. One per thread.
 *
 * <p>In the frame of the {@link PixelGrid} the ray of pixel (x, y) has the direction (x, y, 1). The three edge functions of
 * a triangle, whose signs tell inside from outside, and the inverse of the ray parameter are linear in x and y there. Each
 * row of pixels is then an interval between the edges. An edge that two triangles share has exactly opposite values in
 * them, and zero counts as inside: no pixel slips through.
 */
final class TilePainter {
    /** How near to a pixel's centre, in pixels, an edge must pass to be looked at once more. */
    private static final double NEAR_EDGE = 1e-6;
    /** Relative size of the roundings of the volume between the origin and a triangle. */
    private static final double IN_PLANE = 1e-12;

    private final float[] corners;
    private final PixelGrid grid;
    private final TilePixels pixels;
    private boolean lost;

    /**
     * A painter.
     *
     * @param corners nine coordinates a triangle
     * @param grid where the pixels look
     * @param pixels what it paints
     */
    TilePainter(float[] corners, PixelGrid grid, TilePixels pixels) {
        this.corners = corners;
        this.grid = grid;
        this.pixels = pixels;
    }

    /** Begins a tile, after its pixels have. */
    void begin() {
        lost = false;
    }

    /** Whether a triangle came that cannot be painted, since the origin lies in it. */
    boolean isLost() {
        return lost;
    }

    /** Paints a triangle into the tile; gives whether any pixel took it. */
    boolean paint(int triangle) {
        // The corners in grid coordinates, from the tile's own corner.
        float[] c = corners;
        double[] m = grid.toGrid;
        int left = pixels.left();
        int top = pixels.top();
        int base = 9 * triangle;
        double x = c[base] - grid.origin[0];
        double y = c[base + 1] - grid.origin[1];
        double z = c[base + 2] - grid.origin[2];
        double az = m[0] * x + m[1] * y + m[2] * z;
        double ax = m[3] * x + m[4] * y + m[5] * z - left * az;
        double ay = m[6] * x + m[7] * y + m[8] * z - top * az;
        x = c[base + 3] - grid.origin[0];
        y = c[base + 4] - grid.origin[1];
        z = c[base + 5] - grid.origin[2];
        double bz = m[0] * x + m[1] * y + m[2] * z;
        double bx = m[3] * x + m[4] * y + m[5] * z - left * bz;
        double by = m[6] * x + m[7] * y + m[8] * z - top * bz;
        x = c[base + 6] - grid.origin[0];
        y = c[base + 7] - grid.origin[1];
        z = c[base + 8] - grid.origin[2];
        double cz = m[0] * x + m[1] * y + m[2] * z;
        double cx = m[3] * x + m[4] * y + m[5] * z - left * cz;
        double cy = m[6] * x + m[7] * y + m[8] * z - top * cz;
        int lastColumn = pixels.lastColumn();
        int lastRow = pixels.lastRow();
        int fromRow = 0;
        int toRow = lastRow;
        if (az > Double.MIN_NORMAL && bz > Double.MIN_NORMAL && cz > Double.MIN_NORMAL) {
            double ofA = 1.0 / az;
            double ofB = 1.0 / bz;
            double ofC = 1.0 / cz;
            double low = Math.min(ax * ofA, Math.min(bx * ofB, cx * ofC));
            double high = Math.max(ax * ofA, Math.max(bx * ofB, cx * ofC));
            double upper = Math.min(ay * ofA, Math.min(by * ofB, cy * ofC));
            double lower = Math.max(ay * ofA, Math.max(by * ofB, cy * ofC));
            int fromColumn = atOrAfter(Math.max(low, 0.0));
            int toColumn = atOrBefore(Math.min(high, lastColumn));
            fromRow = atOrAfter(Math.max(upper, 0.0));
            toRow = atOrBefore(Math.min(lower, lastRow));
            if (fromColumn > toColumn || fromRow > toRow) {
                return false;
            }
            if (fromRow == toRow && toColumn - fromColumn <= 1) {
                double nearestCorner = Math.max(ofA, Math.max(ofB, ofC)) * (1.0 + IN_PLANE);
                if (!pixels.anyBeyond(nearestCorner, fromColumn, toColumn, fromRow, toRow)) {
                    return false;
                }
            }
        } else if (ax < 0.0 && bx < 0.0 && cx < 0.0
                || ay < 0.0 && by < 0.0 && cy < 0.0
                || ax > lastColumn * az && bx > lastColumn * bz && cx > lastColumn * cz
                || ay > lastRow * az && by > lastRow * bz && cy > lastRow * cz) {
            return false;
        }

        // The triangle's plane, and the inverse ray parameter of each pixel on it: r + x * rx + y * ry.
        double nx = (by - ay) * (cz - az) - (bz - az) * (cy - ay);
        double ny = (bz - az) * (cx - ax) - (bx - ax) * (cz - az);
        double nz = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        double volume = ax * nx + ay * ny + az * nz;
        if (Math.abs(volume) <= IN_PLANE * (Math.abs(ax * nx) + Math.abs(ay * ny) + Math.abs(az * nz))
                && mayHoldOrigin(triangle)) {
            // Every pixel sees it at no distance, and the edge functions say nothing: single rays know.
            lost = true;
            return false;
        }
        double inverse = 1.0 / volume;
        double r = nz * inverse;
        double rx = nx * inverse;
        double ry = ny * inverse;
        if (!(r + Math.max(0.0, lastColumn * rx) + Math.max(0.0, lastRow * ry) > pixels.leastInverse())) {
            return false;
        }

        // Edge functions, turned so that inside is above zero for what lies before the origin.
        double turn = volume < 0.0 ? -1.0 : 1.0;
        double ex = turn * (by * cz - bz * cy);
        double ey = turn * (bz * cx - bx * cz);
        double e = turn * (bx * cy - by * cx);
        double fx = turn * (cy * az - cz * ay);
        double fy = turn * (cz * ax - cx * az);
        double f = turn * (cx * ay - cy * ax);
        double gx = turn * (ay * bz - az * by);
        double gy = turn * (az * bx - ax * bz);
        double g = turn * (ax * by - ay * bx);
        if (e + Math.max(0.0, lastColumn * ex) + Math.max(0.0, lastRow * ey) < 0.0
                || f + Math.max(0.0, lastColumn * fx) + Math.max(0.0, lastRow * fy) < 0.0
                || g + Math.max(0.0, lastColumn * gx) + Math.max(0.0, lastRow * gy) < 0.0) {
            return false;
        }

        double atE = -1.0 / ex;
        double atF = -1.0 / fx;
        double atG = -1.0 / gx;
        boolean taken = false;
        for (int row = fromRow; row <= toRow; row++) {
            // The columns between the edges; a rising edge function bounds them from the left.
            double eRow = e + row * ey;
            double fRow = f + row * fy;
            double gRow = g + row * gy;
            double from = 0.0;
            double to = lastColumn;
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
            taken |= first <= last && pixels.paint(row, first, last, r + row * ry, rx, triangle);
        }
        return taken;
    }

    private boolean mayHoldOrigin(int triangle) {
        boolean inside = true;
        for (int axis = 0; axis < 3; axis++) {
            float a = corners[9 * triangle + axis];
            float b = corners[9 * triangle + 3 + axis];
            float c = corners[9 * triangle + 6 + axis];
            inside &= grid.origin[axis] >= Math.min(a, Math.min(b, c))
                    && grid.origin[axis] <= Math.max(a, Math.max(b, c));
        }
        return inside;
    }

    /** The first pixel at or after a place of zero or more. */
    private static int atOrAfter(double place) {
        return (int) (place + (1.0 - NEAR_EDGE));
    }

    /** The last pixel at or before a place; -1 for all places before the first pixel, however far. */
    private static int atOrBefore(double place) {
        return place > -NEAR_EDGE ? (int) (place + NEAR_EDGE) : -1;
    }
}
