package org.dronewatch.raster;

import org.dronewatch.kdtree.LeafOrderTriangles;

/**
 * Sets triangles up for the rasteriser: projects their corners onto the tile, culls those without a pixel, and computes
 * their edge functions and the inverse of the ray parameter. For use by one thread.
 *
 * <p>In the frame of the {@link PixelGrid}, the ray of pixel (x, y) has the direction (x, y, 1). The three edge
 * functions of a triangle, whose signs separate inside from outside, and the inverse of the ray parameter are linear in
 * x and y there. Each line of pixels is then an interval between the edges. An edge that two triangles share has
 * opposite functions in them, and zero counts as inside: no pixel slips through an edge. This also holds where one
 * triangle is rasterised by rows and the other by columns: the two orders of adding round differently, but never across
 * zero. Where corners lie some 1e-5 of a pixel from each other, and from a pixel's centre, rounding errors of different
 * edges may mean that this pixel belongs to none of the triangles.
 */
class TriangleSetup {
    /** Relative size of the rounding errors of the volume between the origin and a triangle. */
    static final double IN_PLANE = 1e-12;
    /** Maximum number of triangles at a time. */
    static final int MOST = 128;

    final float[] corners;
    final int[] numbers;
    final PixelGrid grid;
    final TileBuffer pixels;
    final ScanlineRasteriser lines;
    private boolean unable;

    /**
     * A setup.
     *
     * @param triangles what there is to rasterise
     * @param grid where the pixels look
     * @param pixels what they are rasterised into
     * @param lines rasterise them, into the same pixels
     */
    TriangleSetup(LeafOrderTriangles triangles, PixelGrid grid, TileBuffer pixels, ScanlineRasteriser lines) {
        this.corners = triangles.corners();
        this.numbers = triangles.numbers();
        this.grid = grid;
        this.pixels = pixels;
        this.lines = lines;
    }

    /** Begins a tile, after {@link TileBuffer#begin}. */
    void begin() {
        unable = false;
    }

    /** Whether there was a triangle that cannot be rasterised because the origin lies in it. */
    boolean isUnable() {
        return unable;
    }

    /**
     * Rasterises triangles into the tile.
     *
     * @param indices of the triangles in leaf order
     * @param count how many, up to {@link #MOST}
     */
    void rasterise(int[] indices, int count) {
        for (int i = 0; i < count; i++) {
            rasterise(indices[i]);
        }
    }

    /** Rasterises the triangle at an index into the tile. */
    final void rasterise(int index) {
        // The corners in grid coordinates, from the tile's own corner.
        float[] c = corners;
        double[] m = grid.toGrid;
        int left = pixels.left();
        int top = pixels.top();
        int base = 9 * index;
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
        int fromColumn = 0;
        int toColumn = lastColumn;
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
            fromColumn = ScanlineRasteriser.atOrAfter(Math.max(low, 0.0));
            toColumn = ScanlineRasteriser.atOrBefore(Math.min(high, lastColumn));
            fromRow = ScanlineRasteriser.atOrAfter(Math.max(upper, 0.0));
            toRow = ScanlineRasteriser.atOrBefore(Math.min(lower, lastRow));
            if (fromColumn > toColumn || fromRow > toRow) {
                return;
            }
        } else if (ax < 0.0 && bx < 0.0 && cx < 0.0
                || ay < 0.0 && by < 0.0 && cy < 0.0
                || ax > lastColumn * az && bx > lastColumn * bz && cx > lastColumn * cz
                || ay > lastRow * az && by > lastRow * bz && cy > lastRow * cz) {
            return;
        }

        // The triangle's plane, and the inverse ray parameter of each pixel on it: r + x * rx + y * ry.
        double nx = (by - ay) * (cz - az) - (bz - az) * (cy - ay);
        double ny = (bz - az) * (cx - ax) - (bx - ax) * (cz - az);
        double nz = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        double volume = ax * nx + ay * ny + az * nz;
        if (Math.abs(volume) <= IN_PLANE * (Math.abs(ax * nx) + Math.abs(ay * ny) + Math.abs(az * nz))
                && mayHoldOrigin(index)) {
            // Every pixel sees it at distance 0, and the edge functions decide nothing: single rays do.
            unable = true;
            return;
        }
        lines.setRectangle(fromColumn, toColumn, fromRow, toRow);
        double inverse = 1.0 / volume;
        lines.setInverse(nz * inverse, nx * inverse, ny * inverse);

        // Edge functions, with the sign that makes inside positive for what lies in front of the origin.
        double sign = volume < 0.0 ? -1.0 : 1.0;
        lines.setFirstEdge(sign * (bx * cy - by * cx), sign * (by * cz - bz * cy), sign * (bz * cx - bx * cz));
        lines.setSecondEdge(sign * (cx * ay - cy * ax), sign * (cy * az - cz * ay), sign * (cz * ax - cx * az));
        lines.setThirdEdge(sign * (ax * by - ay * bx), sign * (ay * bz - az * by), sign * (az * bx - ax * bz));
        lines.rasterise(numbers[index]);
    }

    private boolean mayHoldOrigin(int index) {
        boolean inside = true;
        for (int axis = 0; axis < 3; axis++) {
            float a = corners[9 * index + axis];
            float b = corners[9 * index + 3 + axis];
            float c = corners[9 * index + 6 + axis];
            inside &= grid.origin[axis] >= Math.min(a, Math.min(b, c))
                    && grid.origin[axis] <= Math.max(a, Math.max(b, c));
        }
        return inside;
    }
}
