package org.dronewatch.analysis;

import java.util.LinkedHashMap;
import java.util.Map;
import org.dronewatch.sensor.SensorSettings;

/**
 * What the sensors of a {@link Coverage} find together in each cell, row by row from the north.
 *
 * @param byKind whether any sensor of a kind detects the drone
 * @param reached whether any sensor detects the drone
 * @param unknown whether detection is unknown, as defined by {@link Coverage#isUnknown}
 */
record CellTotals(Map<String, boolean[]> byKind, boolean[] reached, boolean[] unknown) {

    /**
     * Adds up the findings of all sensors.
     *
     * @param findings by sensor
     * @param heights of the ground; NaN where there is none
     * @param isKnownEverywhere whether cells without ground are empty, not unknown
     */
    static CellTotals of(
            Map<String, SensorSettings<?>> sensors,
            Map<String, Prober.Findings> findings,
            double[] heights,
            boolean isKnownEverywhere) {
        Map<String, boolean[]> byKind = new LinkedHashMap<>();
        boolean[] reached = new boolean[heights.length];
        boolean[] unknown = new boolean[heights.length];
        findings.forEach((id, found) -> {
            boolean[] ofKind = byKind.computeIfAbsent(sensors.get(id).kind(), kind -> new boolean[heights.length]);
            for (int cell = 0; cell < heights.length; cell++) {
                Prober.Answer answer = found.answers()[cell];
                ofKind[cell] |= answer == Prober.Answer.DETECTED;
                reached[cell] |= answer == Prober.Answer.DETECTED;
                unknown[cell] |= answer == Prober.Answer.UNKNOWN;
            }
        });
        for (int cell = 0; cell < heights.length; cell++) {
            boolean canBeUnknown = Double.isNaN(heights[cell]) ? !isKnownEverywhere : unknown[cell];
            unknown[cell] = canBeUnknown && !reached[cell];
        }
        return new CellTotals(byKind, reached, unknown);
    }
}
