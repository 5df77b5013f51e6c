package org.dronewatch.report;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.dronewatch.sensor.Observation;
import org.dronewatch.setting.Quantity;

/**
 * The measured values of one sensor for one drone versus range, for the runs in which these values are the same, with
 * the threshold of each run.
 */
final class RangeCurve {
    /** Values are clipped at this multiple of the threshold, where detection is certain, to keep the plot readable. */
    private static final double TOP = 10.0;

    private final String drone;
    private final String unit;
    private final double firstThreshold;
    private final List<Double> ranges = new ArrayList<>();
    private final List<Double> values = new ArrayList<>();
    /** The threshold of each run, none where each look has its own. */
    private final Map<Integer, OptionalDouble> thresholds = new LinkedHashMap<>();

    private boolean cut;

    RangeCurve(int run, Observation first) {
        this.drone = first.drone();
        this.unit = first.unit();
        this.firstThreshold = first.threshold();
        this.thresholds.put(run, OptionalDouble.of(first.threshold()));
    }

    /** Adds a measurement from later in the first run. */
    void add(Observation observation) {
        // Where detection is random, each look has a different threshold: no line can represent them.
        if (observation.threshold() != firstThreshold) {
            thresholds.replaceAll((run, threshold) -> OptionalDouble.empty());
        }
        ranges.add(observation.range());
        cut |= observation.value() > top();
        values.add(Math.min(observation.value(), top()));
    }

    /** Whether the values measured in another run, for the same drone, are the same, whatever the thresholds. */
    boolean isLike(RangeCurve other) {
        return drone.equals(other.drone)
                && unit.equals(other.unit)
                && values.equals(other.values)
                && ranges.equals(other.ranges);
    }

    void addRunsOf(RangeCurve other) {
        thresholds.putAll(other.thresholds);
    }

    String drone() {
        return drone;
    }

    String unit() {
        return unit;
    }

    List<Double> ranges() {
        return Collections.unmodifiableList(ranges);
    }

    List<Double> values() {
        return Collections.unmodifiableList(values);
    }

    /**
     * The threshold of each run in which this was measured, in the order of the runs; none where each look has its own.
     */
    Map<Integer, OptionalDouble> thresholds() {
        return Collections.unmodifiableMap(thresholds);
    }

    /** Whether values were clipped at the {@linkplain #top top}. */
    boolean isCut() {
        return cut;
    }

    /** The value at which the plot is clipped; levels are logarithmic and are not clipped. */
    double top() {
        if (unit.equals(Quantity.LEVEL.unit())) {
            return Double.POSITIVE_INFINITY;
        }
        return unit.isEmpty() ? 1.0 : TOP * firstThreshold;
    }

    /**
     * Whether the drone kept its range, as one that hovers in front of a fixed sensor does: then there is no line to
     * draw.
     */
    boolean isOfOneRange() {
        return ranges.stream().distinct().count() == 1;
    }

    double highest() {
        return values.stream().mapToDouble(Double::doubleValue).max().orElse(0.0);
    }

    double lowest() {
        return values.stream().mapToDouble(Double::doubleValue).min().orElse(0.0);
    }

    double farthest() {
        return ranges.stream().mapToDouble(Double::doubleValue).max().orElse(0.0);
    }
}
