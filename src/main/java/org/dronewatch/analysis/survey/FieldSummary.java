package org.dronewatch.analysis.survey;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.sensor.Cause;

/**
 * The coverage of a site at all heights, and what each sensor contributes to it.
 *
 * @param coverage the coverage, cell by cell
 * @param heights the summary of each height, from the lowest to the highest
 */
public record FieldSummary(FieldCoverage coverage, List<HeightSummary> heights) {
    /** Copies the list: later changes by the caller have no effect. */
    public FieldSummary {
        heights = List.copyOf(heights);
    }

    /**
     * Summarises a field.
     *
     * @param covered the probability with which a sensor must detect the drone to cover a cell, 0.008 to 0.996, or 1
     */
    public static FieldSummary of(DetectionField field, FieldCoverage.Choice choice, double covered) {
        FieldCoverage coverage = new FieldCoverage(field, choice, covered);
        Map<String, FieldCoverage> without = new LinkedHashMap<>();
        for (String sensor : field.sensors()) {
            without.put(sensor, new FieldCoverage(field.without(sensor), choice, covered));
        }
        List<HeightSummary> heights = new ArrayList<>();
        for (int height = 0; height < field.grid().heights().size(); height++) {
            heights.add(HeightSummary.of(coverage, height, without));
        }
        return new FieldSummary(coverage, heights);
    }

    /** Whether no cell is unknown at any height. */
    public boolean isAllKnown() {
        return heights.stream().allMatch(one -> one.unknown() == 0);
    }

    /** The number of known cells over all heights, for each sensor (in the scene's order) and each of its causes. */
    public Map<String, Map<Cause, Integer>> causesBySensor() {
        Map<String, Map<Cause, Integer>> all = new LinkedHashMap<>();
        heights.forEach(height -> height.causesBySensor().forEach((sensor, causes) -> {
            Map<Cause, Integer> its = all.computeIfAbsent(sensor, name -> new EnumMap<>(Cause.class));
            causes.forEach((cause, cells) -> its.merge(cause, cells, Integer::sum));
        }));
        return all;
    }

    /**
     * The sensors that can each be left out, one at a time, without changing which cells are covered at any height;
     * empty if nothing is covered.
     */
    public List<String> idleSensors() {
        if (heights.stream().allMatch(one -> one.covered() == 0)) {
            return List.of();
        }
        return coverage.field().sensors().stream()
                .filter(sensor -> heights.stream().allMatch(one -> one.changed().get(sensor) == 0))
                .toList();
    }
}
