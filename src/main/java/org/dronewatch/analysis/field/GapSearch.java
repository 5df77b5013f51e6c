package org.dronewatch.analysis.field;

import java.util.Arrays;
import java.util.Optional;
import org.dronewatch.sensor.Cause;

/** Finds the largest gap at one height. */
final class GapSearch {
    private static final int NONE = -1;

    private final FieldCoverage coverage;
    private final FieldGrid grid;
    private final int height;
    private final int side;

    /** The number of the gap to which each cell belongs. */
    private final int[] gaps;

    /** Cells whose neighbours are still to be visited. */
    private final int[] queue;

    GapSearch(FieldCoverage coverage, int height) {
        this.coverage = coverage;
        this.grid = coverage.field().grid();
        this.height = height;
        this.side = grid.columns();
        this.gaps = new int[grid.cells()];
        this.queue = new int[grid.cells()];
        Arrays.fill(gaps, NONE);
    }

    Optional<Gap> largest() {
        int most = 0;
        int largest = NONE;
        for (int cell = 0; cell < gaps.length; cell++) {
            if (gaps[cell] == NONE && isBare(cell)) {
                int cells = fill(cell, cell);
                if (cells > most) {
                    most = cells;
                    largest = cell;
                }
            }
        }
        return largest == NONE ? Optional.empty() : Optional.of(describe(largest, most));
    }

    private boolean isBare(int cell) {
        int column = cell % side;
        int row = cell / side;
        return coverage.isKnown(height, column, row) && !coverage.isCovered(height, column, row);
    }

    /** Marks all cells that are connected to one; returns their number. */
    private int fill(int start, int gap) {
        int end = 0;
        gaps[start] = gap;
        queue[end++] = start;
        for (int next = 0; next < end; next++) {
            for (int neighbour : neighbours(queue[next])) {
                if (neighbour != NONE && gaps[neighbour] == NONE && isBare(neighbour)) {
                    gaps[neighbour] = gap;
                    queue[end++] = neighbour;
                }
            }
        }
        return end;
    }

    private int[] neighbours(int cell) {
        int column = cell % side;
        return new int[] {
            cell >= side ? cell - side : NONE,
            column > 0 ? cell - 1 : NONE,
            column < side - 1 ? cell + 1 : NONE,
            cell < side * (side - 1) ? cell + side : NONE
        };
    }

    private Gap describe(int gap, int cells) {
        int[] byCause = new int[Cause.values().length];
        boolean touchesRim = false;
        for (int cell = 0; cell < gaps.length; cell++) {
            if (gaps[cell] == gap) {
                byCause[coverage.cause(height, cell % side, cell / side).ordinal()]++;
                touchesRim |= Arrays.stream(neighbours(cell)).anyMatch(next -> next == NONE);
            }
        }
        int cause = 0;
        for (int i = 0; i < byCause.length; i++) {
            cause = byCause[i] >= byCause[cause] ? i : cause;
        }
        int inner = innermost(gap);
        return new Gap(
                cells,
                cells * grid.cellArea(),
                grid.x(inner % side),
                grid.y(inner / side),
                Cause.values()[cause],
                touchesRim);
    }

    /** The cell that is most steps away from what does not belong to the gap: found layer by layer from outside. */
    private int innermost(int gap) {
        int[] depth = new int[gaps.length];
        int end = 0;
        for (int cell = 0; cell < gaps.length; cell++) {
            boolean isBorder = gaps[cell] == gap
                    && Arrays.stream(neighbours(cell)).anyMatch(next -> next == NONE || gaps[next] != gap);
            if (isBorder) {
                depth[cell] = 1;
                queue[end++] = cell;
            }
        }
        for (int next = 0; next < end; next++) {
            for (int neighbour : neighbours(queue[next])) {
                if (neighbour != NONE && gaps[neighbour] == gap && depth[neighbour] == 0) {
                    depth[neighbour] = depth[queue[next]] + 1;
                    queue[end++] = neighbour;
                }
            }
        }
        int inner = 0;
        for (int cell = 0; cell < depth.length; cell++) {
            inner = depth[cell] > depth[inner] ? cell : inner;
        }
        return inner;
    }
}
