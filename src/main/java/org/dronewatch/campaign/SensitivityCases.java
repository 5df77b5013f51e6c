package org.dronewatch.campaign;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.campaign.outcome.Cases;
import org.dronewatch.campaign.outcome.SensitivitySettings;
import org.dronewatch.campaign.sensitivity.FactorDesign;
import org.dronewatch.campaign.sensitivity.MorrisDesign;
import org.dronewatch.campaign.sensitivity.SaltelliDesign;
import org.dronewatch.sensor.Draws;
import org.dronewatch.setting.InputException;

/**
 * The additional cases used to estimate how much each setting that varies contributes to the variation of a result.
 * Chance is the last factor: the seed has a first and a second value like any setting, so that its influence can be
 * compared with that of the settings.
 */
public final class SensitivityCases implements Cases {
    /** The path that represents chance. */
    public static final String CHANCE = "run.seed";

    private static final String FIRST = "sensitivity first";
    private static final String SECOND = "sensitivity second";
    private static final String ORDER = "sensitivity order";
    private static final int MOST = 1_000_000;

    private final CampaignPlan plan;
    private final SensitivitySettings settings;
    private final FactorDesign design;

    /**
     * The cases that a plan asks for.
     *
     * @throws InputException when the values of its settings are not drawn, or there would be more than a million cases
     */
    SensitivityCases(CampaignPlan plan, SensitivitySettings settings) {
        if (plan.settings().table().isPresent()) {
            throw new InputException("sensitivity: needs settings whose values are drawn, not those of the table "
                    + plan.settings().table().get());
        }
        this.plan = plan;
        this.settings = settings;
        int factors = plan.paths().size() + 1;
        FactorDesign.Uniform01 values = (group, factor, isSecond) -> draw(group, factor, isSecond ? SECOND : FIRST);
        this.design = settings.method() == SensitivitySettings.Method.SOBOL
                ? new SaltelliDesign(factors, settings.base(), values)
                : new MorrisDesign(
                        factors, settings.base(), values, (group, factor, isSecond) -> draw(group, factor, ORDER));
        if ((long) design.base() * design.groupSize() > MOST) {
            throw new InputException("sensitivity.base " + settings.base() + " with " + design.groupSize()
                    + " cases in each group: there must be at most a million cases in all");
        }
    }

    private double draw(int group, int factor, String purpose) {
        return Draws.stream(plan.settings().seed(), paths().get(factor), "", group, purpose)
                .nextDouble();
    }

    /** The factors: the paths of the settings that vary, and {@link #CHANCE}. */
    List<String> paths() {
        List<String> paths = new ArrayList<>(plan.paths());
        paths.add(CHANCE);
        return paths;
    }

    /** What is to be explained, and how. */
    public SensitivitySettings settings() {
        return settings;
    }

    FactorDesign design() {
        return design;
    }

    @Override
    public int size() {
        return design.size();
    }

    @Override
    public List<String> variants() {
        return List.of(settings.variant().orElse(plan.variants().get(0)));
    }

    @Override
    public List<String> values(int number) {
        List<String> values = new ArrayList<>();
        List<String> paths = plan.paths();
        for (int factor = 0; factor < paths.size(); factor++) {
            values.add(plan.value(paths.get(factor), design.quantile(number, factor)));
        }
        return values;
    }

    @Override
    public long seed(int number) {
        boolean isSecond = design.isSecond(number, plan.paths().size());
        // Number 0 would be the campaign's seed itself.
        return Draws.derivedSeed(plan.settings().seed(), isSecond ? SECOND : FIRST, design.group(number) + 1L);
    }
}
