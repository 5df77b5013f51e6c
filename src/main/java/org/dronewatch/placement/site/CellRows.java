package org.dronewatch.placement.site;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.placement.plan.AirSettings;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.InputException;

/**
 * The rows of {@link CoveredCells} under one condition: one for each open cell on each course. For use by one thread.
 */
final class CellRows {
    private final SceneSettings scene;
    private final Stage stage;
    private final LayerStore store;
    private final String drone;
    private final AirSettings air;
    private final FieldGrid grid;
    private final List<Course> courses;

    /** The first field that was assessed, for its cells. */
    private DetectionField sample;

    /** By cell: its first row; -1 where it does not count. */
    private int[] first;

    private int count = -1;

    /**
     * Rows that are not numbered yet.
     *
     * @param scene the scene under the condition
     * @param stage stage of that scene
     * @param store store of earlier assessments
     */
    CellRows(PlacePlan plan, SceneSettings scene, Stage stage, LayerStore store, FieldGrid grid, List<Course> courses) {
        this.scene = scene;
        this.stage = stage;
        this.store = store;
        this.drone = plan.drone();
        this.air = plan.settings().air();
        this.grid = grid;
        this.courses = courses;
    }

    /** The rows that a sensor covers, ascending; none if the condition switches it off. */
    int[] covering(String name, SensorSettings<?> sensor, IntConsumer progress) {
        // A condition may change the scene's own sensors; the names of all others are new.
        SensorSettings<?> here =
                scene.sensors().containsKey(name) ? scene.sensors().get(name) : sensor;
        DetectionField field = field(Map.of(name, here), courses, progress);
        int[] covering = new int[count];
        int covered = 0;
        for (int cell = 0; cell < first.length && !scene.disabled().contains(name); cell++) {
            for (int course = 0; course < courses.size() && first[cell] >= 0; course++) {
                if (field.covers(0, height(cell), column(cell), row(cell), course, air.covered())) {
                    covering[covered++] = first[cell] + course;
                }
            }
        }
        return Arrays.copyOf(covering, covered);
    }

    /** The field of only some sensors, on any courses. */
    DetectionField field(Map<String, SensorSettings<?>> sensors, List<Course> flown, IntConsumer progress) {
        FieldRequest request = new FieldRequest(
                Layout.alone(scene, sensors),
                stage,
                drone,
                grid,
                flown,
                FieldCoverage.Choice.WORST,
                air.terms(),
                air.covered());
        if (sample == null) {
            sample = FieldAssessment.of(request, store, progress);
            number(sample);
            return sample;
        }
        return FieldAssessment.of(request, sample, store, progress);
    }

    /** Numbers the cells in which the drone can be, on each course. */
    private void number(DetectionField field) {
        first = new int[grid.cells() * grid.heights().size()];
        count = 0;
        for (int cell = 0; cell < first.length; cell++) {
            first[cell] = field.isOpen(height(cell), column(cell), row(cell)) ? count : -1;
            count += first[cell] < 0 ? 0 : courses.size();
        }
        if (count == 0) {
            String middle = Math.round(grid.east()) + ", " + Math.round(grid.north());
            throw new InputException("air: there is no cell that the drone can enter"
                    + (air.area().isEmpty()
                            ? "; the square is centred on " + middle + " m, the mean position of the candidates: is a"
                                    + " place outside the site?"
                            : ""));
        }
    }

    /** The number of rows; known once a sensor has been assessed. */
    int size() {
        return count;
    }

    /** By row: the number of its cell. */
    int[] cells() {
        int[] cells = new int[count];
        for (int cell = 0; cell < first.length; cell++) {
            for (int course = 0; course < courses.size() && first[cell] >= 0; course++) {
                cells[first[cell] + course] = cell;
            }
        }
        return cells;
    }

    private int column(int cell) {
        return cell % grid.columns();
    }

    private int height(int cell) {
        return cell / grid.cells();
    }

    private int row(int cell) {
        return cell / grid.columns() % grid.columns();
    }
}
