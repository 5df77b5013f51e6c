package org.dronewatch.raster;

/**
 * Decides in which boxes a tile can still see something. Where the ground is seen from the side, ten or more triangles
 * lie behind each pixel, and most cells of the tree behind the first hills are hidden, or lie between the pixels'
 * centres: their triangles are culled. For use by one thread.
 */
final class TileCuller {
    /** How far a box's projection onto the tile is widened, in pixels: more than the rasteriser widens edges. */
    private static final double MARGIN = 1e-5;
    /** An upper bound on the relative rounding errors of a box's position and reach. */
    private static final double ROUNDING = 1e-14;

    private final PixelGrid grid;
    private final TileBuffer pixels;

    /** From world to grid coordinates less those of the tile's corner: rows for z, x and y. */
    private final double[] toTile = new double[9];

    TileCuller(PixelGrid grid, TileBuffer pixels) {
        this.grid = grid;
        this.pixels = pixels;
    }

    /** Looks through the tile that the pixels have begun. */
    void begin() {
        double[] m = grid.toGrid;
        for (int i = 0; i < 3; i++) {
            toTile[i] = m[i];
            toTile[3 + i] = m[3 + i] - pixels.left() * m[i];
            toTile[6 + i] = m[6 + i] - pixels.top() * m[i];
        }
    }

    /**
     * Whether a pixel may see something in a box: its ray meets it, in front of what the pixel sees already.
     *
     * @param boxes minimum on three axes, then maximum
     * @param at index of the box's first number
     */
    boolean reaches(double[] boxes, int at) {
        double[] m = toTile;
        double[] origin = grid.origin;
        double halfX = 0.5 * (boxes[at + 3] - boxes[at]);
        double halfY = 0.5 * (boxes[at + 4] - boxes[at + 1]);
        double halfZ = 0.5 * (boxes[at + 5] - boxes[at + 2]);
        double middleX = boxes[at] + halfX - origin[0];
        double middleY = boxes[at + 1] + halfY - origin[1];
        double middleZ = boxes[at + 2] + halfZ - origin[2];
        double depth = m[0] * middleX + m[1] * middleY + m[2] * middleZ;
        double depthReach = Math.abs(m[0]) * halfX + Math.abs(m[1]) * halfY + Math.abs(m[2]) * halfZ;
        double near = depth - depthReach - ROUNDING * (Math.abs(depth) + depthReach);
        if (!(near > 0.0)) {
            return true;
        }
        double x = m[3] * middleX + m[4] * middleY + m[5] * middleZ;
        double xReach = Math.abs(m[3]) * halfX + Math.abs(m[4]) * halfY + Math.abs(m[5]) * halfZ;
        double y = m[6] * middleX + m[7] * middleY + m[8] * middleZ;
        double yReach = Math.abs(m[6]) * halfX + Math.abs(m[7]) * halfY + Math.abs(m[8]) * halfZ;

        // The projection's borders: those beyond the tile's corner are farthest from it at the near end of the box.
        double ofNear = 1.0 / near;
        double ofFar = 1.0 / (depth + depthReach);
        double across = MARGIN + ROUNDING * (Math.abs(x) + xReach) * ofNear;
        double downwards = MARGIN + ROUNDING * (Math.abs(y) + yReach) * ofNear;
        double low = (x - xReach) * (x < xReach ? ofNear : ofFar) - across;
        double high = (x + xReach) * (x < -xReach ? ofFar : ofNear) + across;
        double upper = (y - yReach) * (y < yReach ? ofNear : ofFar) - downwards;
        double lower = (y + yReach) * (y < -yReach ? ofFar : ofNear) + downwards;
        if (high < 0.0 || lower < 0.0 || low > pixels.lastColumn() || upper > pixels.lastRow()) {
            return false;
        }
        int fromColumn = low > 0.0 ? (int) Math.ceil(low) : 0;
        int toColumn = (int) Math.min(high, pixels.lastColumn());
        int fromRow = upper > 0.0 ? (int) Math.ceil(upper) : 0;
        int toRow = (int) Math.min(lower, pixels.lastRow());
        return pixels.anyBeyond(ofNear, fromColumn, toColumn, fromRow, toRow);
    }
}
