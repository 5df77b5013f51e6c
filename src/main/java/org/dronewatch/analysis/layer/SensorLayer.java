package org.dronewatch.analysis.layer;

import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.CellCode;
import org.dronewatch.analysis.cell.FieldColumns;
import org.dronewatch.analysis.cell.Margin;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.Cause;

/**
 * One sensor's assessments of a drone in all cells on all courses: probability, cause and margin. Most assessments are
 * the same on every course, and take four bytes for each cell and height, with one {@link CellCode} for all courses;
 * the others take more.
 */
public final class SensorLayer {
    /**
     * By height and row, then column: the code of a cell where all courses are alike; otherwise minus one minus the
     * position in the row's bytes.
     */
    private final int[][] entries;

    /** By height and row: the codes of those cells whose courses are not alike. */
    private final byte[][] byCourse;

    private final int rows;

    private SensorLayer(int rows, int heights) {
        this.rows = rows;
        this.entries = new int[rows * heights][];
        this.byCourse = new byte[rows * heights][];
    }

    /** A layer in which all heights have been assessed. */
    public static SensorLayer of(FieldProbe probe, FieldColumns columns, IntConsumer progress) {
        SensorLayer layer = empty(columns);
        for (int height = 0; height < columns.levels(); height++) {
            layer.assess(probe, columns, height, Optional.empty(), progress);
        }
        return layer;
    }

    /**
     * A layer with one height, assembled on the {@link Workers} of the calling thread.
     *
     * @param codes the codes by row and column, as {@link LayerRow#codesAt} gives them; null in cells in which the
     *     drone cannot be
     */
    public static SensorLayer of(FieldProbe probe, FieldColumns columns, int[][] codes) {
        SensorLayer layer = new SensorLayer(columns.rows(), 1);
        Workers.forEach(columns.rows(), number -> {
            LayerRow row = new LayerRow(columns.columns(), probe, null);
            for (int column = 0; column < columns.columns(); column++) {
                int[] known = codes[number * columns.columns() + column];
                if (known != null) {
                    row.set(column, known);
                }
            }
            layer.entries[number] = row.entries();
            layer.byCourse[number] = row.byCourse();
        });
        return layer;
    }

    /** This layer with only one of its heights. */
    public SensorLayer at(int height) {
        SensorLayer alone = new SensorLayer(rows, 1);
        System.arraycopy(entries, height * rows, alone.entries, 0, rows);
        System.arraycopy(byCourse, height * rows, alone.byCourse, 0, rows);
        return alone;
    }

    /**
     * The codes of a cell at the lowest height, as {@link LayerRow#codesAt} gave them.
     *
     * @param courses number of courses
     */
    public int[] codes(int column, int row, int courses) {
        if (entries[row][column] >= 0) {
            return new int[] {entries[row][column]};
        }
        int[] codes = new int[courses];
        for (int course = 0; course < courses; course++) {
            codes[course] = at(0, column, row, course);
        }
        return codes;
    }

    /** A layer in which nothing has been assessed yet. */
    public static SensorLayer empty(FieldColumns columns) {
        return new SensorLayer(columns.rows(), columns.levels());
    }

    /**
     * Assesses a drone with one sensor in every cell of one height in which it can be, except for those that a former
     * slice holds, on the {@link Workers} of the calling thread; the same for any number of them.
     *
     * @param progress receives the number of cells done since the last call; from any thread
     * @return whether there were any cells that the former slice does not hold
     */
    boolean assess(
            FieldProbe probe, FieldColumns columns, int height, Optional<LayerSlice> former, IntConsumer progress) {
        AtomicBoolean isNew = new AtomicBoolean();
        Workers.forEach(rows, probe::newAssessor, (assessor, number) -> {
            LayerRow row = new LayerRow(columns.columns(), probe, assessor);
            for (int column = 0; column < columns.columns(); column++) {
                if (columns.isOpen(height, column, number)) {
                    Position at = columns.middle(height, column, number);
                    if (former.isPresent() && former.get().holds(column, number, at.z())) {
                        row.take(column, former.get(), number);
                    } else {
                        row.set(column, at);
                        isNew.set(true);
                    }
                }
            }
            entries[height * rows + number] = row.entries();
            byCourse[height * rows + number] = row.byCourse();
            progress.accept(columns.columns());
        });
        return isNew.get();
    }

    /** The assessments at one height. */
    LayerSlice slice(int height, FieldColumns columns) {
        double[] z = new double[rows * columns.columns()];
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns.columns(); column++) {
                z[row * columns.columns() + column] = columns.isOpen(height, column, row)
                        ? columns.middle(height, column, row).z()
                        : Double.NaN;
            }
        }
        int from = height * rows;
        return new LayerSlice(
                columns.columns(),
                z,
                Arrays.copyOfRange(entries, from, from + rows),
                Arrays.copyOfRange(byCourse, from, from + rows));
    }

    /** Whether a cell has the same assessment on all courses. */
    public boolean isSameOnAllCourses(int height, int column, int row) {
        return entries[height * rows + row][column] >= 0;
    }

    /**
     * The probability that the drone is detected, as a {@link ProbabilityStep step}; 0 in a cell in which it cannot be.
     */
    public int step(int height, int column, int row, int course) {
        return CellCode.step(at(height, column, row, course));
    }

    /**
     * Why one look misses the drone: {@link Cause#DETECTED} if it does not, {@link Cause#UNKNOWN} in a cell in which
     * the drone cannot be, or where the line of sight leaves the known ground.
     */
    public Cause cause(int height, int column, int row, int course) {
        return CellCode.cause(at(height, column, row, course));
    }

    /** The margin of the signal; {@link Margin.Known#NOTHING} in a cell in which the drone cannot be. */
    public Margin margin(int height, int column, int row, int course) {
        return CellCode.margin(at(height, column, row, course));
    }

    private int at(int height, int column, int row, int course) {
        int index = height * rows + row;
        int entry = entries[index][column];
        if (entry >= 0) {
            return entry;
        }
        return CourseCodes.at(byCourse[index], -1 - entry, course);
    }
}
