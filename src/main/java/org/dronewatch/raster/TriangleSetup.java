package org.dronewatch.raster;

import org.dronewatch.kdtree.LeafOrderTriangles;

/**
 * Paints triangles into the pixels of a tile, nearest surface wins. One per thread.
 *
 * <p>In the frame of the {@link PixelGrid} the ray of pixel (x, y) has the direction (x, y, 1). The three edge functions of
 * a triangle, whose signs tell inside from outside, and the inverse of the ray parameter are linear in x and y there. Each
 * line of pixels is then an interval between the edges. An edge that two triangles share has opposite functions in them,
 * and zero counts as inside: no pixel slips through an edge. That holds where one is painted by rows and the other by
 * columns, too: the two orders of adding round differently, but never across zero. Where corners lie some 1e-5 of a pixel
 * from each other, and from a pixel's centre, the roundings of different edges may leave it to none of them.
 */
class TriangleSetup {
    /** Relative size of the roundings of the volume between the origin and a triangle. */
    static final double IN_PLANE = 1e-12;
    /** The most triangles at a time. */
    static final int MOST = 128;

    final float[] corners;
    final int[] numbers;
    final PixelGrid grid;
    final TileBuffer pixels;
    final ScanlineRasteriser lines;
    private boolean lost;

    /**
     * A painter.
     *
     * @param triangles what there is to paint
     * @param grid where the pixels look
     * @param pixels what it paints
     * @param lines paint lines of the same pixels
     */
    TriangleSetup(LeafOrderTriangles triangles, PixelGrid grid, TileBuffer pixels, ScanlineRasteriser lines) {
        this.corners = triangles.corners();
        this.numbers = triangles.numbers();
        this.grid = grid;
        this.pixels = pixels;
        this.lines = lines;
    }

    /** Begins a tile, after its pixels have. */
    void begin() {
        lost = false;
    }

    /** Whether a triangle came that cannot be painted, since the origin lies in it. */
    boolean isLost() {
        return lost;
    }

    /**
     * Paints triangles into the tile.
     *
     * @param places where they are
     * @param count how many, up to {@link #MOST}
     */
    void paint(int[] places, int count) {
        for (int i = 0; i < count; i++) {
            paint(places[i]);
        }
    }

    /** Paints the triangle at a place into the tile. */
    final void paint(int place) {
        // The corners in grid coordinates, from the tile's own corner.
        float[] c = corners;
        double[] m = grid.toGrid;
        int left = pixels.left();
        int top = pixels.top();
        int base = 9 * place;
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
                && mayHoldOrigin(place)) {
            // Every pixel sees it at no distance, and the edge functions say nothing: single rays know.
            lost = true;
            return;
        }
        lines.setRectangle(fromColumn, toColumn, fromRow, toRow);
        double inverse = 1.0 / volume;
        lines.setInverse(nz * inverse, nx * inverse, ny * inverse);

        // Edge functions, turned so that inside is above zero for what lies before the origin.
        double turn = volume < 0.0 ? -1.0 : 1.0;
        lines.setFirstEdge(turn * (bx * cy - by * cx), turn * (by * cz - bz * cy), turn * (bz * cx - bx * cz));
        lines.setSecondEdge(turn * (cx * ay - cy * ax), turn * (cy * az - cz * ay), turn * (cz * ax - cx * az));
        lines.setThirdEdge(turn * (ax * by - ay * bx), turn * (ay * bz - az * by), turn * (az * bx - ax * bz));
        lines.paint(numbers[place]);
    }

    private boolean mayHoldOrigin(int place) {
        boolean inside = true;
        for (int axis = 0; axis < 3; axis++) {
            float a = corners[9 * place + axis];
            float b = corners[9 * place + 3 + axis];
            float c = corners[9 * place + 6 + axis];
            inside &= grid.origin[axis] >= Math.min(a, Math.min(b, c))
                    && grid.origin[axis] <= Math.max(a, Math.max(b, c));
        }
        return inside;
    }
}
