package org.dronewatch.analysis.survey;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.sensor.Cause;

/** All gaps in the coverage at one height, the largest first, and the cells that belong to each. Immutable. */
public final class GapMap {
    private static final int NONE = -1;

    private final FieldCoverage coverage;
    private final FieldGrid grid;
    private final int height;
    private final int side;

    /** The number of the gap to which each cell belongs. */
    private final int[] gaps;

    private final List<Gap> all;

    private GapMap(FieldCoverage coverage, int height) {
        this.coverage = coverage;
        this.grid = coverage.field().grid();
        this.height = height;
        this.side = grid.columns();
        this.gaps = new int[grid.cells()];
        Arrays.fill(gaps, NONE);
        int[] queue = new int[grid.cells()];
        List<Gap> found = describe(mark(queue), innermost(queue));
        List<Integer> order =
                new ArrayList<>(IntStream.range(0, found.size()).boxed().toList());
        // The sort is stable: among equals, the first from the north-west stays the first.
        order.sort(Comparator.comparingInt((Integer gap) -> -found.get(gap).cells()));
        this.all = order.stream().map(found::get).toList();
        int[] rank = new int[order.size()];
        for (int i = 0; i < rank.length; i++) {
            rank[order.get(i)] = i;
        }
        for (int cell = 0; cell < gaps.length; cell++) {
            gaps[cell] = gaps[cell] == NONE ? NONE : rank[gaps[cell]];
        }
    }

    /** The gaps at a height, given by its number in the grid. */
    public static GapMap of(FieldCoverage coverage, int height) {
        return new GapMap(coverage, height);
    }

    /** The gaps from the largest to the smallest; gaps of equal size in order from the north-west. */
    public List<Gap> gaps() {
        return all;
    }

    /** The number of the height in the grid. */
    public int height() {
        return height;
    }

    /** The coverage. */
    public FieldCoverage coverage() {
        return coverage;
    }

    /** Whether a cell belongs to a gap, given by its number in {@link #gaps()}; false outside the grid. */
    public boolean contains(int gap, int column, int row) {
        return column >= 0 && row >= 0 && column < side && row < side && gaps[grid.cell(column, row)] == gap;
    }

    /** The cells of a gap, row by row from the north-west, given by their {@link FieldGrid#cell numbers}. */
    public int[] cells(int gap) {
        return IntStream.range(0, gaps.length).filter(cell -> gaps[cell] == gap).toArray();
    }

    private boolean isBare(int cell) {
        int column = grid.column(cell);
        int row = grid.row(cell);
        return coverage.isKnown(height, column, row) && !coverage.isCovered(height, column, row);
    }

    /** Gives the cells of each gap its number; returns how many gaps there are. */
    private int mark(int[] queue) {
        int count = 0;
        for (int cell = 0; cell < gaps.length; cell++) {
            if (gaps[cell] == NONE && isBare(cell)) {
                fill(cell, count++, queue);
            }
        }
        return count;
    }

    /** Marks all cells that are connected to one. */
    private void fill(int start, int gap, int[] queue) {
        int end = 0;
        gaps[start] = gap;
        queue[end++] = start;
        for (int next = 0; next < end; next++) {
            for (int i = 0; i < 4; i++) {
                int neighbour = neighbour(queue[next], i);
                if (neighbour != NONE && gaps[neighbour] == NONE && isBare(neighbour)) {
                    gaps[neighbour] = gap;
                    queue[end++] = neighbour;
                }
            }
        }
    }

    /** The cell to the north, west, east or south of another. */
    private int neighbour(int cell, int direction) {
        int column = cell % side;
        return switch (direction) {
            case 0 -> cell >= side ? cell - side : NONE;
            case 1 -> column > 0 ? cell - 1 : NONE;
            case 2 -> column < side - 1 ? cell + 1 : NONE;
            default -> cell < side * (side - 1) ? cell + side : NONE;
        };
    }

    /**
     * How many steps each cell is away from what does not belong to its gap, 1 at the border, found layer by layer from
     * outside; 0 for other cells.
     */
    private int[] innermost(int[] queue) {
        int[] depth = new int[gaps.length];
        int end = 0;
        for (int cell = 0; cell < gaps.length; cell++) {
            if (gaps[cell] != NONE && isBorder(cell)) {
                depth[cell] = 1;
                queue[end++] = cell;
            }
        }
        for (int next = 0; next < end; next++) {
            for (int i = 0; i < 4; i++) {
                int neighbour = neighbour(queue[next], i);
                if (neighbour != NONE && gaps[neighbour] != NONE && depth[neighbour] == 0) {
                    depth[neighbour] = depth[queue[next]] + 1;
                    queue[end++] = neighbour;
                }
            }
        }
        return depth;
    }

    private boolean isBorder(int cell) {
        for (int i = 0; i < 4; i++) {
            int next = neighbour(cell, i);
            if (next == NONE || gaps[next] == NONE) {
                return true;
            }
        }
        return false;
    }

    private List<Gap> describe(int count, int[] depth) {
        int[] inner = new int[count];
        Arrays.fill(inner, NONE);
        boolean[] touchesRim = new boolean[count];
        List<Map<Cause, Integer>> causes = new ArrayList<>();
        for (int gap = 0; gap < count; gap++) {
            causes.add(new EnumMap<>(Cause.class));
        }
        for (int cell = 0; cell < gaps.length; cell++) {
            int gap = gaps[cell];
            if (gap != NONE) {
                causes.get(gap).merge(coverage.cause(height, grid.column(cell), grid.row(cell)), 1, Integer::sum);
                touchesRim[gap] |= isOnRim(cell);
                inner[gap] = inner[gap] == NONE || depth[cell] > depth[inner[gap]] ? cell : inner[gap];
            }
        }
        List<Gap> found = new ArrayList<>();
        for (int gap = 0; gap < count; gap++) {
            double x = grid.x(grid.column(inner[gap]));
            double y = grid.y(grid.row(inner[gap]));
            found.add(Gap.of(causes.get(gap), grid.cellArea(), x, y, touchesRim[gap]));
        }
        return found;
    }

    private boolean isOnRim(int cell) {
        return IntStream.range(0, 4).map(i -> neighbour(cell, i)).anyMatch(this::isOutside);
    }

    private boolean isOutside(int cell) {
        return cell == NONE || coverage.field().isOutside(height, grid.column(cell), grid.row(cell));
    }
}
