package org.dronewatch.report.map;

import java.util.ArrayList;
import java.util.List;

/**
 * The outline of cells of a square grid as rings of corners: the outer one counterclockwise, seen with north up, and
 * those of holes clockwise. Where two cells touch at a corner only, the ring continues along the other one, so that no
 * ring passes a corner twice; rings may touch at corners.
 */
final class CellRings {
    /** Steps along the four sides, to the east, north, west and south: rows count from the north. */
    private static final int[] DX = {1, 0, -1, 0};

    private static final int[] DY = {0, -1, 0, 1};

    /** On a map of longitude and latitude, a straight side is bent, so it has a corner after this number of cells. */
    private static final int LONGEST_SIDE = 64;

    private final Cells cells;
    private final int columns;

    /** For each corner and direction, whether a ring has left the corner in that direction. */
    private final boolean[] used;

    /** The cells that the rings surround. */
    @FunctionalInterface
    interface Cells {
        /** Whether a cell belongs to them; false outside the grid. */
        boolean contains(int column, int row);
    }

    private CellRings(Cells cells, int columns) {
        this.cells = cells;
        this.columns = columns;
        this.used = new boolean[(columns + 1) * (columns + 1) * DX.length];
    }

    /**
     * The rings around connected cells.
     *
     * @param columns cells along a side of the grid
     * @return the outer ring first; corners as pairs of column and row, counted from the north-western corner of the
     *     grid; the last one is the first again
     */
    static List<List<int[]>> of(Cells cells, int columns) {
        CellRings rings = new CellRings(cells, columns);
        List<List<int[]>> all = new ArrayList<>();
        for (int y = 0; y <= columns; y++) {
            for (int x = 0; x <= columns; x++) {
                // The first corner from the north is one of the outer ring.
                for (int direction = 0; direction < DX.length; direction++) {
                    if (rings.isSide(x, y, direction) && !rings.used[rings.index(x, y, direction)]) {
                        all.add(rings.follow(x, y, direction));
                    }
                }
            }
        }
        return all;
    }

    private int index(int x, int y, int direction) {
        return (y * (columns + 1) + x) * DX.length + direction;
    }

    /** Whether a side has a cell on its left, and none on its right. */
    private boolean isSide(int x, int y, int direction) {
        return switch (direction) {
            case 0 -> cells.contains(x, y - 1) && !cells.contains(x, y);
            case 1 -> cells.contains(x - 1, y - 1) && !cells.contains(x, y - 1);
            case 2 -> cells.contains(x - 1, y) && !cells.contains(x - 1, y - 1);
            default -> cells.contains(x, y) && !cells.contains(x - 1, y);
        };
    }

    private List<int[]> follow(int startX, int startY, int startDirection) {
        List<int[]> ring = new ArrayList<>();
        int x = startX;
        int y = startY;
        int direction = startDirection;
        int length = 0;
        do {
            used[index(x, y, direction)] = true;
            x += DX[direction];
            y += DY[direction];
            length++;
            int next = next(x, y, direction);
            if (next != direction || length == LONGEST_SIDE) {
                ring.add(new int[] {x, y});
                length = 0;
            }
            direction = next;
        } while (x != startX || y != startY || direction != startDirection);
        ring.add(ring.get(0));
        return ring;
    }

    /**
     * The next direction: right is tried before straight on and left, so that a ring continues along a cell that
     * touches only at the corner.
     */
    private int next(int x, int y, int direction) {
        for (int turn = 3; turn <= 5; turn++) {
            int next = (direction + turn) % DX.length;
            if (isSide(x, y, next)) {
                return next;
            }
        }
        throw new IllegalStateException("a ring ends at corner " + x + ", " + y);
    }
}
