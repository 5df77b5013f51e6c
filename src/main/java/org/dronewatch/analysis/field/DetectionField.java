package org.dronewatch.analysis.field;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.world.World;

/**
 * The detection field of a site for one drone: in cells at several heights and on several courses, the probability that
 * each sensor detects it, in one look or within a time, and the cause where one look is not sufficient. A sensor on a
 * positioner has turned to the drone, or searches. Everything is assessed once, as in a run; afterwards, any course can
 * be queried without tracing another ray.
 *
 * <p>Probabilities are kept in steps of 1/250; 0 and 1 are exact. Immutable and thread-safe.
 */
public final class DetectionField {
    private final FieldGrid grid;
    private final FieldColumns columns;
    private final List<Course> courses;

    /** For each course its number in the layers. */
    private final int[] inLayers;

    private final Map<String, FieldProbe> probes;
    private final List<String> sensors;
    private final List<SensorLayer> layers;
    private final LayerStore store;

    private DetectionField(
            FieldGrid grid,
            FieldColumns columns,
            List<Course> courses,
            int[] inLayers,
            Map<String, FieldProbe> probes,
            List<SensorLayer> layers,
            LayerStore store) {
        this.grid = grid;
        this.store = store;
        this.columns = columns;
        this.courses = List.copyOf(courses);
        this.inLayers = inLayers;
        this.probes = Collections.unmodifiableMap(probes);
        this.sensors = List.copyOf(probes.keySet());
        this.layers = List.copyOf(layers);
    }

    /**
     * Assesses all enabled sensors of a scene in all cells, on the {@link Workers} of the calling thread; the same for
     * any number of them.
     *
     * @param settings of one run
     * @param stage its world and drones
     * @param drone name of the drone that is put into the cells
     * @param courses on which it flies, at least one
     * @param terms on which it counts as detected
     * @param progress receives the number of cells that a sensor has looked at since the last call; from any thread
     * @throws IllegalArgumentException when there is no such drone
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static DetectionField of(
            SceneSettings settings,
            Stage stage,
            String drone,
            FieldGrid grid,
            List<Course> courses,
            FieldTerms terms,
            IntConsumer progress) {
        // Which course counts, and with which probability, does not matter before it is evaluated.
        FieldRequest asked =
                new FieldRequest(settings, stage, drone, grid, courses, FieldCoverage.Choice.WORST, terms, 1.0);
        return of(asked, LayerStore.NONE, progress);
    }

    /**
     * The same, but only what was not assessed before is assessed.
     *
     * @param asked the request; its choice of a course and its probability of being covered have no effect
     * @param store of assessments that were made before
     */
    public static DetectionField of(FieldRequest asked, LayerStore store, IntConsumer progress) {
        DetectionField field = unassessed(asked, store);
        for (int height = 0; height < asked.grid().heights().size(); height++) {
            field.assess(height, progress);
        }
        return field;
    }

    /** The same in {@link FieldTerms#ONE_LOOK one look}. */
    public static DetectionField of(
            SceneSettings settings,
            Stage stage,
            String drone,
            FieldGrid grid,
            List<Course> courses,
            IntConsumer progress) {
        return of(settings, stage, drone, grid, courses, FieldTerms.ONE_LOOK, progress);
    }

    /**
     * As {@link #of}, but if this thread is interrupted, with only those heights for which all cells have been
     * assessed: empty if there are none. Its interrupt status is kept.
     *
     * @param store of assessments that were made before
     */
    public static Optional<DetectionField> untilInterrupted(
            FieldRequest asked, LayerStore store, IntConsumer progress) {
        int whole = 0;
        DetectionField field = null;
        try {
            field = unassessed(asked, store);
            for (; whole < asked.grid().heights().size(); whole++) {
                field.assess(whole, progress);
            }
            return Optional.of(field);
        } catch (CancellationException e) {
            return whole == 0 ? Optional.empty() : Optional.of(field.upTo(whole));
        }
    }

    private static DetectionField unassessed(FieldRequest asked, LayerStore store) {
        SceneSettings settings = asked.settings();
        World world = asked.stage().world();
        Drone sample = droneOf(asked.stage(), asked.drone());
        FieldColumns columns = FieldColumns.of(world, asked.grid());
        Map<String, FieldProbe> probes = new LinkedHashMap<>();
        List<SensorLayer> layers = new ArrayList<>();
        settings.enabledSensors().forEach((id, sensor) -> {
            long seed = settings.run().seed();
            FieldProbe each = new FieldProbe(world, sample, id, sensor, seed, asked.courses(), asked.terms());
            probes.put(id, each.with(store.excess(each, columns, asked.grid().toString())));
            layers.add(SensorLayer.empty(columns));
        });
        int[] all = IntStream.range(0, asked.courses().size()).toArray();
        return new DetectionField(asked.grid(), columns, asked.courses(), all, probes, layers, store);
    }

    private void assess(int height, IntConsumer progress) {
        for (int sensor = 0; sensor < layers.size(); sensor++) {
            store.assess(
                    layers.get(sensor), probe(sensor), columns, grid.toString(), height, "height " + height, progress);
        }
    }

    /** The lowest heights of this field. */
    private DetectionField upTo(int heights) {
        return new DetectionField(grid.lowest(heights), columns, courses, inLayers, probes, layers, store);
    }

    /**
     * A drone of a stage.
     *
     * @throws IllegalArgumentException when there is no such drone
     */
    public static Drone droneOf(Stage stage, String id) {
        return stage.dronesAt(0.0).stream()
                .filter(one -> one.id().equals(id))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no drone '" + id + "'; the scene has "
                        + String.join(", ", stage.flights().keySet())));
    }

    /**
     * The field of the same scene without one of its sensors: also without the courses across its line of sight.
     *
     * @throws IllegalArgumentException when there is no such sensor
     */
    public DetectionField without(String sensor) {
        int index = sensors.indexOf(sensor);
        if (index < 0) {
            throw new IllegalArgumentException(
                    "no sensor '" + sensor + "'; the field has " + String.join(", ", sensors));
        }
        List<Course> kept = new ArrayList<>();
        List<Integer> numbers = new ArrayList<>();
        for (int i = 0; i < courses.size(); i++) {
            if (!courses.get(i).sensor().filter(sensor::equals).isPresent()) {
                kept.add(courses.get(i));
                numbers.add(inLayers[i]);
            }
        }
        Map<String, FieldProbe> others = new LinkedHashMap<>(probes);
        others.remove(sensor);
        List<SensorLayer> rest = new ArrayList<>(layers);
        rest.remove(index);
        return new DetectionField(
                grid,
                columns,
                kept,
                numbers.stream().mapToInt(Integer::intValue).toArray(),
                others,
                rest,
                store);
    }

    /**
     * The field of the same sensors with one cell in each column, at its own height.
     *
     * @param above heights above the ground by row and column, m; NaN for no cell
     * @param name what is kept of it is found again under this name
     */
    DetectionField at(double[] above, String name, IntConsumer progress) {
        List<FieldProbe> all = List.copyOf(probes.values());
        FieldColumns other = FieldColumns.at(all.get(0).world(), grid, above);
        List<SensorLayer> there = new ArrayList<>();
        for (FieldProbe probe : all) {
            SensorLayer layer = SensorLayer.empty(other);
            store.assess(layer, probe, other, grid.toString(), 0, name, progress);
            there.add(layer);
        }
        return new DetectionField(grid.lowest(1), other, courses, inLayers, probes, there, store);
    }

    /** The number of columns with ground below them. */
    public int columnsWithGround() {
        return columns.groundCount();
    }

    /** The grid. */
    public FieldGrid grid() {
        return grid;
    }

    /** The courses. */
    public List<Course> courses() {
        return courses;
    }

    /** The names of the sensors, in the order of the scene. */
    public List<String> sensors() {
        return sensors;
    }

    /** The kind of a sensor, given by its number. */
    public String kind(int sensor) {
        return probe(sensor).settings().kind();
    }

    /** Where a sensor, given by its number, is, m. */
    public Position position(int sensor) {
        return probe(sensor).settings().position();
    }

    /**
     * The errors of the levels that are interpolated between cells, by the names of the sensors: all others are
     * assessed in each cell.
     */
    public Map<String, InterpolationError> interpolated() {
        Map<String, InterpolationError> errors = new LinkedHashMap<>();
        probes.forEach((id, probe) -> probe.excess().ifPresent(map -> errors.put(id, map.error())));
        return errors;
    }

    /** What is interpolated between the cells of a sensor, given by its name. */
    Optional<ExcessMap> excess(String sensor) {
        return Optional.ofNullable(probes.get(sensor)).flatMap(FieldProbe::excess);
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
     * The middle of a cell, m.
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
     * The probability that a sensor detects the drone on the terms of the field, in steps of 1/250; 0 where the drone
     * cannot be, and where the line of sight leaves the known ground.
     *
     * @param sensor its number in {@link #sensors()}
     * @param height its number in the grid
     * @param column from the west
     * @param row from the north
     * @param course its number in {@link #courses()}
     */
    public int steps(int sensor, int height, int column, int row, int course) {
        return layers.get(sensor).steps(height, column, row, inLayers[course]);
    }

    /** The same as a number from 0 to 1. */
    public double probability(int sensor, int height, int column, int row, int course) {
        return (double) steps(sensor, height, column, row, course) / CellCode.STEPS;
    }

    /** Why a sensor does not detect the drone; {@link Cause#UNKNOWN} where it cannot be. Parameters as above. */
    public Cause cause(int sensor, int height, int column, int row, int course) {
        return layers.get(sensor).cause(height, column, row, inLayers[course]);
    }

    /**
     * The assessment with its evidence, made anew: what hides the drone, and by how much its signal is too weak; empty
     * where the drone cannot be. Parameters as above.
     */
    public Optional<Assessment> assess(int sensor, int height, int column, int row, int course) {
        if (!isOpen(height, column, row)) {
            return Optional.empty();
        }
        FieldProbe probe = probe(sensor);
        Position at = columns.middle(height, column, row);
        return Optional.of(probe.look(probe.newAssessor(), probe.drone(at, inLayers[course]), probe.pointings(at))
                .assessment());
    }

    private FieldProbe probe(int sensor) {
        return probes.get(sensors.get(sensor));
    }
}
