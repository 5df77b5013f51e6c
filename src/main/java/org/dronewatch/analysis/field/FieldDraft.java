package org.dronewatch.analysis.field;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldColumns;
import org.dronewatch.analysis.layer.ExcessSurvey;
import org.dronewatch.analysis.layer.FieldProbe;
import org.dronewatch.analysis.layer.LayerRow;
import org.dronewatch.analysis.layer.SensorLayer;
import org.dronewatch.parallel.Workers;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;

/**
 * The field of a scene at one height while some of its sensors are moved or turned: only these are assessed again, in
 * ever smaller blocks of cells; what the others detect is taken from the previous field. In the end, all cells are as
 * {@link FieldAssessment} would give them, with three exceptions: an inbound drone flies to the target of the previous
 * field; where the signal of a moved sensor could be interpolated, only the part that arrives along deterministic
 * paths, which are found without random rays, counts ({@link #reduced}); and where signals of the other sensors could
 * be interpolated, they keep their previous values on the courses across the line of sight of a moved sensor.
 *
 * <p>For use by one thread, which may have {@link Workers}; the result does not depend on their number.
 */
public final class FieldDraft {
    /** The blocks along a side of the first picture, at most. */
    private static final int BLOCKS = 8;

    private final DetectionField base;
    private final Map<String, FieldProbe> probes = new LinkedHashMap<>();
    private final Map<String, DraftLayer> drafts = new LinkedHashMap<>();
    private final List<String> reduced = new ArrayList<>();
    private final List<Course> courses;

    /** The courses across the line of sight of a sensor that was moved. */
    private final int[] changed;

    private final List<SensorLayer> others = new ArrayList<>();
    private boolean isComplete;

    /**
     * A draft in which nothing has been assessed yet.
     *
     * @param before the request for the previous field
     * @param field the previous field, which includes the height
     * @param height number of the height
     * @param moved the same scene with sensors of the same names, some of which are moved or turned
     */
    public FieldDraft(FieldRequest before, DetectionField field, int height, SceneSettings moved) {
        this.base = field.atHeight(height);
        Set<String> ids = movedSensors(field, moved);
        Map<String, SensorSettings<?>> sensors = moved.enabledSensors();
        this.courses = field.courses().stream()
                .map(course -> course.sensor().filter(ids::contains).isPresent()
                        ? course.about(sensors.get(course.sensor().get()).position())
                        : course)
                .toList();
        this.changed = IntStream.range(0, courses.size())
                .filter(course -> !courses.get(course).equals(field.courses().get(course)))
                .toArray();
        for (int sensor = 0; sensor < field.sensors().size(); sensor++) {
            String id = field.sensors().get(sensor);
            others.add(base.all().layer(sensor));
            if (!ids.contains(id)) {
                probes.put(id, base.all().probe(sensor).on(courses));
                continue;
            }
            FieldProbe probe = probe(before, base.all().probe(sensor), sensors.get(id));
            probes.put(id, probe);
            drafts.put(id, new DraftLayer(probe, base.columns(), before.covered()));
            if (probe.isExactAlone()) {
                reduced.add(id);
            }
        }
    }

    private FieldProbe probe(FieldRequest before, FieldProbe old, SensorSettings<?> settings) {
        FieldProbe whole =
                new FieldProbe(old.world(), old.drone(), old.sensor(), settings, old.seed(), courses, before.terms());
        return ExcessSurvey.isPossible(whole) ? whole.onExactPaths() : whole;
    }

    /**
     * The sensors of a field whose position, aim or other settings differ in a changed version of the same scene.
     *
     * @throws IllegalArgumentException when a sensor of the field is not enabled in these settings
     */
    public static Set<String> movedSensors(DetectionField field, SceneSettings moved) {
        Map<String, SensorSettings<?>> sensors = moved.enabledSensors();
        Set<String> ids = new LinkedHashSet<>();
        for (int sensor = 0; sensor < field.sensors().size(); sensor++) {
            String id = field.sensors().get(sensor);
            if (!sensors.containsKey(id)) {
                throw new IllegalArgumentException("no enabled sensor '" + id + "'");
            }
            if (!sensors.get(id).equals(field.all().probe(sensor).settings())) {
                ids.add(id);
            }
        }
        return ids;
    }

    /** Assesses a few cells, so that there is something to show. */
    public void begin() {
        int side = 1;
        while (base.grid().columns() > BLOCKS * side) {
            side *= 2;
        }
        for (DraftLayer draft : drafts.values()) {
            draft.begin(side);
        }
    }

    /** The number of cells along a side of the blocks; 1 once {@link #isFine}. */
    public int step() {
        return drafts.values().stream().mapToInt(DraftLayer::step).max().orElse(1);
    }

    /** The number of cells that have been assessed, added up over the sensors that were moved. */
    public int assessed() {
        return drafts.values().stream().mapToInt(DraftLayer::assessed).sum();
    }

    /** The approximate number of cells that the next {@link #refine} would assess, added up over the moved sensors. */
    public int next() {
        return drafts.values().stream().mapToInt(DraftLayer::next).sum();
    }

    /** Whether all cells along the border of what is covered have been assessed. */
    public boolean isFine() {
        return step() == 1;
    }

    /**
     * Halves the blocks, and assesses those that border on one with a different result; does nothing once
     * {@link #isFine}.
     *
     * @param outdated whether the draft is no longer needed: then it remains unfinished
     */
    public void refine(BooleanSupplier outdated) {
        drafts.values().forEach(draft -> draft.refine(outdated));
    }

    /**
     * Assesses all remaining cells, and also assesses the other sensors on those courses that have changed.
     *
     * @param outdated whether the draft is no longer needed: then it remains incomplete
     */
    public void complete(BooleanSupplier outdated) {
        drafts.values().forEach(draft -> draft.complete(outdated));
        for (int sensor = 0; sensor < others.size() && !outdated.getAsBoolean(); sensor++) {
            FieldProbe probe = probes.get(base.sensors().get(sensor));
            boolean isKept = drafts.containsKey(probe.sensor()) || ExcessSurvey.isPossible(probe);
            if (changed.length > 0 && !isKept) {
                others.set(sensor, onChangedCourses(probe, others.get(sensor), outdated));
            }
        }
        isComplete = !outdated.getAsBoolean() && drafts.values().stream().allMatch(DraftLayer::isComplete);
    }

    private SensorLayer onChangedCourses(FieldProbe probe, SensorLayer former, BooleanSupplier outdated) {
        FieldColumns columns = base.columns();
        int[][] codes = new int[columns.columns() * columns.rows()][];
        Workers.forEach(columns.rows(), () -> new LayerRow(1, probe, probe.newAssessor()), (looks, row) -> {
            for (int column = 0; column < columns.columns(); column++) {
                if (columns.isOpen(0, column, row)) {
                    int[] known = former.codes(column, row, courses.size());
                    codes[row * columns.columns() + column] = outdated.getAsBoolean()
                            ? known
                            : looks.codesAt(columns.middle(0, column, row), known, changed);
                }
            }
        });
        return SensorLayer.of(probe, columns, codes);
    }

    /** Whether all cells have been assessed. */
    public boolean isComplete() {
        return isComplete;
    }

    /** The names of those moved sensors for which only signals along deterministic paths count. */
    public List<String> reduced() {
        return List.copyOf(reduced);
    }

    /** What is known of the field so far, at this height only. */
    public DetectionField field() {
        List<SensorLayer> layers = new ArrayList<>();
        for (int sensor = 0; sensor < others.size(); sensor++) {
            DraftLayer draft = drafts.get(base.sensors().get(sensor));
            layers.add(draft == null ? others.get(sensor) : draft.layer());
        }
        return base.with(base.all().with(courses, probes, layers));
    }

    /**
     * The request for the field of which this is a draft.
     *
     * @param before the request for the previous field
     * @param moved the scene with the sensors that were moved or turned
     */
    public FieldRequest request(FieldRequest before, SceneSettings moved) {
        return new FieldRequest(
                moved,
                before.stage(),
                before.drone(),
                base.grid(),
                courses,
                before.choice(),
                before.terms(),
                before.covered());
    }
}
