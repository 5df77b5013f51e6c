package org.dronewatch.route.search;

import java.util.BitSet;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;

/**
 * The cubes between the nodes of a grid, or squares if it has one level: for each, the greatest slope of a lower bound
 * on the exposure, in coordinates in which the third is the height above the ground. Immutable.
 */
final class CubeSlopes {
    private static final int CORNERS = 8;

    private final RouteGrid grid;
    private final int columns;
    private final int rows;
    private final int levels;
    private final double[] squares;

    CubeSlopes(RouteProblem problem) {
        this.grid = problem.grid();
        this.columns = grid.columns() - 1;
        this.rows = grid.rows() - 1;
        this.levels = Math.max(1, grid.levels() - 1);
        this.squares = new double[columns * rows * levels];
        Workers.forEach(rows * levels, row -> {
            for (int cube = row * columns; cube < (row + 1) * columns; cube++) {
                double slope = slope(problem, cube);
                squares[cube] = slope * slope;
            }
        });
    }

    /** The number of columns of cubes. */
    int columns() {
        return columns;
    }

    /** The number of rows of cubes. */
    int rows() {
        return rows;
    }

    /** The number of levels of cubes. */
    int levels() {
        return levels;
    }

    /** The number of cubes. */
    int size() {
        return squares.length;
    }

    /** The number of a cube. */
    int cube(int column, int row, int level) {
        return (level * rows + row) * columns + column;
    }

    /** The square of the greatest slope; infinite inside something solid. */
    double squared(int cube) {
        return squares[cube];
    }

    /** Whether a cube is inside something solid. */
    boolean isSolid(int cube) {
        return squares[cube] == Double.POSITIVE_INFINITY;
    }

    /** The least exposure per metre in a cube, in these coordinates. */
    private double slope(RouteProblem problem, int cube) {
        int column = cube % columns;
        int row = cube / columns % rows;
        int level = cube / (columns * rows);
        int low = grid.node(column, row, level);
        int top = Math.min(level + 1, grid.levels() - 1);
        int high = grid.node(column + 1, row + 1, top);
        if (isClosed(column, row, level, top)) {
            return Double.POSITIVE_INFINITY;
        }
        double[] ground = grid.groundRange(column, row);
        Position lowest = new Position(grid.x(low), grid.y(low), ground[0] + grid.height(level));
        Position highest = new Position(grid.x(high), grid.y(high), ground[1] + grid.height(top));
        double least = Double.POSITIVE_INFINITY;
        for (int mode = 0; mode < problem.modes().size(); mode++) {
            double rate = problem.field().least(lowest, highest, mode);
            least = Math.min(least, rate / problem.modes().get(mode).speed());
        }
        // Heights above a slope m shear the space, which stretches it by at most this factor.
        double rise = grid.levels() > 1 ? grid.slope(column, row) : 0.0;
        return least * (Math.sqrt(1.0 + 0.25 * rise * rise) - 0.5 * rise);
    }

    private boolean isClosed(int column, int row, int level, int top) {
        for (int i = 0; i < CORNERS; i++) {
            int node = grid.node(column + (i & 1), row + (i >> 1 & 1), (i & 4) == 0 ? level : top);
            if (grid.isOpen(node)) {
                return false;
            }
        }
        return true;
    }

    /** Nodes and all nodes of the cubes to which they belong. */
    static BitSet around(RouteGrid grid, BitSet nodes) {
        BitSet around = new BitSet();
        nodes.stream().forEach(node -> {
            int column = node % grid.columns();
            int row = node / grid.columns() % grid.rows();
            int level = node / (grid.columns() * grid.rows());
            for (int k = Math.max(0, level - 1); k <= Math.min(grid.levels() - 1, level + 1); k++) {
                for (int j = Math.max(0, row - 1); j <= Math.min(grid.rows() - 1, row + 1); j++) {
                    around.set(
                            grid.node(Math.max(0, column - 1), j, k),
                            grid.node(Math.min(grid.columns() - 1, column + 1), j, k) + 1);
                }
            }
        });
        return around;
    }
}
