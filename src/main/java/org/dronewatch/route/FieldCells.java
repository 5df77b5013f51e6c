package org.dronewatch.route;

import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.geometry.Position;

/** Which cell of a detection field a point is in: the nearest, up to half the distance to the next height. */
final class FieldCells {
    /** The shortest part of a leg, as a fraction of it: rounding errors at edges of cells are smaller. */
    private static final double SHORTEST = 1e-9;

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

    /**
     * Where a straight leg leaves the cell in which it is.
     *
     * @param after the fraction of the leg after which it does
     * @return a greater fraction, 1 at the end of the leg
     */
    double leaves(Position from, Position to, double after) {
        double inside = after + SHORTEST;
        double dx = (to.x() - from.x()) / grid.cell();
        double dy = (from.y() - to.y()) / grid.cell();
        double x = (from.x() - grid.x(0)) / grid.cell();
        double y = (grid.y(0) - from.y()) / grid.cell();
        double next = Math.min(crossing(x, dx, inside), crossing(y, dy, inside));
        double ground = field.ground(clamp(x + inside * dx), clamp(y + inside * dy));
        if (!Double.isNaN(ground)) {
            double dz = to.z() - from.z();
            double above = from.z() - ground;
            for (int i = 1; i < heights.length; i++) {
                double share = (0.5 * (heights[i - 1] + heights[i]) - above) / dz;
                next = share > inside && share < next ? share : next;
            }
        }
        return Math.min(1.0, next);
    }

    /** Where a coordinate, in cells from the middle of the first, next comes half-way between two of them. */
    private static double crossing(double begin, double change, double inside) {
        if (change == 0.0) {
            return Double.POSITIVE_INFINITY;
        }
        double cell = Math.floor(begin + inside * change + 0.5);
        double edge = change > 0.0 ? cell + 0.5 : cell - 0.5;
        double share = (edge - begin) / change;
        // Rounding may leave a point on an edge on its wrong side: the edge after that one follows.
        return share > inside ? share : share + 1.0 / Math.abs(change);
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
