package org.dronewatch.analysis.cell;

import java.util.List;
import java.util.Optional;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * Columns of air over a site, square in plan view, with a cell at each of several heights. The values of a cell hold
 * for the point at its height on the axis of its column.
 *
 * @param east east coordinate of the centre, -100,000 to 100,000 m
 * @param north north coordinate of the centre, -100,000 to 100,000 m
 * @param side length of a side, above 0 and at most 100,000 m; rounded to a whole number of cells
 * @param cell length of a cell's side, above 0 and at most 100,000 m; at most 2000 cells along a side
 * @param heights heights above the ground, in ascending order, each at least 1 mm above the one before it (the first
 *     above the ground) and at most 10,000 m; 1 to 50 heights
 * @param area only cells whose centre lies in this area in plan view count; empty if all cells count
 */
public record FieldGrid(
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double east,
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double north,
        @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) double side,
        @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) double cell,
        List<Double> heights,
        Optional<AreaZone> area) {
    /**
     * Heights that are commonly planned for: the EU's open category ends at 120 m, and manned flight usually begins at
     * 150 m.
     */
    public static final List<Double> HEIGHTS = List.of(10.0, 30.0, 60.0, 120.0, 150.0);

    /** The default side of the area around the sensors, m. */
    public static final double DEFAULT_SIDE = 500.0;

    /** The default number of cells along a side. */
    public static final double DEFAULT_CELLS = 100.0;

    /** Maximum number of cells along a side. */
    public static final int MOST_CELLS = 2000;

    /** Maximum number of heights. */
    public static final int MOST_HEIGHTS = 50;

    /** The least difference of two heights, m: maps at heights that are closer would have the same name. */
    private static final double CLOSEST = 1e-3;

    /** By how much the difference of two rounded heights may fall short, m. */
    private static final double ROUNDING = 1e-9;

    /** The greatest height, m. */
    public static final double HIGHEST = 10_000.0;

    /** An action on a cell, given by its column from the west and its row from the north. */
    @FunctionalInterface
    public interface CellVisitor {
        /** Called once for each cell. */
        void visit(int column, int row);
    }

    /** A property that a cell may have. */
    @FunctionalInterface
    public interface CellTest {
        /** Whether a cell, given by its column from the west and its row from the north, has the property. */
        boolean isTrue(int column, int row);
    }

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range, or the heights are not in ascending order
     */
    public FieldGrid {
        Limits.check(FieldGrid.class, east, north, side, cell, heights, area);
        heights = checkedHeights(heights);
        if (Math.rint(side / cell) > MOST_CELLS) {
            throw new IllegalArgumentException("side " + side + " m with cells of " + cell + " m gives "
                    + (long) Math.rint(side / cell) + " cells along each side: there must be at most " + MOST_CELLS);
        }
    }

    /** A grid all of whose cells count. */
    public FieldGrid(double east, double north, double side, double cell, List<Double> heights) {
        this(east, north, side, cell, heights, Optional.empty());
    }

    /**
     * A square grid around the given centre, all of whose cells count.
     *
     * @throws IllegalArgumentException if a value is out of range, or a cell is longer than the side
     */
    public static FieldGrid square(double east, double north, double side, double cell, List<Double> heights) {
        FieldGrid grid = new FieldGrid(east, north, side, cell, heights);
        if (cell > side) {
            throw new IllegalArgumentException(
                    "a cell of " + cell + " m is longer than the side of the area, " + side + " m");
        }
        return grid;
    }

    /** The smallest square grid, with cells of a given side, m, that holds all cells whose centre is in an area. */
    public static FieldGrid over(AreaZone area, double cell, List<Double> heights) {
        PlanBounds bounds = PlanBounds.of(area.outline());
        return new FieldGrid(bounds.east(), bounds.north(), bounds.side(), cell, heights, Optional.of(area));
    }

    /**
     * Checks that a grid may have the given heights above the ground, m, and returns them.
     *
     * @throws IllegalArgumentException if a height is out of range, or the heights are not in ascending order
     */
    public static List<Double> checkedHeights(List<Double> heights) {
        if (heights.isEmpty() || heights.size() > MOST_HEIGHTS) {
            throw new IllegalArgumentException(heights.size() + " heights: there must be 1 to " + MOST_HEIGHTS);
        }
        double below = 0.0;
        for (double height : heights) {
            if (!(height - below >= CLOSEST - ROUNDING) || height > HIGHEST) {
                throw new IllegalArgumentException("height " + height + " m after " + below
                        + " m: heights must be in ascending order, each at least 1 mm above the one before it (the"
                        + " first above the ground), and at most " + HIGHEST + " m");
            }
            below = height;
        }
        return List.copyOf(heights);
    }

    /** Number of columns along a side, 1 or more. */
    public int columns() {
        return Math.max(1, (int) Math.rint(side / cell));
    }

    /** Number of cells at a height. */
    public int cells() {
        return columns() * columns();
    }

    /** Visits all cells at a height, row by row from the north-west. */
    public void forEachCell(CellVisitor visitor) {
        int columns = columns();
        for (int row = 0; row < columns; row++) {
            for (int column = 0; column < columns; column++) {
                visitor.visit(column, row);
            }
        }
    }

    /** The number of cells at a height that have a property. */
    public int count(CellTest test) {
        int[] count = {0};
        forEachCell((column, row) -> count[0] += test.isTrue(column, row) ? 1 : 0);
        return count[0];
    }

    /** The number of a cell, in the order of {@link #forEachCell}. */
    public int cell(int column, int row) {
        return row * columns() + column;
    }

    /** The column of a cell, given by its number. */
    public int column(int cell) {
        return cell % columns();
    }

    /** The row of a cell, given by its number. */
    public int row(int cell) {
        return cell / columns();
    }

    /** This grid with only its lowest heights. */
    public FieldGrid lowest(int count) {
        return new FieldGrid(east, north, side, cell, heights.subList(0, count), area);
    }

    /** Whether the centre of a column is outside the area that counts. */
    public boolean isOutside(int column, int row) {
        return area.isPresent() && !area.get().covers(x(column), y(row));
    }

    /** Area of a cell, m2. */
    public double cellArea() {
        return cell * cell;
    }

    /** East coordinate of the centre of a column, counted from the west, m. */
    public double x(int column) {
        return east + (column + 0.5 - 0.5 * columns()) * cell;
    }

    /** North coordinate of the centre of a row, counted from the north, m. */
    public double y(int row) {
        return north - (row + 0.5 - 0.5 * columns()) * cell;
    }

    /**
     * The depth of the layer of air around a height, given by its number, m: each layer extends halfway to the
     * neighbouring heights; the lowest begins at the ground, and the highest ends at its own height.
     */
    public double depth(int height) {
        int last = heights.size() - 1;
        double bottom = height == 0 ? 0.0 : 0.5 * (heights.get(height - 1) + heights.get(height));
        double top = height == last ? heights.get(last) : 0.5 * (heights.get(height) + heights.get(height + 1));
        return top - bottom;
    }
}
