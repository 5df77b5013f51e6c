package org.dronewatch.analysis.field;

import java.util.Collection;
import java.util.OptionalInt;
import java.util.function.IntConsumer;
import java.util.function.IntToDoubleFunction;
import java.util.function.IntUnaryOperator;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.analysis.layer.Dominance;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.Cause;
import org.dronewatch.setting.Quantity;

/**
 * What a {@link DetectionField} means for a site: in each cell, on the course that counts there, whether a sensor
 * covers it, how many do, and the dominant cause. Cells are given as in the field. Immutable and thread-safe.
 *
 * <p>The course that counts is the same for all sensors: the one with the lowest, or the highest, joint probability
 * {@code 1 - (1 - p1)(1 - p2)...} of the sensors' probabilities p1, p2, ...; in a tie, the one whose dominant cause is
 * nearest to a detection in the order of {@link Cause}; then the first in the order of the field. A sensor covers a
 * cell where its probability there is at least a given value. The dominant cause is that of the sensor that decides
 * ({@link #deciding}).
 */
public final class FieldCoverage {
    /** Which course counts. */
    public enum Choice {
        /** The course on which the drone is least likely to be detected. */
        WORST,
        /** The course on which the drone is most likely to be detected. */
        BEST
    }

    /** The probability with which a sensor must detect the drone to cover a cell, unless another is requested. */
    public static final double DEFAULT_COVERED = 0.5;

    /**
     * The least probability that can be requested: two steps of 1/250. All probabilities above 0 and below 0.006
     * count as 1/250 in results, and are therefore indistinguishable there.
     */
    public static final double LEAST_COVERED = 0.008;

    /**
     * The greatest probability below 1 that can be requested: probabilities between this one and 1 are
     * indistinguishable from this one.
     */
    public static final double MOST_COVERED = 0.996;

    private static final Cause[] CAUSES = Cause.values();

    private final DetectionField field;
    private final Choice choice;
    private final double covered;

    /** The least number of steps of a covering sensor's probability. */
    private final int needed;

    private final short[] courses;
    private final byte[] causes;
    private final short[] counts;
    private final boolean[] unknown;

    /**
     * Evaluates a field on the {@link Workers} of the calling thread; the result does not depend on their number.
     *
     * @param covered the probability with which a sensor must detect the drone to cover a cell
     * @throws IllegalArgumentException as for {@link #checkedProbability}
     */
    public FieldCoverage(DetectionField field, Choice choice, double covered) {
        checkedProbability(covered);
        this.field = field;
        this.choice = choice;
        this.covered = covered;
        this.needed = ProbabilityStep.toCover(covered);
        int all = field.grid().cells() * field.grid().heights().size();
        this.courses = new short[all];
        this.causes = new byte[all];
        this.counts = new short[all];
        this.unknown = new boolean[all];
        int rows = field.grid().columns();
        Workers.forEach(rows * field.grid().heights().size(), index -> {
            for (int column = 0; column < rows; column++) {
                evaluate(index / rows, column, index % rows);
            }
        });
    }

    /**
     * Checks a probability that a sensor must reach to cover a cell, and returns it. The required probability is
     * rounded up to a step of 1/250, while the probability in a cell is rounded to the nearest step, so a cell may
     * count as covered although its probability is too low by up to 1/500.
     *
     * @throws IllegalArgumentException unless it is {@link #LEAST_COVERED} to {@link #MOST_COVERED}, or 1
     */
    public static double checkedProbability(double covered) {
        if (!(covered >= LEAST_COVERED && covered <= MOST_COVERED) && Double.compare(covered, 1.0) != 0) {
            throw new IllegalArgumentException(Quantity.RATIO.inWords(covered) + ": must be 0.008 to 0.996, or 1,"
                    + " since probabilities are kept in steps of 1/250");
        }
        return covered;
    }

    private void evaluate(int height, int column, int row) {
        int cell = index(height, column, row);
        if (!field.isOpen(height, column, row)) {
            unknown[cell] = !field.isInside(height, column, row) && !field.isOutside(height, column, row);
            return;
        }
        int course = course(height, column, row);
        int count = 0;
        int most = 0;
        boolean leaves = false;
        for (int sensor = 0; sensor < field.sensors().size(); sensor++) {
            int steps = field.step(sensor, height, column, row, course);
            Cause its = field.cause(sensor, height, column, row, course);
            count += steps >= needed ? 1 : 0;
            leaves |= its == Cause.UNKNOWN;
            most = Math.max(most, Dominance.rank(steps, its));
        }
        courses[cell] = (short) course;
        causes[cell] = (byte) Dominance.cause(most).ordinal();
        counts[cell] = (short) count;
        unknown[cell] = count == 0 && leaves;
    }

    /** The course that counts in a cell. */
    private int course(int height, int column, int row) {
        if (field.isSameOnAllCourses(height, column, row)) {
            return 0;
        }
        int chosen = 0;
        int highest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int course = 0; course < field.courses().size(); course++) {
            double missed = 1.0;
            int most = 0;
            for (int sensor = 0; sensor < field.sensors().size(); sensor++) {
                int steps = field.step(sensor, height, column, row, course);
                missed *= 1.0 - ProbabilityStep.stated(steps);
                most = Math.max(most, Dominance.rank(steps, field.cause(sensor, height, column, row, course)));
            }
            double rank = choice == Choice.WORST ? -missed : missed;
            int order = Double.compare(rank, least);
            // Of courses with the same joint probability, the one with the higher rank counts: a drone that is missed
            // on all courses is then not too slow if it would be missed at any speed, and the cause does not depend on
            // the order of the courses, which begin in the north.
            if (order < 0 || order == 0 && most > highest) {
                least = rank;
                chosen = course;
                highest = most;
            }
        }
        return chosen;
    }

    private int index(int height, int column, int row) {
        return (height * field.grid().columns() + row) * field.grid().columns() + column;
    }

    /**
     * One cell in each column, at its own height. Only what is covered and what is unknown can be relied on, nothing
     * else in this coverage.
     *
     * @param above heights above the ground by row and column, m; NaN for no cell
     * @param name the name under which stored assessments are found again
     */
    FieldCoverage at(double[] above, String name, IntConsumer progress) {
        return of(field.decidingAt(above, needed, name, progress));
    }

    /** Another field, evaluated in the same way. */
    private FieldCoverage of(DetectionField other) {
        return new FieldCoverage(other, choice, covered);
    }

    /**
     * The coverage that remains if some sensors fail, evaluated in the same way: the course that counts may then be
     * another one, chosen for the remaining sensors.
     *
     * @param sensors their names
     * @throws IllegalArgumentException when there is no such sensor
     */
    public FieldCoverage without(Collection<String> sensors) {
        DetectionField rest = field.without(sensors);
        return rest == field ? this : of(rest);
    }

    /** The field. */
    public DetectionField field() {
        return field;
    }

    /** Which course counts. */
    public Choice choice() {
        return choice;
    }

    /** The number of the course that counts in a cell. */
    public int courseAt(int height, int column, int row) {
        return courses[index(height, column, row)];
    }

    /**
     * Whether nothing can be said about a cell: either there is no ground below it, or no sensor covers it and the line
     * of sight of at least one sensor leaves the known ground.
     */
    public boolean isUnknown(int height, int column, int row) {
        return unknown[index(height, column, row)];
    }

    /** Whether a cell counts: it is neither unknown nor inside something solid, nor outside the area of the grid. */
    public boolean isKnown(int height, int column, int row) {
        return !isUnknown(height, column, row)
                && !field.isInside(height, column, row)
                && !field.isOutside(height, column, row);
    }

    /** The number of sensors that cover a cell. */
    public int count(int height, int column, int row) {
        return counts[index(height, column, row)];
    }

    /** Whether a sensor, given by its number, covers a cell on the course that counts there. */
    public boolean covers(int sensor, int height, int column, int row) {
        return field.isOpen(height, column, row)
                && field.step(sensor, height, column, row, courseAt(height, column, row)) >= needed;
    }

    /** Whether any sensor covers a cell. */
    public boolean isCovered(int height, int column, int row) {
        return count(height, column, row) > 0;
    }

    /** The dominant cause in a cell that is known. */
    public Cause cause(int height, int column, int row) {
        return CAUSES[causes[index(height, column, row)]];
    }

    /**
     * Why a sensor, given by its number, does not detect the drone in a cell, on the course that counts there;
     * {@link Cause#DETECTED} if one look detects it.
     */
    public Cause cause(int sensor, int height, int column, int row) {
        return field.cause(sensor, height, column, row, courseAt(height, column, row));
    }

    /**
     * The sensor whose cause is the dominant one in a cell in which a drone can be: the one with the highest
     * probability; in a tie, the one whose cause is nearest to a detection in the order of {@link Cause}; then the one
     * with the greatest margin in dB; then the first.
     *
     * @return the number of the sensor; empty if there is none, or if the margins that the field keeps do not decide
     */
    public OptionalInt deciding(int height, int column, int row) {
        int sensors = field.sensors().size();
        int course = courseAt(height, column, row);
        return sensors == 0
                ? OptionalInt.empty()
                : Dominance.certain(
                        sensors,
                        ranks(height, column, row, course),
                        sensor -> field.margin(sensor, height, column, row, course));
    }

    /**
     * The number of the sensor whose cause is the dominant one in a cell in which a drone can be, decided by the exact
     * margins of all sensors, dB; there must be at least one sensor.
     */
    public int deciding(int height, int column, int row, IntToDoubleFunction margins) {
        return Dominance.of(field.sensors().size(), ranks(height, column, row, courseAt(height, column, row)), margins);
    }

    private IntUnaryOperator ranks(int height, int column, int row, int course) {
        return sensor -> Dominance.rank(
                field.step(sensor, height, column, row, course), field.cause(sensor, height, column, row, course));
    }
}
