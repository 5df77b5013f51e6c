package org.dronewatch.analysis.survey;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.scenario.SceneSettings;

/**
 * The coverage under a condition, such as night or rain, and what is lost under it.
 *
 * @param name name of the condition; empty for the scene as it is
 * @param heights the coverage at each height, from the lowest to the highest
 */
public record ConditionCoverage(String name, List<Height> heights) {
    /** Copies the list: later changes by the caller have no effect. */
    public ConditionCoverage {
        heights = List.copyOf(heights);
    }

    /**
     * One height.
     *
     * @param summary the coverage at this height, in numbers of cells
     * @param lost number of cells that some sensor covers in the scene as it is, but none covers under the condition
     * @param knownAsItIs number of known cells in the scene as it is
     * @param bySensor the number of cells that each sensor covers
     */
    public record Height(HeightSummary summary, int lost, int knownAsItIs, Map<String, Integer> bySensor) {
        /** The sensor that covers the most cells, the first of them in a tie; empty if none covers any. */
        public Optional<String> best() {
            String best = null;
            int most = 0;
            for (Map.Entry<String, Integer> sensor : bySensor.entrySet()) {
                if (sensor.getValue() > most) {
                    most = sensor.getValue();
                    best = sensor.getKey();
                }
            }
            return Optional.ofNullable(best);
        }

        /** The fraction of the known cells that is covered, 0 to 1; 0 if none is known. */
        public double share() {
            return summary.known() == 0 ? 0.0 : (double) summary.covered() / summary.known();
        }
    }

    /** The coverage of the scene as it is. */
    public static ConditionCoverage asItIs(FieldSummary summary) {
        return of("", summary, summary.coverage());
    }

    /**
     * Assesses a scene under a condition. One that only switches sensors off needs no further look.
     *
     * @param request what was asked of the scene as it is
     * @param asItIs its coverage
     * @param stores of assessments that were made before, for the settings of a scene
     * @param progress receives the number of cells that a sensor has looked at since the last call; from any thread
     * @throws java.util.concurrent.CancellationException when this thread is interrupted
     */
    static ConditionCoverage of(
            FieldCondition condition,
            FieldRequest request,
            FieldCoverage asItIs,
            Function<SceneSettings, LayerStore> stores,
            IntConsumer progress) {
        FieldRequest asked = condition.request().get();
        DetectionField field = request.switchedOffIn(asked)
                .map(asItIs.field()::without)
                .filter(rest -> rest.courses().equals(asked.courses()))
                .orElseGet(() -> FieldAssessment.of(asked, stores.apply(asked.settings()), progress));
        return of(condition.name(), FieldSummary.of(field, asked.choice(), asked.covered()), asItIs);
    }

    private static ConditionCoverage of(String name, FieldSummary summary, FieldCoverage asItIs) {
        List<Height> heights = new ArrayList<>();
        for (int height = 0; height < summary.heights().size(); height++) {
            heights.add(new Height(
                    summary.heights().get(height),
                    lost(summary.coverage(), asItIs, height),
                    known(asItIs, height),
                    bySensor(summary.coverage(), height)));
        }
        return new ConditionCoverage(name, heights);
    }

    private static int known(FieldCoverage coverage, int height) {
        return coverage.field().grid().count((column, row) -> coverage.isKnown(height, column, row));
    }

    private static int lost(FieldCoverage now, FieldCoverage asItIs, int height) {
        return now.field()
                .grid()
                .count((column, row) -> asItIs.isCovered(height, column, row) && !now.isCovered(height, column, row));
    }

    private static Map<String, Integer> bySensor(FieldCoverage coverage, int height) {
        DetectionField field = coverage.field();
        Map<String, Integer> bySensor = new LinkedHashMap<>();
        for (int sensor = 0; sensor < field.sensors().size(); sensor++) {
            int its = sensor;
            int count = field.grid().count((column, row) -> coverage.covers(its, height, column, row));
            bySensor.put(field.sensors().get(sensor), count);
        }
        return bySensor;
    }
}
