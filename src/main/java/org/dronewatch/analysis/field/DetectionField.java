package org.dronewatch.analysis.field;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldColumns;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.Margin;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.analysis.layer.ExcessMap;
import org.dronewatch.analysis.layer.InterpolationError;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.setting.Spelling;

/**
 * The detection field of a site for one drone: in cells at several heights and on several courses, the probability that
 * each sensor detects it, in one look or within a given time, the cause where one look is not sufficient, and the
 * margin of the signal. A sensor on a positioner either has turned to the drone or is searching. Everything is assessed
 * once, as in a run; afterwards, any course can be queried without tracing another ray.
 *
 * <p>Probabilities are kept as {@link ProbabilityStep steps}; 0 and 1 are exact. Cells are given by the number of the
 * height in the grid, the column from the west and the row from the north. Immutable and thread-safe.
 */
public final class DetectionField {
    private final FieldGrid grid;
    private final FieldColumns columns;
    private final FieldSensors all;
    private final LayerStore store;

    private DetectionField(FieldGrid grid, FieldColumns columns, FieldSensors all, LayerStore store) {
        this.grid = grid;
        this.columns = columns;
        this.all = all;
        this.store = store;
    }

    /**
     * A field of which no height has been assessed yet.
     *
     * @param store of assessments that were made before
     * @param progress receives the number of cells represented by what has been traced since the last call
     */
    static DetectionField unassessed(FieldRequest asked, LayerStore store, IntConsumer progress) {
        return unassessed(asked, FieldColumns.of(asked.stage().world(), asked.grid()), store, progress);
    }

    /** A field of a request in the cells of this field, in which nothing has been assessed yet. */
    DetectionField unassessedLikeThis(FieldRequest asked, LayerStore another, IntConsumer progress) {
        if (!asked.grid().equals(grid)) {
            throw new IllegalArgumentException("a field of other cells");
        }
        return unassessed(asked, columns, another, progress);
    }

    private static DetectionField unassessed(
            FieldRequest asked, FieldColumns columns, LayerStore store, IntConsumer progress) {
        FieldSensors all = FieldSensors.unassessed(asked, columns, store, progress);
        return new DetectionField(asked.grid(), columns, all, store);
    }

    /** Assesses one height, given by its number: once, before it is queried. */
    void assess(int height, IntConsumer progress) {
        all.assess(height, columns, store, grid.toString(), "height " + height, progress);
    }

    /** The lowest heights of this field. */
    DetectionField upTo(int heights) {
        return new DetectionField(grid.lowest(heights), columns, all, store);
    }

    /**
     * The drone with this name on the stage of a run.
     *
     * @throws IllegalArgumentException when there is no such drone
     */
    public static Drone droneOf(Stage stage, String id) {
        return stage.dronesAt(0.0).stream()
                .filter(one -> one.id().equals(id))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(Spelling.unknown(
                        "drone", id, "the scene", stage.flights().keySet())));
    }

    /**
     * This field without one of its sensors, and without the courses across the line of sight of that sensor.
     *
     * @throws IllegalArgumentException when there is no such sensor
     */
    public DetectionField without(String sensor) {
        return new DetectionField(grid, columns, all.without(sensor), store);
    }

    /** This field without several of its sensors, and without the courses across their lines of sight. */
    public DetectionField without(Collection<String> sensors) {
        DetectionField rest = this;
        for (String sensor : sensors) {
            rest = rest.without(sensor);
        }
        return rest;
    }

    /**
     * A field of the same sensors with one cell in each column, at its own height. Only whether they cover the cell can
     * be relied on, nothing else in this field.
     *
     * @param above heights above the ground by row and column, m; NaN for no cell
     * @param needed the step that the probability of a sensor has to reach
     * @param name the name under which stored assessments are found again
     */
    DetectionField decidingAt(double[] above, int needed, String name, IntConsumer progress) {
        FieldColumns other = FieldColumns.at(all.probe(0).world(), grid, above);
        FieldSensors there = all.deciding(needed).in(other, store, grid.toString(), name, progress);
        return new DetectionField(grid.lowest(1), other, there, store);
    }

    /** The field at only one height, given by its number. */
    DetectionField atHeight(int height) {
        FieldGrid alone = new FieldGrid(
                grid.east(),
                grid.north(),
                grid.side(),
                grid.cell(),
                List.of(grid.heights().get(height)),
                grid.area());
        return new DetectionField(alone, columns.at(height), all.at(height), LayerStore.NONE);
    }

    /** A field of the same cells with other assessments. */
    DetectionField with(FieldSensors others) {
        return new DetectionField(grid, columns, others, store);
    }

    /** The sensors with their assessments. */
    FieldSensors all() {
        return all;
    }

    /** The cells. */
    FieldColumns columns() {
        return columns;
    }

    /** The number of columns with ground below them. */
    public int columnsWithGround() {
        return columns.groundCount();
    }

    /** The grid. */
    public FieldGrid grid() {
        return grid;
    }

    /** Whether every sensor has the same probability and cause on all courses in a cell. */
    boolean isSameOnAllCourses(int height, int column, int row) {
        return all.areSameOnAllCourses(height, column, row);
    }

    /** The courses. */
    public List<Course> courses() {
        return all.courses();
    }

    /** The names of the sensors, in the order of the scene. */
    public List<String> sensors() {
        return all.names();
    }

    /** The kind of a sensor, given by its number. */
    public String kind(int sensor) {
        return all.probe(sensor).settings().kind();
    }

    /** The position of a sensor, given by its number, m. */
    public Position position(int sensor) {
        return all.probe(sensor).settings().position();
    }

    /**
     * The errors of the signal levels that are interpolated between cells, by name of the sensor. Sensors that are not
     * among the keys are assessed in each cell.
     */
    public Map<String, InterpolationError> interpolated() {
        return all.interpolated();
    }

    /** What is interpolated between cells for a sensor, given by its name; empty if each cell is assessed. */
    public Optional<ExcessMap> excess(String sensor) {
        return all.excess(sensor);
    }

    /** Whether a drone can be in a cell: there is ground below it, and nothing solid around it. */
    public boolean isOpen(int height, int column, int row) {
        return columns.isOpen(height, column, row);
    }

    /** Whether a cell is outside the area of the grid. */
    public boolean isOutside(int height, int column, int row) {
        return columns.isOutside(height, column, row);
    }

    /** Whether a cell is inside something solid. */
    public boolean isInside(int height, int column, int row) {
        return columns.isInside(height, column, row);
    }

    /** The height of the ground below a column, m; NaN where there is none. */
    public double ground(int column, int row) {
        return columns.ground(column, row);
    }

    /**
     * The centre of a cell, m.
     *
     * @throws IllegalArgumentException where there is no ground
     */
    public Position middle(int height, int column, int row) {
        if (!columns.hasGround(column, row)) {
            throw new IllegalArgumentException("no ground in column " + column + " of row " + row);
        }
        return columns.middle(height, column, row);
    }

    /**
     * The probability that a sensor detects the drone on the terms of the field, as a {@link ProbabilityStep step}; 0
     * where the drone cannot be, and where the line of sight leaves the known ground.
     *
     * @param sensor number of the sensor in {@link #sensors()}
     * @param height number of the height in the grid
     * @param column the column, counted from the west
     * @param row the row, counted from the north
     * @param course number of the course in {@link #courses()}
     */
    public int step(int sensor, int height, int column, int row, int course) {
        return all.step(sensor, height, column, row, course);
    }

    /**
     * The probability that a sensor detects the drone on the terms of the field, 0 to 1, in steps of 1/250; values
     * between 0 and 1/250 are given as 1/250. Arguments as for {@link #step}.
     */
    public double probability(int sensor, int height, int column, int row, int course) {
        return ProbabilityStep.stated(step(sensor, height, column, row, course));
    }

    /**
     * Whether a sensor covers a cell on a course: its {@linkplain #probability probability} is at least a given value.
     *
     * @param covered the value, 0.008 to 0.996, or 1; other arguments as for {@link #step}
     * @throws IllegalArgumentException as for {@link FieldCoverage#checkedProbability}
     */
    public boolean covers(int sensor, int height, int column, int row, int course, double covered) {
        int needed = ProbabilityStep.toCover(FieldCoverage.checkedProbability(covered));
        return step(sensor, height, column, row, course) >= needed;
    }

    /**
     * Why one look of a sensor does not detect the drone: {@link Cause#DETECTED} where it does, {@link Cause#UNKNOWN}
     * where the drone cannot be, or where the line of sight leaves the known ground. Arguments as for {@link #step}.
     */
    public Cause cause(int sensor, int height, int column, int row, int course) {
        return all.cause(sensor, height, column, row, course);
    }

    /**
     * The margin by which the signal of a sensor exceeds its threshold, as the field keeps it: in most cells, a bound;
     * {@link Margin.Known#NOTHING} where the drone cannot be, or where the line of sight leaves the known ground.
     * Arguments as for {@link #step}.
     */
    public Margin margin(int sensor, int height, int column, int row, int course) {
        return all.margin(sensor, height, column, row, course);
    }

    /**
     * The assessment with its evidence, computed again: what hides the drone, and by how much its signal is too weak;
     * empty where the drone cannot be. Arguments as for {@link #step}.
     */
    public Optional<Assessment> assess(int sensor, int height, int column, int row, int course) {
        return isOpen(height, column, row)
                ? Optional.of(
                        all.look(sensor, columns, height, column, row, course).assessment())
                : Optional.empty();
    }
}
