package org.dronewatch.kdtree;

import java.util.Arrays;

/** The pixels of a tile: what each of them sees, and how near that is. One per thread. */
final class TilePixels {
    /** Columns and rows of a block, a power of two. */
    private static final int BLOCK = 4;

    private final PixelGrid grid;

    private int left;
    private int top;
    private int width;
    private int height;

    /** Inverse ray parameter of the nearest surface of each pixel, 0 for none; and which triangle it is. */
    private final double[] nearest;

    private final int[] triangles;

    /**
     * An inverse ray parameter for each block of pixels that none of it is below: that of its farthest pixel when somebody
     * last looked. Pixels only come nearer, so it stays true.
     */
    private final double[] leastOfBlock;

    private int blocksAcross;

    /** The numbers of columns, for arithmetic by vectors. */
    private final double[] columns;

    private final double[] rowOfDistances;

    /** The pixel that was the farthest when somebody last looked, or the first one that sees nothing; and its inverse. */
    private int farthestPixel;

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
        this.leastOfBlock = new double[pixels];
        this.columns = new double[pixels];
        Arrays.setAll(columns, i -> i);
        this.rowOfDistances = new double[pixels];
    }

    /** Begins a tile: no pixel sees anything. */
    void begin(int firstColumn, int firstRow, int columns, int rows) {
        left = firstColumn;
        top = firstRow;
        width = columns;
        height = rows;
        Arrays.fill(nearest, 0, width * height, 0.0);
        blocksAcross = (width + BLOCK - 1) / BLOCK;
        Arrays.fill(leastOfBlock, 0, blocksAcross * ((height + BLOCK - 1) / BLOCK), 0.0);
        farthestPixel = 0;
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
            // Those before it see something, and will for ever.
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
        for (int top = fromRow & -BLOCK; top <= toRow; top += BLOCK) {
            for (int left = fromColumn & -BLOCK; left <= toColumn; left += BLOCK) {
                if (leastOfBlock[block(left, top)] < inverse
                        && anyBeyondInBlock(inverse, left, top, fromColumn, toColumn, fromRow, toRow)) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean anyBeyondInBlock(
            double inverse, int left, int top, int fromColumn, int toColumn, int fromRow, int toRow) {
        int lastOfRow = Math.min(toColumn, left + BLOCK - 1);
        int lastOfColumn = Math.min(toRow, top + BLOCK - 1);
        for (int row = Math.max(fromRow, top); row <= lastOfColumn; row++) {
            for (int pixel = row * width + Math.max(fromColumn, left); pixel <= row * width + lastOfRow; pixel++) {
                if (nearest[pixel] < inverse) {
                    return true;
                }
            }
        }
        leastOfBlock[block(left, top)] = least(left, top);
        return false;
    }

    private double least(int left, int top) {
        double least = Double.POSITIVE_INFINITY;
        for (int row = top; row < Math.min(height, top + BLOCK); row++) {
            for (int pixel = row * width + left; pixel < row * width + Math.min(width, left + BLOCK); pixel++) {
                least = nearest[pixel] < least ? nearest[pixel] : least;
            }
        }
        return least;
    }

    private int block(int column, int row) {
        return row / BLOCK * blocksAcross + column / BLOCK;
    }

    /**
     * Lets the pixels of a row from one column to another see a triangle where it is the nearest.
     *
     * @param inverse inverse ray parameter of the triangle in the tile's left column
     * @param step what a column adds to it
     */
    void paint(int row, int first, int last, double inverse, double step, int triangle) {
        // What the loop changes is kept in locals: fields would be written back for each pixel.
        double[] nearestNow = nearest;
        int[] seen = triangles;
        int start = row * width;
        for (int column = first; column <= last; column++) {
            double here = inverse + column * step;
            if (here > nearestNow[start + column]) {
                nearestNow[start + column] = here;
                seen[start + column] = triangle;
            }
        }
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
        double[] numbers = columns;
        double[] distances = rowOfDistances;
        double stepX = grid.right(0);
        double stepY = grid.right(1);
        double stepZ = grid.right(2);
        for (int row = 0; row < height; row++) {
            double x = grid.direction(left, top + row, 0);
            double y = grid.direction(left, top + row, 1);
            double z = grid.direction(left, top + row, 2);
            // The compiler makes vectors of a loop over doubles, but not of what turns doubles into floats.
            System.arraycopy(nearest, row * width, distances, 0, width);
            for (int column = 0; column < width; column++) {
                double dx = x + numbers[column] * stepX;
                double dy = y + numbers[column] * stepY;
                double dz = z + numbers[column] * stepZ;
                distances[column] = Math.sqrt(dx * dx + dy * dy + dz * dz) / distances[column];
            }
            int start = first + row * rowLength;
            for (int column = 0; column < width; column++) {
                target[start + column] = (float) distances[column];
            }
        }
    }
}
