package org.dronewatch.route;

import org.dronewatch.analysis.field.DetectionField;

/**
 * The eight cells of a detection field between whose centres a point lies, and what each contributes to a trilinear
 * interpolation there. Cells in which a drone cannot be contribute nothing, and the others proportionally more. For one
 * thread.
 */
final class CellCorners {
    /** The number of cells. */
    static final int COUNT = 8;

    private final DetectionField field;
    private final FieldCells cells;
    private int west;
    private int north;
    private int bottom;
    private final boolean[] isOpen = new boolean[COUNT];
    private final double[] weights = new double[COUNT];

    CellCorners(DetectionField field, FieldCells cells) {
        this.field = field;
        this.cells = cells;
    }

    /** Selects the cells around a point; coordinates in m. */
    void around(double x, double y, double z) {
        double column = cells.column(x);
        double row = cells.row(y);
        west = FieldCells.lower(column, cells.columns());
        north = FieldCells.lower(row, cells.rows());
        bottom = FieldCells.lower(cells.level(column, row, z), cells.levels());
        for (int corner = 0; corner < COUNT; corner++) {
            isOpen[corner] = column(corner) < cells.columns()
                    && row(corner) < cells.rows()
                    && level(corner) < cells.levels()
                    && field.isOpen(level(corner), column(corner), row(corner));
        }
    }

    /** The column of a corner. */
    int column(int corner) {
        return west + (corner & 1);
    }

    /** The row of a corner. */
    int row(int corner) {
        return north + (corner >> 1 & 1);
    }

    /** The number of the height of a corner. */
    int level(int corner) {
        return bottom + (corner >> 2);
    }

    /** Determines what each cell contributes at a point between them; coordinates in m. */
    void weigh(double x, double y, double z) {
        double column = cells.column(x);
        double row = cells.row(y);
        double u = clamp(column - west);
        double v = clamp(row - north);
        double w = clamp(cells.level(column, row, z) - bottom);
        double sum = 0.0;
        for (int corner = 0; corner < COUNT; corner++) {
            double weight = ((corner & 1) == 0 ? 1.0 - u : u)
                    * ((corner & 2) == 0 ? 1.0 - v : v)
                    * ((corner & 4) == 0 ? 1.0 - w : w);
            weights[corner] = isOpen[corner] ? weight : 0.0;
            sum += weights[corner];
        }
        for (int corner = 0; corner < COUNT && sum > 0.0 && sum != 1.0; corner++) {
            weights[corner] /= sum;
        }
    }

    private static double clamp(double share) {
        return Math.max(0.0, Math.min(1.0, share));
    }

    /** What a cell contributes at the point, 0 to 1. */
    double weight(int corner) {
        return weights[corner];
    }

    /** Adds the weights at the point to a sum by corner. */
    void addTo(double[] sums, double factor) {
        for (int corner = 0; corner < COUNT; corner++) {
            sums[corner] += factor * weights[corner];
        }
    }

    /** The corner that contributes the most; -1 if none does. */
    int nearest() {
        int nearest = 0;
        for (int corner = 1; corner < COUNT; corner++) {
            nearest = weights[corner] > weights[nearest] ? corner : nearest;
        }
        return weights[nearest] > 0.0 ? nearest : -1;
    }
}
