package org.dronewatch.raster;

/**
 * Rasterises triangles into a tile line by line, from their functions: the inverse of the ray parameter on the
 * triangle's plane, and three edge functions that are zero or more inside. Each is linear in column and row, and is
 * given by its value at the tile's corner and by what a column and a row add to it. A line of pixels is then an
 * interval between the edges. Lines run along the longer side of the rectangle that holds the triangle, along rows or
 * along columns, so that there are few of them.
 */
class ScanlineRasteriser {
    /** How near to a pixel's centre, in pixels, an edge must pass to be tested again. */
    private static final double NEAR_EDGE = 1e-6;

    final TileBuffer pixels;

    // The rectangle that the triangle may lie in.
    int fromColumn;
    int toColumn;
    int fromRow;
    int toRow;

    // Inverse of the ray parameter and edge functions: at the tile's corner, what a column adds, what a row adds.
    double r;
    double rOfColumn;
    double rOfRow;
    double e;
    double eOfColumn;
    double eOfRow;
    double f;
    double fOfColumn;
    double fOfRow;
    double g;
    double gOfColumn;
    double gOfRow;

    ScanlineRasteriser(TileBuffer pixels) {
        this.pixels = pixels;
    }

    /** Sets the rectangle that the next triangle may lie in, borders included. */
    void setRectangle(int firstColumn, int lastColumn, int firstRow, int lastRow) {
        fromColumn = firstColumn;
        toColumn = lastColumn;
        fromRow = firstRow;
        toRow = lastRow;
    }

    /** Sets the inverse of the ray parameter of the next triangle. */
    void setInverse(double atCorner, double ofColumn, double ofRow) {
        r = atCorner;
        rOfColumn = ofColumn;
        rOfRow = ofRow;
    }

    /** Sets its first edge function. */
    void setFirstEdge(double atCorner, double ofColumn, double ofRow) {
        e = atCorner;
        eOfColumn = ofColumn;
        eOfRow = ofRow;
    }

    /** Sets its second edge function. */
    void setSecondEdge(double atCorner, double ofColumn, double ofRow) {
        f = atCorner;
        fOfColumn = ofColumn;
        fOfRow = ofRow;
    }

    /** Sets its third edge function. */
    void setThirdEdge(double atCorner, double ofColumn, double ofRow) {
        g = atCorner;
        gOfColumn = ofColumn;
        gOfRow = ofRow;
    }

    /** Whether lines are columns of pixels. */
    boolean isUpright() {
        return toRow - fromRow > toColumn - fromColumn;
    }

    /** Rasterises the triangle. */
    void rasterise(int triangle) {
        boolean upright = isUpright();
        int firstLine = upright ? fromColumn : fromRow;
        int lastLine = upright ? toColumn : toRow;
        int firstPixel = upright ? fromRow : fromColumn;
        int lastPixel = upright ? toRow : toColumn;
        // What the next line adds, and what the next pixel of a line.
        double rAcross = upright ? rOfColumn : rOfRow;
        double rAlong = upright ? rOfRow : rOfColumn;
        double eAcross = upright ? eOfColumn : eOfRow;
        double eAlong = upright ? eOfRow : eOfColumn;
        double fAcross = upright ? fOfColumn : fOfRow;
        double fAlong = upright ? fOfRow : fOfColumn;
        double gAcross = upright ? gOfColumn : gOfRow;
        double gAlong = upright ? gOfRow : gOfColumn;
        double atE = -1.0 / eAlong;
        double atF = -1.0 / fAlong;
        double atG = -1.0 / gAlong;
        for (int line = firstLine; line <= lastLine; line++) {
            // The pixels between the edges; a rising edge function bounds them from below.
            double eLine = e + line * eAcross;
            double fLine = f + line * fAcross;
            double gLine = g + line * gAcross;
            double from = firstPixel;
            double to = lastPixel;
            double at = eLine * atE;
            if (atE < 0.0) {
                from = at > from ? at : from;
            } else {
                to = at < to ? at : to;
            }
            at = fLine * atF;
            if (atF < 0.0) {
                from = at > from ? at : from;
            } else {
                to = at < to ? at : to;
            }
            at = gLine * atG;
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
                    && (eLine + first * eAlong < 0.0 || fLine + first * fAlong < 0.0 || gLine + first * gAlong < 0.0)) {
                first++;
            }
            if (Math.abs(to - last) <= NEAR_EDGE
                    && first <= last
                    && (eLine + last * eAlong < 0.0 || fLine + last * fAlong < 0.0 || gLine + last * gAlong < 0.0)) {
                last--;
            }
            double inverse = r + line * rAcross;
            if (upright) {
                pixels.fillColumn(line, first, last, inverse, rAlong, triangle);
            } else {
                pixels.fillRow(line, first, last, inverse, rAlong, triangle);
            }
        }
    }

    /** The first pixel at or after a coordinate of zero or more. */
    static int atOrAfter(double coordinate) {
        return (int) (coordinate + (1.0 - NEAR_EDGE));
    }

    /** The last pixel at or before a coordinate; -1 for all coordinates before the first pixel, however far. */
    static int atOrBefore(double coordinate) {
        return coordinate > -NEAR_EDGE ? (int) (coordinate + NEAR_EDGE) : -1;
    }
}
