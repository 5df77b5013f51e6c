package org.dronewatch.raster;

/**
 * The rays of an image: one origin, and directions on a regular grid. The ray of the pixel in a column and a row has
 * the direction corner + column * right + row * down. In the frame whose axes are right, down and corner, this
 * direction is (column, row, 1). For use by one thread.
 */
final class PixelGrid {
    final double[] origin = new double[3];
    /** Direction of pixel (0, 0), step to the next column, step to the next row: three numbers each. */
    private final double[] grid = new double[9];
    /** From world to grid coordinates: rows of the inverse of the matrix of corner, right and down. */
    final double[] toGrid = new double[9];

    /**
     * Sets it anew.
     *
     * @throws IllegalArgumentException when corner, right and down lie in one plane
     */
    void set(double[] from, double[] corner, double[] right, double[] down) {
        System.arraycopy(from, 0, origin, 0, 3);
        System.arraycopy(corner, 0, grid, 0, 3);
        System.arraycopy(right, 0, grid, 3, 3);
        System.arraycopy(down, 0, grid, 6, 3);
        crossTo(right, down, 0);
        crossTo(down, corner, 3);
        crossTo(corner, right, 6);
        double determinant = corner[0] * toGrid[0] + corner[1] * toGrid[1] + corner[2] * toGrid[2];
        if (!(Math.abs(determinant) > 0.0)) {
            throw new IllegalArgumentException("corner, right and down of an image must not lie in one plane");
        }
        for (int i = 0; i < 9; i++) {
            toGrid[i] /= determinant;
        }
    }

    private void crossTo(double[] a, double[] b, int target) {
        toGrid[target] = a[1] * b[2] - a[2] * b[1];
        toGrid[target + 1] = a[2] * b[0] - a[0] * b[2];
        toGrid[target + 2] = a[0] * b[1] - a[1] * b[0];
    }

    /** A direction's part along an axis. */
    double direction(double column, double row, int axis) {
        return grid[axis] + column * grid[3 + axis] + row * grid[6 + axis];
    }

    /** What a column adds to it. */
    double right(int axis) {
        return grid[3 + axis];
    }

    /** What a row adds to it. */
    double down(int axis) {
        return grid[6 + axis];
    }
}
