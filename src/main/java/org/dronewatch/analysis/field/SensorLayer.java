package org.dronewatch.analysis.field;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.IntConsumer;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.AssessmentBounds;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Cause;

/**
 * One sensor's assessments of a drone in all cells on all courses: probability and cause. Most of them are the
 * same on every course, and take four bytes for each cell and height; the others take two bytes more for each course.
 *
 * <p>A probability is kept in steps of 1/250, where 0 and 250 mean exactly 0 and 1.
 */
final class SensorLayer {
    /** The steps of a probability. */
    static final int STEPS = 250;

    private static final Cause[] CAUSES = Cause.values();
    private static final int CAUSE_SHIFT = 8;
    private static final int BYTE = 0xFF;

    /**
     * By height and row, then column: probability and cause where all courses are alike; otherwise minus one minus the
     * position in the row's bytes.
     */
    private final int[][] entries;

    /** By height and row: the probabilities and causes of those cells whose courses are not alike. */
    private final byte[][] byCourse;

    private final int rows;

    private SensorLayer(int rows, int heights) {
        this.rows = rows;
        this.entries = new int[rows * heights][];
        this.byCourse = new byte[rows * heights][];
    }

    /** A layer in which all heights have been assessed, as below. */
    static SensorLayer of(FieldProbe probe, FieldColumns columns, IntConsumer progress) {
        SensorLayer layer = empty(columns);
        for (int height = 0; height < columns.levels(); height++) {
            layer.assess(probe, columns, height, Optional.empty(), progress);
        }
        return layer;
    }

    /** A layer in which nothing has been assessed yet. */
    static SensorLayer empty(FieldColumns columns) {
        return new SensorLayer(columns.rows(), columns.levels());
    }

    /**
     * Assesses a drone with one sensor in every cell of one height in which it can be, except for those that a former
     * slice holds, on the {@link Workers} of the calling thread; the same for any number of them.
     *
     * @param progress receives the number of cells done since the last call; from any thread
     * @return whether there were any that it does not hold
     */
    boolean assess(
            FieldProbe probe, FieldColumns columns, int height, Optional<LayerSlice> former, IntConsumer progress) {
        AtomicBoolean isNew = new AtomicBoolean();
        Workers.forEach(rows, probe::newAssessor, (assessor, number) -> {
            Row row = new Row(columns.columns(), probe.courses().size());
            for (int column = 0; column < columns.columns(); column++) {
                if (columns.isOpen(height, column, number)) {
                    Position at = columns.middle(height, column, number);
                    if (former.isPresent() && former.get().holds(column, number, at.z())) {
                        row.take(column, former.get(), number);
                    } else {
                        row.set(column, probe, assessor, at);
                        isNew.set(true);
                    }
                }
            }
            entries[height * rows + number] = row.entries;
            byCourse[height * rows + number] = Arrays.copyOf(row.pool, row.used);
            progress.accept(columns.columns());
        });
        return isNew.get();
    }

    /** The assessments at one height. */
    LayerSlice slice(int height, FieldColumns columns) {
        double[] z = new double[rows * columns.columns()];
        for (int cell = 0; cell < z.length; cell++) {
            int column = cell % columns.columns();
            int row = cell / columns.columns();
            z[cell] = columns.isOpen(height, column, row)
                    ? columns.middle(height, column, row).z()
                    : Double.NaN;
        }
        int from = height * rows;
        return new LayerSlice(
                columns.columns(),
                z,
                Arrays.copyOfRange(entries, from, from + rows),
                Arrays.copyOfRange(byCourse, from, from + rows));
    }

    /** Whether an entry, and what it points to, can be those of a cell on a number of courses. */
    static boolean isPossible(int entry, byte[] pool, int courses) {
        if (entry >= 0) {
            return isPossible(entry);
        }
        long at = -1L - entry;
        if (at + 2L * courses > pool.length) {
            return false;
        }
        for (int course = 0; course < courses; course++) {
            if (!isPossible(codeAt(pool, (int) at + 2 * course))) {
                return false;
            }
        }
        return true;
    }

    private static boolean isPossible(int code) {
        return (code & BYTE) <= STEPS && code >> CAUSE_SHIFT < CAUSES.length;
    }

    private static int codeAt(byte[] pool, int at) {
        return pool[at] & BYTE | (pool[at + 1] & BYTE) << CAUSE_SHIFT;
    }

    /** The probability that the drone is detected, in steps of 1/250; 0 in a cell in which it cannot be. */
    int steps(int height, int column, int row, int course) {
        return at(height, column, row, course) & BYTE;
    }

    /** Why it is missed; {@link Cause#UNKNOWN} in a cell in which it cannot be. */
    Cause cause(int height, int column, int row, int course) {
        return CAUSES[at(height, column, row, course) >> CAUSE_SHIFT];
    }

    private int at(int height, int column, int row, int course) {
        int index = height * rows + row;
        int entry = entries[index][column];
        if (entry >= 0) {
            return entry;
        }
        return codeAt(byCourse[index], -1 - entry + 2 * course);
    }

    /** One row of cells while it is assessed. */
    private static final class Row {
        private final int courses;
        private final int[] entries;
        private final int[] codes;
        private byte[] pool = new byte[0];
        private int used;

        Row(int columns, int courses) {
            this.courses = courses;
            this.entries = new int[columns];
            this.codes = new int[courses];
        }

        void set(int column, FieldProbe probe, Assessor assessor, Position at) {
            if (probe.search().isPresent()) {
                search(column, probe, assessor, at, probe.search().get());
                return;
            }
            Optional<Pointing> pointing = probe.pointing(at);
            OptionalInt certain = code(probe, assessor.boundAtAllHeadings(probe.drone(), at, pointing));
            if (certain.isPresent()) {
                entries[column] = certain.getAsInt();
                return;
            }
            codes[0] = code(probe, assessor, at, 0, pointing);
            boolean alike = true;
            if (courses > 1 && !assessor.isSameAtAllHeadings(probe.drone(at, 0), pointing)) {
                for (int course = 1; course < courses; course++) {
                    codes[course] = code(probe, assessor, at, course, pointing);
                    alike &= codes[course] == codes[0];
                }
            }
            entries[column] = alike ? codes[0] : -1 - keep();
        }

        /** Over one period of the sensor's search. */
        private void search(int column, FieldProbe probe, Assessor assessor, Position at, SearchPeriod period) {
            CellPointings pointings = period.at(at, probe.drone().radius());
            boolean alike = true;
            for (int course = 0; course < courses; course++) {
                Drone there = probe.drone(at, course);
                codes[course] = code(probe.lookInSteps(assessor, there, pointings));
                alike &= codes[course] == codes[0];
                if (course == 0 && pointings.isSameAtAllHeadings(assessor, there)) {
                    break;
                }
            }
            entries[column] = alike ? codes[0] : -1 - keep();
        }

        private static int code(CellLook look) {
            Cause cause = look.assessment().cause();
            int steps = cause == Cause.UNKNOWN ? 0 : steps(look.probability());
            return steps | cause.ordinal() << CAUSE_SHIFT;
        }

        /** Where bounds are too far apart, the drone is assessed. */
        private static int code(
                FieldProbe probe, Assessor assessor, Position at, int course, Optional<Pointing> pointing) {
            FlightState state = probe.state(at, course);
            OptionalInt certain = code(probe, assessor.bound(probe.drone(), state, pointing, probe::steps));
            return certain.isPresent()
                    ? certain.getAsInt()
                    : code(probe, probe.assessInSteps(assessor, probe.drone().at(state), pointing));
        }

        /** Empty where bounds are more than a step apart. */
        private static OptionalInt code(FieldProbe probe, Optional<AssessmentBounds> found) {
            if (found.isEmpty()) {
                return OptionalInt.empty();
            }
            AssessmentBounds bounds = found.get();
            int steps = probe.steps(bounds.least());
            return steps == probe.steps(bounds.greatest())
                    ? OptionalInt.of(steps | bounds.cause().ordinal() << CAUSE_SHIFT)
                    : OptionalInt.empty();
        }

        /** Takes over what was assessed before. */
        void take(int column, LayerSlice former, int row) {
            int entry = former.entries()[row][column];
            if (entry >= 0) {
                entries[column] = entry;
                return;
            }
            for (int course = 0; course < courses; course++) {
                codes[course] = codeAt(former.byCourse()[row], -1 - entry + 2 * course);
            }
            entries[column] = -1 - keep();
        }

        private int keep() {
            int at = used;
            if (pool.length < used + 2 * courses) {
                pool = Arrays.copyOf(pool, 2 * pool.length + 2 * courses);
            }
            for (int course = 0; course < courses; course++) {
                pool[used++] = (byte) codes[course];
                pool[used++] = (byte) (codes[course] >> CAUSE_SHIFT);
            }
            return at;
        }

        /** A sensor whose line of sight leaves the known ground is not counted on. */
        private static int code(FieldProbe probe, Assessment assessment) {
            Cause cause = assessment.cause();
            int steps = cause == Cause.UNKNOWN ? 0 : probe.steps(assessment.probability());
            return steps | cause.ordinal() << CAUSE_SHIFT;
        }
    }

    /** The least number of steps of a probability with which a sensor covers a cell. */
    static int stepsToCover(double covered) {
        return (int) Math.ceil(covered * STEPS - 1e-9);
    }

    /** A probability in steps of 1/250: 0 and 250 for exactly 0 and 1 alone. */
    static int steps(double probability) {
        if (probability <= 0.0 || probability >= 1.0) {
            return probability <= 0.0 ? 0 : STEPS;
        }
        return Math.max(1, Math.min(STEPS - 1, (int) Math.rint(STEPS * probability)));
    }
}
