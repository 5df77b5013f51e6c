package org.dronewatch.campaign.sensitivity;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Elementary effects from the results of a {@link MorrisDesign}. */
public final class MorrisEstimate {
    private final MorrisDesign design;
    private final Map<Integer, double[]> groups;

    /**
     * Prepares the estimate.
     *
     * @param groups the results of each group by its number; incomplete groups may be left out
     */
    public MorrisEstimate(MorrisDesign design, Map<Integer, double[]> groups) {
        this.design = design;
        this.groups = Map.copyOf(groups);
    }

    /** The effects of all factors in their order; empty if there are fewer than two groups. */
    public List<MorrisEffect> effects() {
        List<MorrisEffect> effects = new ArrayList<>();
        for (int factor = 0; factor < design.factors() && groups.size() > 1; factor++) {
            effects.add(effect(factor));
        }
        return effects;
    }

    private MorrisEffect effect(int factor) {
        double magnitudes = 0.0;
        double mean = 0.0;
        double squares = 0.0;
        int count = 0;
        for (int group = 0; group < design.base(); group++) {
            double[] results = groups.get(group);
            if (results != null) {
                double effect = effect(group, results, factor);
                magnitudes += Math.abs(effect);
                // Welford's recurrence keeps the precision where effects hardly differ.
                count++;
                double before = effect - mean;
                mean += before / count;
                squares += before * (effect - mean);
            }
        }
        return new MorrisEffect(magnitudes / count, Math.sqrt(squares / (count - 1)));
    }

    private double effect(int group, double[] results, int factor) {
        int[] sequence = design.sequence(group);
        int change = 0;
        while (sequence[change] != factor) {
            change++;
        }
        return (results[change + 1] - results[change]) / design.step(group, factor);
    }
}
