package org.dronewatch.kdtree;

import java.util.Arrays;

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

    private int left;
    private int top;
    private int width;
    private int height;

    /** Inverse ray parameter of the nearest surface of each pixel, 0 for none; and which triangle it is. */
    private final double[] nearest;

    private final int[] triangles;
    private int uncovered;
    private double leastInverse;
    private boolean lost;

    /**
     * A painter.
     *
     * @param corners nine coordinates a triangle
     * @param grid where the pixels look; may be set anew between tiles
     * @param pixels the most of a tile
     */
    TilePainter(float[] corners, PixelGrid grid, int pixels) {
        this.corners = corners;
        this.grid = grid;
        this.nearest = new double[pixels];
        this.triangles = new int[pixels];
    }

    /** Begins a tile: no pixel sees anything. */
    void begin(int firstColumn, int firstRow, int columns, int rows) {
        left = firstColumn;
        top = firstRow;
        width = columns;
        height = rows;
        Arrays.fill(nearest, 0, width * height, 0.0);
        uncovered = width * height;
        leastInverse = 0.0;
        lost = false;
    }

    /** The ray parameter of the farthest pixel; infinity while any sees nothing. Slow: for when something was painted. */
    double farthest() {
        if (uncovered > 0) {
            return Double.POSITIVE_INFINITY;
        }
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < width * height; i++) {
            least = nearest[i] < least ? nearest[i] : least;
        }
        leastInverse = least;
        return 1.0 / least;
    }

    /** Whether a triangle came that cannot be painted, since the origin lies in it. */
    boolean isLost() {
        return lost;
    }

    /** Sets what a pixel of the tile sees, whatever it saw before. */
    void set(int column, int row, double parameter, int triangle) {
        nearest[row * width + column] = 1.0 / parameter;
        triangles[row * width + column] = triangle;
    }

    /** Whether a pixel sees a triangle. */
    boolean hits(int column, int row) {
        return nearest[row * width + column] > 0.0;
    }

    /** Ray parameter of what a pixel sees; infinity for nothing. */
    double parameter(int column, int row) {
        return 1.0 / nearest[row * width + column];
    }

    /** What a pixel sees, if it sees anything. */
    int triangle(int column, int row) {
        return triangles[row * width + column];
    }

    /** Writes ray parameters times the lengths of the directions; infinity for nothing. */
    void copyDistances(float[] target, int first, int rowLength) {
        double stepX = grid.right(0);
        double stepY = grid.right(1);
        double stepZ = grid.right(2);
        for (int row = 0; row < height; row++) {
            double dx = grid.direction(left, top + row, 0);
            double dy = grid.direction(left, top + row, 1);
            double dz = grid.direction(left, top + row, 2);
            int start = first + row * rowLength;
            for (int column = 0; column < width; column++) {
                double inverse = nearest[row * width + column];
                target[start + column] = inverse > 0.0
                        ? (float) (Math.sqrt(dx * dx + dy * dy + dz * dz) / inverse)
                        : Float.POSITIVE_INFINITY;
                dx += stepX;
                dy += stepY;
                dz += stepZ;
            }
        }
    }

    /** Paints a triangle into the tile; gives whether any pixel took it. */
    boolean paint(int triangle) {
        // The corners in grid coordinates, from the tile's own corner.
        float[] c = corners;
        double[] m = grid.toGrid;
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
        int lastColumn = width - 1;
        int lastRow = height - 1;
        if (ax < 0.0 && bx < 0.0 && cx < 0.0
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
        if (!(r + Math.max(0.0, lastColumn * rx) + Math.max(0.0, lastRow * ry) > leastInverse)) {
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

        int fromRow = 0;
        int toRow = lastRow;
        if (az > 0.0 && bz > 0.0 && cz > 0.0) {
            double yA = ay / az;
            double yB = by / bz;
            double yC = cy / cz;
            double high = Math.min(yA, Math.min(yB, yC));
            double low = Math.max(yA, Math.max(yB, yC));
            fromRow = high > 0.0 ? (int) (high + (1.0 - NEAR_EDGE)) : 0;
            toRow = low < lastRow ? (int) (low + NEAR_EDGE) : lastRow;
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
            int first = (int) (from + (1.0 - NEAR_EDGE));
            int last = (int) (to + NEAR_EDGE);
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
            taken |= paintRow(row * width, first, last, r + row * ry, rx, triangle);
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

    private boolean paintRow(int start, int first, int last, double inverse, double step, int triangle) {
        boolean taken = false;
        for (int column = first; column <= last; column++) {
            double here = inverse + column * step;
            int pixel = start + column;
            if (here > nearest[pixel]) {
                uncovered -= nearest[pixel] == 0.0 ? 1 : 0;
                nearest[pixel] = here;
                triangles[pixel] = triangle;
                taken = true;
            }
        }
        return taken;
    }
}
