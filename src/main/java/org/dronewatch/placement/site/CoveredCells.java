package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldHeading;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.plan.AirSettings;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * The airspace that each sensor covers: a row for each cell and each of eight headings, or for each cell and the
 * heading towards the protected zone; under several conditions, these rows are repeated for each condition. Cells that
 * are inside something solid, without ground below them or outside the area do not count. For use by one thread, which
 * may have {@link org.dronewatch.parallel.Workers}.
 */
public final class CoveredCells {
    /** Maximum number of rows. */
    private static final int MOST = 2_000_000;

    private final PlacePlan plan;
    private final Stage stage;
    private final FieldGrid grid;
    private final List<Course> courses;
    private final ZoneWeights zones;

    /** The rows of the scene as it is, and under each condition. */
    private final List<CellRows> scenes = new ArrayList<>();

    /**
     * The cells of a plan.
     *
     * @param stage stage of the plan's scene
     * @param store store of earlier assessments
     * @throws InputException when the area is not one of the scene's zones, there is no zone to fly to, the cells are
     *     too many, a zone with a weight contains no cell, or all cells have a weight of 0
     */
    public CoveredCells(PlacePlan plan, Stage stage, LayerStore store) {
        this.plan = plan;
        this.stage = stage;
        this.grid = AirGrid.of(plan);
        this.courses = courses();
        this.zones = new ZoneWeights(plan, grid);
        checkSize();
        checkWeights();
        scenes.add(new CellRows(plan, plan.present(), stage, store, grid, courses));
        plan.conditions().forEach(condition -> {
            Stage there = plan.runner().stage(condition.settings());
            LayerStore under =
                    store.under(condition.settings(), plan.runner().inputs().models());
            scenes.add(new CellRows(plan, condition.settings(), there, under, grid, courses));
        });
    }

    private void checkSize() {
        int scenes = 1 + plan.conditions().size();
        long rows = (long) scenes * grid.cells() * grid.heights().size() * courses.size();
        if (rows > MOST) {
            throw new InputException("air.cell: " + grid.columns() + " x " + grid.columns() + " cells at "
                    + Counted.of(grid.heights().size(), "height") + " on " + Counted.of(courses.size(), "heading")
                    + (scenes > 1 ? " under " + scenes + " conditions" : "")
                    + " are too many; there must be at most " + MOST + " in all: give a larger cell");
        }
    }

    private void checkWeights() {
        for (int zone = 0; zone < zones.count(); zone++) {
            int its = zone;
            if (grid.count((column, row) -> !grid.isOutside(column, row) && zones.isIn(its, column, row)) == 0) {
                throw new InputException("air.weights " + PlainText.value(zones.name(zone))
                        + ": no cell of the airspace has its centre in this zone");
            }
        }
        if (grid.count((column, row) -> !grid.isOutside(column, row) && zones.of(column, row) > 0.0) == 0) {
            throw weightless("all cells");
        }
    }

    private static InputException weightless(String cells) {
        return new InputException("air.weights: " + cells + " have a weight of 0; at least one must have more");
    }

    private List<Course> courses() {
        if (!isInbound()) {
            return Course.all(Map.of(), DetectionField.droneOf(stage, plan.drone())).stream()
                    .filter(course -> course.kind() == Course.Kind.COMPASS)
                    .toList();
        }
        boolean hasZone = stage.protection().zone().isPresent()
                || !stage.protection().areas().isEmpty();
        if (!hasZone) {
            throw new InputException("air.heading inbound: the scene protects no zone towards which a drone could fly");
        }
        return List.of(Course.inbound(InboundTarget.of(plan.present(), stage.protection(), grid)));
    }

    /** The grid of the cells. */
    public FieldGrid grid() {
        return grid;
    }

    /** The approximate number of cells at which candidates have to be assessed. */
    public long looks() {
        return looks(plan.candidates().size());
    }

    /** The approximate number of cells at which a given number of sensors has to be assessed. */
    public long looks(int sensors) {
        return (long) sensors * scenes.size() * grid.cells() * grid.heights().size();
    }

    /** The number of headings on which each cell counts. */
    public int headings() {
        return courses.size();
    }

    /** The number of rows of the scene as it is; known once a sensor has been assessed. */
    public int size() {
        return scenes.get(0).size();
    }

    /** By row: the number of its condition, 0 for the scene as it is; known once a sensor has been assessed. */
    int[] conditions() {
        int[] conditions = new int[all()];
        int row = 0;
        for (int number = 0; number < scenes.size(); number++) {
            Arrays.fill(conditions, row, row + scenes.get(number).size(), number);
            row += scenes.get(number).size();
        }
        return conditions;
    }

    private int all() {
        return scenes.stream().mapToInt(CellRows::size).sum();
    }

    /**
     * By row: its weight; the sum for each condition is the number of rows of the scene as it is, whatever the
     * weights of its zones.
     *
     * @throws InputException when nothing has a weight
     */
    double[] weights() {
        double[] weights = new double[all()];
        int[] cells = cells();
        int row = 0;
        for (CellRows rows : scenes) {
            double sum = 0.0;
            for (int at = row; at < row + rows.size(); at++) {
                weights[at] = zones.of(column(cells[at]), row(cells[at]));
                sum += weights[at];
            }
            if (sum == 0.0) {
                throw weightless("all cells that the drone can enter");
            }
            for (int end = row + rows.size(); row < end; row++) {
                weights[row] *= size() / sum;
            }
        }
        return weights;
    }

    /** The rows of each zone that has a weight and of all other cells, except those without rows. */
    List<ZoneRows> zones() {
        List<ZoneRows> all = new ArrayList<>();
        int[] cells = cells();
        BitSet others = new BitSet(size());
        others.set(0, size());
        for (int zone = 0; zone < zones.count(); zone++) {
            BitSet rows = new BitSet(size());
            for (int row = 0; row < size(); row++) {
                rows.set(row, zones.isIn(zone, column(cells[row]), row(cells[row])));
            }
            others.andNot(rows);
            all.add(new ZoneRows(zones.name(zone), zones.weight(zone), rows, OptionalDouble.empty()));
        }
        if (!all.isEmpty()) {
            all.add(new ZoneRows("", AirSettings.WEIGHT, others, OptionalDouble.empty()));
        }
        all.removeIf(zone -> zone.rows().isEmpty());
        return all;
    }

    /**
     * What each candidate covers, in the order of the plan; after an interruption, only the columns of the candidates
     * that were assessed, at least one.
     *
     * @param progress receives the number of cells that were assessed since the last call
     * @throws CancellationException when this thread is interrupted before the first candidate is assessed; its
     *     interrupt status is kept
     */
    public List<CandidateColumn> columns(IntConsumer progress) {
        List<CandidateColumn> columns = new ArrayList<>();
        try {
            for (SiteCandidate candidate : plan.candidates()) {
                columns.add(column(candidate.name(), candidate.sensor(), progress));
            }
        } catch (CancellationException e) {
            if (columns.isEmpty()) {
                throw e;
            }
        }
        return columns;
    }

    /** What a sensor covers: rows in ascending order, each with the value 1. */
    public CandidateColumn column(String name, SensorSettings<?> sensor, IntConsumer progress) {
        List<int[]> parts = new ArrayList<>();
        scenes.forEach(rows -> parts.add(rows.covering(name, sensor, progress)));
        int[] covering = new int[parts.stream().mapToInt(part -> part.length).sum()];
        int at = 0;
        int before = 0;
        for (int number = 0; number < parts.size(); number++) {
            for (int row : parts.get(number)) {
                covering[at++] = before + row;
            }
            before += scenes.get(number).size();
        }
        return new CandidateColumn(covering);
    }

    /**
     * What sensors cover together, as {@code coverage} finds it: on the heading on which they together are least likely
     * to detect the drone, or towards the protected zone.
     *
     * @param sensors the sensors by their names
     * @param progress receives the number of cells that were assessed since the last call
     * @throws CancellationException when this thread is interrupted
     */
    public FieldSummary summary(Map<String, SensorSettings<?>> sensors, IntConsumer progress) {
        List<Course> flown = heading().courses(alone(sensors), stage, plan.drone(), grid);
        DetectionField field = scenes.get(0).field(sensors, flown, progress);
        return FieldSummary.of(field, heading().choice(), plan.settings().air().covered());
    }

    /** The heading that counts when sensors are assessed together. */
    public FieldHeading heading() {
        return isInbound() ? FieldHeading.INBOUND : FieldHeading.WORST;
    }

    /** By row: the number of its cell. */
    int[] cells() {
        int[] cells = new int[all()];
        int row = 0;
        for (CellRows rows : scenes) {
            System.arraycopy(rows.cells(), 0, cells, row, rows.size());
            row += rows.size();
        }
        return cells;
    }

    private boolean isInbound() {
        return plan.settings().air().heading() == AirSettings.Heading.INBOUND;
    }

    /**
     * The scene with only these sensors enabled; all others are switched off rather than removed, so that those to
     * which a sensor refers still exist.
     */
    public SceneSettings alone(Map<String, SensorSettings<?>> sensors) {
        return Layout.alone(plan.present(), sensors);
    }

    int column(int cell) {
        return cell % grid.columns();
    }

    int height(int cell) {
        return cell / grid.cells();
    }

    int row(int cell) {
        return cell / grid.columns() % grid.columns();
    }
}
