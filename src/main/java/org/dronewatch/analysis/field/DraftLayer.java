package org.dronewatch.analysis.field;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.dronewatch.analysis.cell.CellCode;
import org.dronewatch.analysis.cell.FieldColumns;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.analysis.layer.FieldProbe;
import org.dronewatch.analysis.layer.LayerRow;
import org.dronewatch.analysis.layer.SensorLayer;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;

/**
 * One sensor's assessments at one height while the sensor is moved. At first, one cell in each of a few large blocks is
 * assessed, then one in each smaller block; then, in ever smaller blocks, only where neighbours differ; and finally all
 * cells. Cells that have not been assessed have the assessment of their block. For use by one thread, which may have
 * {@link Workers}.
 */
final class DraftLayer {
    private static final int NONE = -1;

    /** Up to this number of blocks along a side, all are assessed: what is smaller may be missed at first. */
    private static final int EVERYWHERE = 26;

    private final FieldProbe probe;
    private final FieldColumns columns;

    /** The least number of steps of a covering sensor's probability. */
    private final int needed;

    private final int width;
    private final int height;

    /** By cell, as {@link LayerRow#codesAt} gives them; null where nothing is known. */
    private final int[][] codes;

    private final boolean[] isAssessed;

    /** The cells along the side of a block. */
    private final AtomicInteger step = new AtomicInteger(1);

    private volatile boolean isComplete;

    /**
     * A layer of which nothing is known.
     *
     * @param columns with one height
     * @param covered the probability with which the sensor covers a cell
     */
    DraftLayer(FieldProbe probe, FieldColumns columns, double covered) {
        this.probe = probe;
        this.columns = columns;
        this.needed = ProbabilityStep.toCover(covered);
        this.width = columns.columns();
        this.height = columns.rows();
        this.codes = new int[width * height][];
        this.isAssessed = new boolean[width * height];
    }

    /** Assesses one cell in each block of a number of cells along its side, a power of 2. */
    void begin(int side) {
        step.set(side);
        assess(everywhere(), () -> false);
    }

    private boolean[] everywhere() {
        boolean[] all = new boolean[across() * down()];
        Arrays.fill(all, true);
        return all;
    }

    /** The cells along the side of a block; 1 once the borders of what is covered are known. */
    int step() {
        return step.get();
    }

    private int across() {
        return (width + step() - 1) / step();
    }

    private int down() {
        return (height + step() - 1) / step();
    }

    /** The approximate number of cells that the next {@link #refine} would assess. */
    int next() {
        if (2 * across() <= EVERYWHERE) {
            return 3 * across() * down();
        }
        int count = 0;
        for (boolean is : border()) {
            count += is ? 2 : 0;
        }
        return count;
    }

    /**
     * Halves the blocks, and assesses all of them while they are large, then those that border on one with a different
     * result, until all of these have been assessed.
     */
    void refine(BooleanSupplier outdated) {
        step.updateAndGet(before -> before / 2);
        if (across() <= EVERYWHERE) {
            assess(everywhere(), outdated);
            return;
        }
        int found;
        do {
            found = assess(border(), outdated);
        } while (found > 0 && !outdated.getAsBoolean());
    }

    /** Assesses blocks, and returns the number of those that had not been assessed. */
    private int assess(boolean[] chosen, BooleanSupplier outdated) {
        AtomicInteger found = new AtomicInteger();
        int across = across();
        Workers.forEach(down(), () -> new LayerRow(1, probe, probe.newAssessor()), (looks, block) -> {
            for (int column = 0; column < across && !outdated.getAsBoolean(); column++) {
                if (chosen[block * across + column] && assessBlock(looks, column * step(), block * step())) {
                    found.incrementAndGet();
                }
            }
        });
        return found.get();
    }

    /**
     * Assesses the open cell that is nearest to the centre of a block, unless another cell of the block has been
     * assessed; returns whether it did so.
     */
    private boolean assessBlock(LayerRow looks, int west, int north) {
        int best = NONE;
        int nearest = Integer.MAX_VALUE;
        int east = Math.min(width, west + step());
        int south = Math.min(height, north + step());
        for (int row = north; row < south; row++) {
            for (int column = west; column < east; column++) {
                int cell = row * width + column;
                if (isAssessed[cell]) {
                    return false;
                }
                int dx = 2 * column + 1 - west - east;
                int dy = 2 * row + 1 - north - south;
                if (columns.isOpen(0, column, row) && dx * dx + dy * dy < nearest) {
                    nearest = dx * dx + dy * dy;
                    best = cell;
                }
            }
        }
        if (best != NONE) {
            assessCell(looks, best);
            fill(west, north, codes[best]);
        }
        return best != NONE;
    }

    private void assessCell(LayerRow looks, int cell) {
        Position at = columns.middle(0, cell % width, cell / width);
        codes[cell] = looks.codesAt(at);
        isAssessed[cell] = true;
    }

    private void fill(int west, int north, int[] known) {
        for (int row = north; row < Math.min(height, north + step()); row++) {
            for (int column = west; column < Math.min(width, west + step()); column++) {
                int cell = row * width + column;
                if (!isAssessed[cell] && columns.isOpen(0, column, row)) {
                    codes[cell] = known;
                }
            }
        }
    }

    /** For each block, whether a neighbouring block, also a diagonal one, looks different. */
    private boolean[] border() {
        int across = across();
        int down = down();
        int[] looks = new int[across * down];
        Arrays.setAll(looks, block -> look(block % across * step(), block / across * step()));
        boolean[] border = new boolean[looks.length];
        for (int row = 0; row < down; row++) {
            for (int column = 0; column < across; column++) {
                border[row * across + column] = isBorder(looks, across, down, column, row);
            }
        }
        return border;
    }

    private static boolean isBorder(int[] looks, int across, int down, int column, int row) {
        int own = looks[row * across + column];
        for (int r = Math.max(0, row - 1); r <= Math.min(down - 1, row + 1); r++) {
            for (int c = Math.max(0, column - 1); c <= Math.min(across - 1, column + 1); c++) {
                int other = looks[r * across + c];
                if (other != NONE && own != NONE && other != own) {
                    return true;
                }
            }
        }
        return false;
    }

    /**
     * What a block looks like: on which courses it is covered, and the causes on the others; {@link #NONE} where
     * nothing is known. Blocks with the same look need not have the same probability.
     */
    private int look(int west, int north) {
        for (int row = north; row < Math.min(height, north + step()); row++) {
            for (int column = west; column < Math.min(width, west + step()); column++) {
                int[] known = codes[row * width + column];
                if (known != null) {
                    return look(known);
                }
            }
        }
        return NONE;
    }

    private int look(int[] known) {
        int covering = 1;
        int causes = 0;
        for (int code : known) {
            covering = 31 * covering + (CellCode.step(code) >= needed ? 1 : 0);
            causes |= 1 << CellCode.cause(code).ordinal();
        }
        // Positive, so that it is never that of a block without cells.
        return (31 * covering + causes) & Integer.MAX_VALUE;
    }

    /** Assesses all cells that are left, unless it becomes outdated. */
    void complete(BooleanSupplier outdated) {
        AtomicInteger left = new AtomicInteger();
        Workers.forEach(height, () -> new LayerRow(1, probe, probe.newAssessor()), (looks, row) -> {
            for (int column = 0; column < width; column++) {
                int cell = row * width + column;
                if (!isAssessed[cell] && columns.isOpen(0, column, row)) {
                    if (outdated.getAsBoolean()) {
                        left.incrementAndGet();
                        return;
                    }
                    assessCell(looks, cell);
                }
            }
        });
        isComplete = left.get() == 0;
    }

    /** Whether all cells have been assessed. */
    boolean isComplete() {
        return isComplete;
    }

    /** The number of cells that have been assessed. */
    int assessed() {
        int count = 0;
        for (boolean is : isAssessed) {
            count += is ? 1 : 0;
        }
        return count;
    }

    /** What is known so far. */
    SensorLayer layer() {
        return SensorLayer.of(probe, columns, codes);
    }
}
