package org.dronewatch.sensor.alarm;

/**
 * Divides the unit cube into any number of boxes of equal volume: a box of n cells is cut across its longest side (the
 * first of equal ones) into two boxes with half of the cells each, or with one more in the second if n is odd.
 */
final class CellGrid {
    private CellGrid() {}

    /**
     * Finds a point in the box of one cell.
     *
     * @param cell number of the cell, from 0
     * @param cells number of cells
     * @param dimensions number of coordinates that are divided, starting with the first, 0 to 3
     * @param point coordinates within the box, each from 0 to 1; replaced by those within the cube
     */
    static void locate(long cell, long cells, int dimensions, double[] point) {
        double[] low = new double[point.length];
        double[] size = {1.0, 1.0, 1.0};
        long left = cell;
        long here = cells;
        while (here > 1 && dimensions > 0) {
            int axis = longest(size, dimensions);
            long half = here / 2;
            double share = (double) half / here;
            if (left < half) {
                size[axis] *= share;
                here = half;
            } else {
                low[axis] += size[axis] * share;
                size[axis] *= 1.0 - share;
                left -= half;
                here -= half;
            }
        }
        for (int i = 0; i < point.length; i++) {
            point[i] = low[i] + size[i] * point[i];
        }
    }

    private static int longest(double[] size, int dimensions) {
        int longest = 0;
        for (int i = 1; i < dimensions; i++) {
            longest = size[i] > size[longest] ? i : longest;
        }
        return longest;
    }
}
