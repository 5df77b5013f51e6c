package org.dronewatch.raster;

import java.util.Arrays;

/** The pixels of a tile: what each of them sees, and how near that is. For use by one thread. */
final class TileBuffer {
    /** Number of columns, and of rows, of a block, a power of two. */
    private static final int BLOCK = 4;
    /** Pixels of a vector. One may begin at the last pixel: what lies beyond it is read, and written back unchanged. */
    static final int LANES = 4;

    private final PixelGrid grid;

    private int left;
    private int top;
    private int width;
    private int height;

    /** Inverse ray parameter of the nearest surface of each pixel, 0 for none, row by row. */
    final double[] nearest;

    /**
     * Which triangle that is, in lanes as wide as those that compare distances: vectors of ints converted to doubles
     * and back make {@code BvhTraversal} a third slower in the same virtual machine, whose compiler then inlines less
     * of either.
     */
    final double[] triangles;

    /**
     * A lower bound on the inverse ray parameters of each block of pixels: that of its farthest pixel when it was last
     * computed. Pixels only come nearer, so it stays a bound.
     */
    private final double[] leastOfBlock;

    private int blocksAcross;

    /** The numbers of columns, for arithmetic by vectors. */
    final double[] columnNumbers;

    private final double[] rowOfDistances;

    /** The pixel that was the farthest when last computed, or the first one that sees nothing; and its inverse. */
    private int farthestPixel;

    private double leastInverse;

    /**
     * Pixels of tiles.
     *
     * @param grid where they look; may be set again between tiles
     * @param mostColumns of a tile
     * @param mostRows of a tile
     */
    TileBuffer(PixelGrid grid, int mostColumns, int mostRows) {
        this.grid = grid;
        this.nearest = new double[mostColumns * mostRows + LANES - 1];
        this.triangles = new double[nearest.length];
        this.leastOfBlock = new double[blocks(mostColumns) * blocks(mostRows)];
        this.columnNumbers = new double[mostColumns + LANES - 1];
        Arrays.setAll(columnNumbers, i -> i);
        this.rowOfDistances = new double[mostColumns];
    }

    private static int blocks(int pixels) {
        return (pixels + BLOCK - 1) / BLOCK;
    }

    /** Begins a tile: no pixel sees anything. */
    void begin(int firstColumn, int firstRow, int columns, int rows) {
        left = firstColumn;
        top = firstRow;
        width = columns;
        height = rows;
        blocksAcross = blocks(width);
        Arrays.fill(nearest, 0, width * height, 0.0);
        Arrays.fill(leastOfBlock, 0, blocksAcross * blocks(height), 0.0);
        farthestPixel = 0;
        leastInverse = 0.0;
    }

    /** Column of the tile's left pixels in the image. */
    int left() {
        return left;
    }

    /** Row of the tile's top pixels in the image. */
    int top() {
        return top;
    }

    /** Columns of the tile: from a pixel to that below it. */
    int width() {
        return width;
    }

    int lastColumn() {
        return width - 1;
    }

    int lastRow() {
        return height - 1;
    }

    /** The ray parameter of the farthest pixel; infinity while any sees nothing. */
    double farthest() {
        if (nearest[farthestPixel] > leastInverse) {
            findFarthest();
        }
        return 1.0 / leastInverse;
    }

    private void findFarthest() {
        int all = width * height;
        if (leastInverse == 0.0) {
            // Those before it see something, and always will.
            while (farthestPixel < all && nearest[farthestPixel] > 0.0) {
                farthestPixel++;
            }
            if (farthestPixel < all) {
                return;
            }
        }
        farthestPixel = 0;
        for (int pixel = 1; pixel < all; pixel++) {
            farthestPixel = nearest[pixel] < nearest[farthestPixel] ? pixel : farthestPixel;
        }
        leastInverse = nearest[farthestPixel];
    }

    /** Whether any pixel of a rectangle, borders included, sees nothing as near as an inverse ray parameter. */
    boolean anyBeyond(double inverse, int fromColumn, int toColumn, int fromRow, int toRow) {
        for (int row = fromRow & -BLOCK; row <= toRow; row += BLOCK) {
            for (int column = fromColumn & -BLOCK; column <= toColumn; column += BLOCK) {
                if (leastOfBlock[block(column, row)] < inverse
                        && anyBeyondInBlock(inverse, column, row, fromColumn, toColumn, fromRow, toRow)) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean anyBeyondInBlock(
            double inverse, int blockLeft, int blockTop, int fromColumn, int toColumn, int fromRow, int toRow) {
        int firstColumn = Math.max(fromColumn, blockLeft);
        int lastColumn = Math.min(toColumn, blockLeft + BLOCK - 1);
        int lastRow = Math.min(toRow, blockTop + BLOCK - 1);
        for (int row = Math.max(fromRow, blockTop); row <= lastRow; row++) {
            for (int pixel = row * width + firstColumn; pixel <= row * width + lastColumn; pixel++) {
                if (nearest[pixel] < inverse) {
                    return true;
                }
            }
        }
        leastOfBlock[block(blockLeft, blockTop)] = least(blockLeft, blockTop);
        return false;
    }

    private double least(int blockLeft, int blockTop) {
        double least = Double.POSITIVE_INFINITY;
        int endColumn = Math.min(width, blockLeft + BLOCK);
        for (int row = blockTop; row < Math.min(height, blockTop + BLOCK); row++) {
            for (int pixel = row * width + blockLeft; pixel < row * width + endColumn; pixel++) {
                least = nearest[pixel] < least ? nearest[pixel] : least;
            }
        }
        return least;
    }

    private int block(int column, int row) {
        return row / BLOCK * blocksAcross + column / BLOCK;
    }

    /**
     * Fills the pixels of a row from one column to another with a triangle where it is the nearest.
     *
     * @param inverse inverse ray parameter of the triangle in the tile's left column
     * @param step what a column adds to it
     */
    void fillRow(int row, int first, int last, double inverse, double step, int triangle) {
        // What the loop changes is kept in locals: fields would be written back for each pixel.
        double[] nearestNow = nearest;
        double[] seen = triangles;
        int start = row * width;
        for (int column = first; column <= last; column++) {
            double here = inverse + column * step;
            if (here > nearestNow[start + column]) {
                nearestNow[start + column] = here;
                seen[start + column] = triangle;
            }
        }
    }

    /**
     * Fills the pixels of a column from one row to another with a triangle where it is the nearest. Separate from rows,
     * since the compiler makes more of a loop over neighbours.
     *
     * @param inverse inverse ray parameter of the triangle in the tile's top row
     * @param step what a row adds to it
     */
    void fillColumn(int column, int first, int last, double inverse, double step, int triangle) {
        double[] nearestNow = nearest;
        double[] seen = triangles;
        int pixel = first * width + column;
        for (int row = first; row <= last; row++) {
            double here = inverse + row * step;
            if (here > nearestNow[pixel]) {
                nearestNow[pixel] = here;
                seen[pixel] = triangle;
            }
            pixel += width;
        }
    }

    /** Sets what a pixel sees that has seen nothing yet. */
    void set(int column, int row, double parameter, int triangle) {
        nearest[row * width + column] = 1.0 / parameter;
        triangles[row * width + column] = triangle;
    }

    /** Lets a pixel see nothing. Only after all that it sees is known: bounds may have to grow. */
    void clear(int column, int row) {
        nearest[row * width + column] = 0.0;
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
        return (int) triangles[row * width + column];
    }

    /** Writes ray parameters times the lengths of the directions; infinity for nothing. */
    void copyDistances(float[] target, int first, int targetRowLength) {
        double[] numbers = columnNumbers;
        double[] distances = rowOfDistances;
        double stepX = grid.right(0);
        double stepY = grid.right(1);
        double stepZ = grid.right(2);
        for (int row = 0; row < height; row++) {
            double x = grid.direction(left, top + row, 0);
            double y = grid.direction(left, top + row, 1);
            double z = grid.direction(left, top + row, 2);
            int pixels = row * width;
            // The compiler makes vectors of a loop over doubles that all begin at 0, but not of what turns doubles into
            // floats. What sees nothing is at 1 / 0, or at 0 / 0 where the direction has no length.
            System.arraycopy(nearest, pixels, distances, 0, width);
            for (int column = 0; column < width; column++) {
                double dx = x + numbers[column] * stepX;
                double dy = y + numbers[column] * stepY;
                double dz = z + numbers[column] * stepZ;
                distances[column] = Math.sqrt(dx * dx + dy * dy + dz * dz) / distances[column];
            }
            int start = first + row * targetRowLength;
            for (int column = 0; column < width; column++) {
                target[start + column] =
                        nearest[pixels + column] > 0.0 ? (float) distances[column] : Float.POSITIVE_INFINITY;
            }
        }
    }
}
