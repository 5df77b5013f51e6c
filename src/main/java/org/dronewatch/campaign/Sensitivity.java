package org.dronewatch.campaign;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.SensitivitySettings;
import org.dronewatch.campaign.sensitivity.MorrisDesign;
import org.dronewatch.campaign.sensitivity.MorrisEffect;
import org.dronewatch.campaign.sensitivity.MorrisEstimate;
import org.dronewatch.campaign.sensitivity.SobolEstimate;
import org.dronewatch.campaign.sensitivity.SobolIndex;

/** How much each setting that varies, and chance, contribute to the variation of a result. For use by one thread. */
public final class Sensitivity {
    private final SensitivityCases cases;
    private final Map<Integer, double[]> groups = new TreeMap<>();
    private int added;
    private int failed;

    /**
     * The influence of one factor, by one of the methods.
     *
     * @param path path of the setting; {@link SensitivityCases#CHANCE} for chance
     * @param index Sobol indices of the factor; empty for the other method
     * @param effect elementary effects of the factor by Morris's method; empty for the other method
     */
    public record Influence(String path, Optional<SobolIndex> index, Optional<MorrisEffect> effect) {
        /** Whether this is the influence of chance. */
        public boolean isChance() {
            return path.equals(SensitivityCases.CHANCE);
        }
    }

    /** A sensitivity to which no case has been added yet. */
    public Sensitivity(SensitivityCases cases) {
        this.cases = cases;
    }

    /** Adds results, in the order of the cases, starting with the first. */
    public void add(List<CaseResult> results) {
        int size = cases.design().groupSize();
        for (CaseResult result : results) {
            double[] group = groups.computeIfAbsent(cases.design().group(result.number()), unseen -> new double[size]);
            added++;
            failed += result.isFailed() ? 1 : 0;
            group[result.number() % size] =
                    result.isFailed() ? Double.NaN : cases.settings().output().of(result);
        }
    }

    /** What is explained, and how. */
    public SensitivitySettings settings() {
        return cases.settings();
    }

    /** The variant whose results are explained. */
    public String variant() {
        return cases.variants().get(0);
    }

    /** Whether all cases have been added. */
    public boolean isComplete() {
        return added == cases.size();
    }

    /** The number of cases. */
    public int cases() {
        return cases.size();
    }

    /** The number of cases that failed. The groups to which they belong are left out. */
    public int failed() {
        return failed;
    }

    /** Whether influences can be estimated: there are at least two groups in which no case failed. */
    public boolean isEstimable() {
        return whole().size() > 1;
    }

    private Map<Integer, double[]> whole() {
        Map<Integer, double[]> whole = new TreeMap<>();
        groups.forEach((number, group) -> {
            boolean isWhole = true;
            for (double value : group) {
                isWhole &= Double.isFinite(value);
            }
            if (isWhole) {
                whole.put(number, group);
            }
        });
        return whole;
    }

    /** The influences, in the order of the campaign, with chance last; empty if the result does not vary. */
    public List<Influence> influences() {
        Map<Integer, double[]> whole = whole();
        List<Influence> influences = new ArrayList<>();
        List<String> paths = cases.paths();
        if (cases.design() instanceof MorrisDesign morris) {
            List<MorrisEffect> effects = new MorrisEstimate(morris, whole).effects();
            boolean varies = effects.stream().anyMatch(effect -> effect.magnitude() > 0.0);
            for (int i = 0; varies && i < effects.size(); i++) {
                influences.add(new Influence(paths.get(i), Optional.empty(), Optional.of(effects.get(i))));
            }
        } else {
            List<SobolIndex> indices = new SobolEstimate(List.copyOf(whole.values())).indices(cases.seed(0));
            for (int i = 0; i < indices.size(); i++) {
                influences.add(new Influence(paths.get(i), Optional.of(indices.get(i)), Optional.empty()));
            }
        }
        return influences;
    }
}
