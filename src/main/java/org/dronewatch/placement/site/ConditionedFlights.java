package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.Warning;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.InputException;

/**
 * The flights of a plan in the scene as it is and, once more, under each of its conditions. For one thread, which may
 * have {@link org.dronewatch.parallel.Workers}.
 */
final class ConditionedFlights {
    /** In the scene as it is, and under each condition. */
    private final List<WarningFlights> scenes = new ArrayList<>();

    /**
     * The flights of a plan.
     *
     * @param stage stage of the plan's scene
     * @param store store of earlier assessments
     * @throws InputException when the scene has no protected zone, or the cells are too many
     */
    ConditionedFlights(PlacePlan plan, Stage stage, LayerStore store) {
        scenes.add(new WarningFlights(plan, plan.present(), stage, store));
        plan.conditions().forEach(condition -> {
            Stage there = plan.runner().stage(condition.settings());
            LayerStore under =
                    store.under(condition.settings(), plan.runner().inputs().models());
            scenes.add(new WarningFlights(plan, condition.settings(), there, under));
        });
    }

    /** The cells whose side is the step of the flights. */
    FieldGrid grid() {
        return asItIs().grid();
    }

    /** The flights in the scene as it is. */
    WarningFlights asItIs() {
        return scenes.get(0);
    }

    /** The number of all flights. */
    int size() {
        return scenes.size() * asItIs().size();
    }

    /** By flight: the number of its condition, 0 for the scene as it is. */
    int[] conditions() {
        int[] conditions = new int[size()];
        Arrays.setAll(conditions, flight -> flight / asItIs().size());
        return conditions;
    }

    /** The approximate number of cells at which a sensor has to be assessed. */
    long looks() {
        return scenes.size() * asItIs().looks();
    }

    /** The warnings of some sensors in the scene as it is and under each condition. */
    List<InboundWarnings> of(Map<String, SensorSettings<?>> sensors, IntConsumer progress) {
        List<InboundWarnings> warnings = new ArrayList<>();
        scenes.forEach(flights -> warnings.add(flights.of(sensors, progress)));
        return warnings;
    }

    /** The longest warning that can be found in any of the scenes, s. */
    static double longest(List<InboundWarnings> warnings) {
        return warnings.stream().mapToDouble(InboundWarnings::longest).max().orElse(0.0);
    }

    /**
     * A column with a row for each flight of which there is a warning.
     *
     * @param warnings the warnings in the scene as it is and under each condition
     * @param longest the longest warning that can be found, s: if it is given, values are the amounts by which warnings
     *     are shorter
     */
    static CandidateColumn column(List<InboundWarnings> warnings, OptionalDouble longest) {
        List<Warning> all =
                warnings.stream().flatMap(scene -> scene.all().stream()).toList();
        int[] rows = new int[all.size()];
        double[] values = new double[all.size()];
        int count = 0;
        for (int row = 0; row < rows.length; row++) {
            OptionalDouble time = all.get(row).time();
            if (time.isPresent()) {
                rows[count] = row;
                values[count++] = longest.isPresent()
                        ? Math.max(0.0, longest.getAsDouble() - time.getAsDouble())
                        : time.getAsDouble();
            }
        }
        return new CandidateColumn(Arrays.copyOf(rows, count), Arrays.copyOf(values, count));
    }
}
