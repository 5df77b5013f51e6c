package org.dronewatch.analysis.field;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldColumns;
import org.dronewatch.analysis.cell.Margin;
import org.dronewatch.analysis.layer.CellLook;
import org.dronewatch.analysis.layer.ExcessMap;
import org.dronewatch.analysis.layer.FieldProbe;
import org.dronewatch.analysis.layer.InterpolationError;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.analysis.layer.SensorLayer;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Cause;
import org.dronewatch.setting.Spelling;

/**
 * The sensors of a field, in the order of the scene, with their assessments in all cells, and the courses that count.
 * Immutable, except that the assessments of heights that are still missing are added.
 */
final class FieldSensors {
    private final List<Course> courses;

    /** For each course its number in the layers. */
    private final int[] inLayers;

    private final Map<String, FieldProbe> probes;
    private final List<String> names;
    /** An array, since they are read for each cell and course. */
    private final SensorLayer[] layers;

    private FieldSensors(
            List<Course> courses, int[] inLayers, Map<String, FieldProbe> probes, List<SensorLayer> layers) {
        this.courses = List.copyOf(courses);
        this.inLayers = inLayers;
        this.probes = Collections.unmodifiableMap(probes);
        this.names = List.copyOf(probes.keySet());
        this.layers = layers.toArray(SensorLayer[]::new);
    }

    /**
     * The enabled sensors of a scene; nothing has been assessed yet but what is interpolated between cells.
     *
     * @param store of what was assessed before
     * @param progress receives the number of cells represented by what has been traced since the last call
     */
    static FieldSensors unassessed(FieldRequest asked, FieldColumns columns, LayerStore store, IntConsumer progress) {
        Drone sample = DetectionField.droneOf(asked.stage(), asked.drone());
        long seed = asked.settings().run().seed();
        Map<String, FieldProbe> probes = new LinkedHashMap<>();
        List<SensorLayer> layers = new ArrayList<>();
        asked.settings().enabledSensors().forEach((id, sensor) -> {
            FieldProbe each =
                    new FieldProbe(asked.stage().world(), sample, id, sensor, seed, asked.courses(), asked.terms());
            probes.put(id, each.with(store.excess(each, columns, asked.grid().toString(), progress)));
            layers.add(SensorLayer.empty(columns));
        });
        int[] all = IntStream.range(0, asked.courses().size()).toArray();
        return new FieldSensors(asked.courses(), all, probes, layers);
    }

    /**
     * These sensors, assessed in other columns that have a single level.
     *
     * @param plan where the columns are
     * @param name the name under which stored assessments are found again
     */
    FieldSensors in(FieldColumns columns, LayerStore store, String plan, String name, IntConsumer progress) {
        List<SensorLayer> there =
                names.stream().map(sensor -> SensorLayer.empty(columns)).toList();
        FieldSensors moved = new FieldSensors(courses, inLayers, probes, there);
        moved.assess(0, columns, store, plan, name, progress);
        return moved;
    }

    /** These sensors if all that matters is whether they reach a step: from now on, only that is assessed. */
    FieldSensors deciding(int needed) {
        Map<String, FieldProbe> others = new LinkedHashMap<>();
        probes.forEach((id, probe) -> others.put(id, probe.deciding(needed)));
        return new FieldSensors(courses, inLayers, others, List.of(layers));
    }

    /** One of the sensors, given by its number, on the same courses. */
    FieldSensors only(int sensor) {
        return new FieldSensors(courses, inLayers, Map.of(names.get(sensor), probe(sensor)), List.of(layers[sensor]));
    }

    /** These sensors at only one height, given by its number: as many courses as in their layers. */
    FieldSensors at(int height) {
        List<SensorLayer> there =
                Arrays.stream(layers).map(layer -> layer.at(height)).toList();
        return new FieldSensors(courses, inLayers, probes, there);
    }

    /**
     * Other layers of sensors with the same names.
     *
     * @param others on other courses, as many as before
     */
    FieldSensors with(List<Course> on, Map<String, FieldProbe> others, List<SensorLayer> layers) {
        return new FieldSensors(on, inLayers, new LinkedHashMap<>(others), layers);
    }

    /** The assessments of a sensor, given by its number. */
    SensorLayer layer(int sensor) {
        return layers[sensor];
    }

    /** Assesses all cells of one height with each sensor in turn. */
    void assess(int height, FieldColumns columns, LayerStore store, String plan, String name, IntConsumer progress) {
        for (int sensor = 0; sensor < layers.length; sensor++) {
            store.assess(layers[sensor], probe(sensor), columns, plan, height, name, progress);
        }
    }

    /**
     * All sensors but one: also without the courses across its line of sight.
     *
     * @throws IllegalArgumentException when there is no such sensor
     */
    FieldSensors without(String sensor) {
        int index = names.indexOf(sensor);
        if (index < 0) {
            throw new IllegalArgumentException(Spelling.unknown("sensor", sensor, "the field", names));
        }
        int[] kept = IntStream.range(0, courses.size())
                .filter(course ->
                        courses.get(course).sensor().filter(sensor::equals).isEmpty())
                .toArray();
        Map<String, FieldProbe> others = new LinkedHashMap<>(probes);
        others.remove(sensor);
        List<SensorLayer> rest = new ArrayList<>(List.of(layers));
        rest.remove(index);
        return new FieldSensors(
                IntStream.of(kept).mapToObj(courses::get).toList(),
                IntStream.of(kept).map(course -> inLayers[course]).toArray(),
                others,
                rest);
    }

    /** The courses. */
    List<Course> courses() {
        return courses;
    }

    /** The names of the sensors. */
    List<String> names() {
        return names;
    }

    /** A sensor, given by its number. */
    FieldProbe probe(int sensor) {
        return probes.get(names.get(sensor));
    }

    /** Looks again at a drone on one of the courses, given by its number. */
    CellLook look(int sensor, FieldColumns columns, int height, int column, int row, int course) {
        FieldProbe probe = probe(sensor);
        Position at = columns.middle(height, column, row);
        return probe.look(probe.newAssessor(), probe.drone(at, inLayers[course]), probe.pointings(at));
    }

    /** As {@link DetectionField#interpolated}. */
    Map<String, InterpolationError> interpolated() {
        Map<String, InterpolationError> errors = new LinkedHashMap<>();
        probes.forEach((id, probe) -> probe.excess().ifPresent(map -> errors.put(id, map.error())));
        return errors;
    }

    /** What is interpolated between the cells of a sensor, given by its name. */
    Optional<ExcessMap> excess(String sensor) {
        return Optional.ofNullable(probes.get(sensor)).flatMap(FieldProbe::excess);
    }

    /** Whether all assessments of a cell are the same on all courses. */
    boolean areSameOnAllCourses(int height, int column, int row) {
        for (SensorLayer layer : layers) {
            if (!layer.isSameOnAllCourses(height, column, row)) {
                return false;
            }
        }
        return true;
    }

    /** As {@link DetectionField#step}. */
    int step(int sensor, int height, int column, int row, int course) {
        return layers[sensor].step(height, column, row, inLayers[course]);
    }

    /** As {@link DetectionField#cause}. */
    Cause cause(int sensor, int height, int column, int row, int course) {
        return layers[sensor].cause(height, column, row, inLayers[course]);
    }

    /** As {@link DetectionField#margin}. */
    Margin margin(int sensor, int height, int column, int row, int course) {
        return layers[sensor].margin(height, column, row, inLayers[course]);
    }
}
