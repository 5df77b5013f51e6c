package org.dronewatch.route;

import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldGrid;

/** Which cell of a detection field a point is in: the nearest, up to half the distance to the next height. */
final class FieldCells {
    private final DetectionField field;
    private final FieldGrid grid;
    private final double[] heights;

    FieldCells(DetectionField field) {
        this.field = field;
        this.grid = field.grid();
        this.heights = grid.heights().stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** The column at an east coordinate, m. */
    int column(double x) {
        return clamp((x - grid.x(0)) / grid.cell());
    }

    /** The row at a north coordinate, m. */
    int row(double y) {
        return clamp((grid.y(0) - y) / grid.cell());
    }

    private int clamp(double index) {
        return (int) Math.max(0.0, Math.min(grid.columns() - 1.0, Math.rint(index)));
    }

    /** The height that is nearest in a column, m; -1 where there is no ground below. */
    int level(int column, int row, double z) {
        double ground = field.ground(column, row);
        if (Double.isNaN(ground)) {
            return -1;
        }
        double above = z - ground;
        int nearest = 0;
        for (int i = 1; i < heights.length; i++) {
            nearest = Math.abs(heights[i] - above) < Math.abs(heights[nearest] - above) ? i : nearest;
        }
        return nearest;
    }

    /** East coordinate of the middle of a column, m. */
    double x(int column) {
        return grid.x(column);
    }

    /** North coordinate of the middle of a row, m. */
    double y(int row) {
        return grid.y(row);
    }

    /** Height of the middle of a cell, m. */
    double z(int level, int column, int row) {
        return field.ground(column, row) + heights[level];
    }
}
