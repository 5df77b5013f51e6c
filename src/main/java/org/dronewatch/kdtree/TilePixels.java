package org.dronewatch.kdtree;

import java.util.Arrays;

/** The pixels of a tile: what each of them sees, and how near that is. One per thread. */
final class TilePixels {
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

    /**
     * Pixels of tiles.
     *
     * @param grid where they look; may be set anew between tiles
     * @param pixels the most of a tile
     */
    TilePixels(PixelGrid grid, int pixels) {
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
    }

    /** Column of the tile's left pixels in the picture. */
    int left() {
        return left;
    }

    /** Row of the tile's top pixels in the picture. */
    int top() {
        return top;
    }

    int lastColumn() {
        return width - 1;
    }

    int lastRow() {
        return height - 1;
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

    /** An inverse ray parameter that no pixel is below: that of the farthest pixel when it was last asked for. */
    double leastInverse() {
        return leastInverse;
    }

    /** Whether any pixel of a rectangle, borders included, sees nothing as near as an inverse ray parameter. */
    boolean anyBeyond(double inverse, int fromColumn, int toColumn, int fromRow, int toRow) {
        for (int row = fromRow; row <= toRow; row++) {
            for (int column = fromColumn; column <= toColumn; column++) {
                if (nearest[row * width + column] < inverse) {
                    return true;
                }
            }
        }
        return false;
    }

    /**
     * Lets the pixels of a row from one column to another see a triangle where it is the nearest.
     *
     * @param inverse inverse ray parameter of the triangle in the first of these columns
     * @param step what a column adds to it
     * @return whether any of them took it
     */
    boolean paint(int row, int first, int last, double inverse, double step, int triangle) {
        // What the loop changes is kept in locals: fields would be written back for each pixel.
        double[] nearestNow = nearest;
        int[] seen = triangles;
        int start = row * width + first;
        int end = row * width + last + 1;
        int fresh = 0;
        boolean taken = false;
        for (int pixel = start; pixel < end; pixel++) {
            double here = inverse + (pixel - start) * step;
            double before = nearestNow[pixel];
            if (here > before) {
                fresh += before == 0.0 ? 1 : 0;
                nearestNow[pixel] = here;
                seen[pixel] = triangle;
                taken = true;
            }
        }
        uncovered -= fresh;
        return taken;
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
}
