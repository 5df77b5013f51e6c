package org.dronewatch.analysis.cell;

import java.util.Arrays;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.world.SurfaceColumn;
import org.dronewatch.world.World;

/**
 * The ground below columns of cells, and which cells are inside something solid. Heights are measured from the ground,
 * not from roofs: from the terrain, or, where there is none, from the lowest surface that faces up, such as a floor. A
 * cell is inside something solid where the nearest surface above it faces up: that surface is seen from behind. A cell
 * is given by the number of its height (its level), counted from the lowest, and by its column and row.
 */
public final class FieldColumns {
    private static final byte OPEN = 0;
    private static final byte INSIDE = 1;
    private static final byte NOTHING = 2;
    private static final byte OUTSIDE = 3;

    private final int columns;
    private final int rows;
    private final int levels;
    private final Plan plan;
    private final double[] ground;
    private final byte[] kinds;

    /** The positions of the columns, and the heights of their cells. */
    public interface Plan {
        /** The east coordinate of a column, m. */
        double x(int column, int row);

        /** The north coordinate of a column, m. */
        double y(int column, int row);

        /**
         * The height above the ground of a cell in a column, m; levels are counted from the lowest; NaN if there is no
         * such cell.
         */
        double above(int level, int column, int row);

        /** Whether a column is outside the area that counts. */
        default boolean isOutside(int column, int row) {
            return false;
        }
    }

    /** The columns of a grid, examined on the {@link Workers} of the calling thread. */
    public static FieldColumns of(World world, FieldGrid grid) {
        return square(world, grid, grid.heights().size(), (level, column, row) -> grid.heights()
                .get(level));
    }

    /**
     * The columns of a grid with one cell each, whose height may differ from column to column.
     *
     * @param above height of each cell above the ground, m, row by row from the north-west; NaN for a column without a
     *     cell
     */
    public static FieldColumns at(World world, FieldGrid grid, double[] above) {
        return square(world, grid, 1, (level, column, row) -> above[row * grid.columns() + column]);
    }

    /** The heights of cells above the ground, m. */
    private interface Heights {
        double above(int level, int column, int row);
    }

    private static FieldColumns square(World world, FieldGrid grid, int levels, Heights heights) {
        Plan square = new Plan() {
            @Override
            public double x(int column, int row) {
                return grid.x(column);
            }

            @Override
            public double y(int column, int row) {
                return grid.y(row);
            }

            @Override
            public double above(int level, int column, int row) {
                return heights.above(level, column, row);
            }

            @Override
            public boolean isOutside(int column, int row) {
                return grid.isOutside(column, row);
            }
        };
        return new FieldColumns(world, grid.columns(), grid.columns(), levels, square);
    }

    /**
     * Columns at any positions, with one or more cells each, examined on the {@link Workers} of the calling thread.
     *
     * @param columns number of columns in a row
     * @param levels number of cells in a column
     */
    public FieldColumns(World world, int columns, int rows, int levels, Plan plan) {
        this.columns = columns;
        this.rows = rows;
        this.levels = levels;
        this.plan = plan;
        this.ground = new double[columns * rows];
        this.kinds = new byte[ground.length * levels];
        Workers.forEach(rows, row -> {
            for (int column = 0; column < columns; column++) {
                if (plan.isOutside(column, row)) {
                    leaveOut(column, row);
                } else {
                    set(column, row, SurfaceColumn.at(world, plan.x(column, row), plan.y(column, row)));
                }
            }
        });
    }

    private FieldColumns(FieldColumns all, int level) {
        this.columns = all.columns;
        this.rows = all.rows;
        this.levels = 1;
        this.ground = all.ground;
        this.kinds = Arrays.copyOfRange(all.kinds, level * ground.length, (level + 1) * ground.length);
        this.plan = new Plan() {
            @Override
            public double x(int column, int row) {
                return all.plan.x(column, row);
            }

            @Override
            public double y(int column, int row) {
                return all.plan.y(column, row);
            }

            @Override
            public double above(int other, int column, int row) {
                return all.plan.above(level, column, row);
            }
        };
    }

    /** These columns with only one of their levels. */
    public FieldColumns at(int level) {
        return new FieldColumns(this, level);
    }

    private void leaveOut(int column, int row) {
        ground[row * columns + column] = Double.NaN;
        for (int level = 0; level < levels; level++) {
            kinds[index(level, column, row)] = OUTSIDE;
        }
    }

    private void set(int column, int row, SurfaceColumn surfaces) {
        Optional<SurfaceColumn.Surface> lowest = surfaces.ground();
        int cell = row * columns + column;
        ground[cell] = lowest.map(SurfaceColumn.Surface::z).orElse(Double.NaN);
        for (int level = 0; level < levels; level++) {
            double z = ground[cell] + plan.above(level, column, row);
            kinds[index(level, column, row)] = Double.isNaN(z) ? NOTHING : surfaces.isInside(z) ? INSIDE : OPEN;
        }
    }

    private int index(int height, int column, int row) {
        return (height * rows + row) * columns + column;
    }

    /** The number of columns in a row. */
    public int columns() {
        return columns;
    }

    /** The number of rows. */
    public int rows() {
        return rows;
    }

    /** The number of cells in a column. */
    public int levels() {
        return levels;
    }

    /** Whether there is ground below a column. */
    public boolean hasGround(int column, int row) {
        return !Double.isNaN(ground[row * columns + column]);
    }

    /** The number of columns with ground below them. */
    public int groundCount() {
        return (int) Arrays.stream(ground).filter(Double::isFinite).count();
    }

    /** The number of cells in which a drone can be. */
    public int openCount() {
        int count = 0;
        for (byte kind : kinds) {
            count += kind == OPEN ? 1 : 0;
        }
        return count;
    }

    /** The height of the ground, m; NaN where there is none. */
    public double ground(int column, int row) {
        return ground[row * columns + column];
    }

    /** Whether a cell is outside the area that counts. */
    public boolean isOutside(int height, int column, int row) {
        return kinds[index(height, column, row)] == OUTSIDE;
    }

    /** Whether a cell is inside something solid. */
    public boolean isInside(int height, int column, int row) {
        return kinds[index(height, column, row)] == INSIDE;
    }

    /** Whether a drone can be in a cell: there is ground below, and nothing solid around it. */
    public boolean isOpen(int height, int column, int row) {
        return kinds[index(height, column, row)] == OPEN;
    }

    /** The centre of a cell, m; only for columns with ground below them. */
    public Position middle(int height, int column, int row) {
        return new Position(
                plan.x(column, row), plan.y(column, row), ground(column, row) + plan.above(height, column, row));
    }
}
