package org.dronewatch.analysis.field;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;

/**
 * The coverage under a condition, such as night or rain, and what is lost under it.
 *
 * @param name of the condition; empty for the scene as it is
 * @param heights from the lowest to the highest
 */
public record ConditionCoverage(String name, List<Height> heights) {
    /** Copies the list: later changes by the caller have no effect. */
    public ConditionCoverage {
        heights = List.copyOf(heights);
    }

    /**
     * One height.
     *
     * @param summary in numbers of cells
     * @param lost cells that a sensor covers in the scene as it is, but none under the condition
     * @param knownAsItIs known cells in the scene as it is
     * @param bySensor the number of cells that each sensor covers
     */
    public record Height(HeightSummary summary, int lost, int knownAsItIs, Map<String, Integer> bySensor) {
        /** The sensor that covers the most cells, the first among equals; empty if none covers any. */
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

    /** The scene as it is. */
    public static ConditionCoverage asItIs(FieldSummary summary) {
        return of("", summary, summary.coverage());
    }

    /**
     * Assesses a scene under a condition.
     *
     * @param asItIs the coverage of the scene as it is
     * @param progress receives the number of cells that a sensor has looked at since the last call; from any thread
     * @throws java.util.concurrent.CancellationException when this thread is interrupted
     */
    static ConditionCoverage of(FieldCondition condition, FieldCoverage asItIs, IntConsumer progress) {
        FieldRequest asked = condition.request().get();
        DetectionField field = FieldAssessment.of(
                asked.settings(), asked.stage(), asked.drone(), asked.grid(), asked.courses(), asked.terms(), progress);
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
        FieldGrid grid = coverage.field().grid();
        return (int) IntStream.range(0, grid.cells())
                .filter(cell -> coverage.isKnown(height, cell % grid.columns(), cell / grid.columns()))
                .count();
    }

    private static int lost(FieldCoverage now, FieldCoverage asItIs, int height) {
        FieldGrid grid = now.field().grid();
        int lost = 0;
        for (int cell = 0; cell < grid.cells(); cell++) {
            int column = cell % grid.columns();
            int row = cell / grid.columns();
            lost += asItIs.isCovered(height, column, row) && !now.isCovered(height, column, row) ? 1 : 0;
        }
        return lost;
    }

    private static Map<String, Integer> bySensor(FieldCoverage coverage, int height) {
        FieldGrid grid = coverage.field().grid();
        Map<String, Integer> bySensor = new LinkedHashMap<>();
        for (int sensor = 0; sensor < coverage.field().sensors().size(); sensor++) {
            int count = 0;
            for (int cell = 0; cell < grid.cells(); cell++) {
                count += coverage.covers(sensor, height, cell % grid.columns(), cell / grid.columns()) ? 1 : 0;
            }
            bySensor.put(coverage.field().sensors().get(sensor), count);
        }
        return bySensor;
    }
}
