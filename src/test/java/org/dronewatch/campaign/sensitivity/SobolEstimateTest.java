package org.dronewatch.campaign.sensitivity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.dronewatch.LongForm;
import org.junit.jupiter.api.Test;

/** Against functions whose indices are known in closed form. */
class SobolEstimateTest {
    /** Of Ishigami's function with a = 7 and b = 0.1 (Saltelli et al., Global Sensitivity Analysis, 2008). */
    private static final double[] ISHIGAMI_FIRST = {.313905, .442411, 0.0};

    private static final double[] ISHIGAMI_TOTAL = {.557589, .442411, .243684};

    /** Parameters of Sobol's g function: first index V_i / V with V_i = 1 / (3 (1 + a_i)^2), V = prod(1 + V_i) - 1. */
    private static final double[] G = {0.0, 1.0, 4.5, 9.0, 99.0, 99.0, 99.0, 99.0};

    private static double ishigami(double[] u) {
        double x = Math.PI * (2.0 * u[0] - 1.0);
        double y = Math.PI * (2.0 * u[1] - 1.0);
        double z = Math.PI * (2.0 * u[2] - 1.0);
        return Math.sin(x) + 7.0 * Math.pow(Math.sin(y), 2) + 0.1 * Math.pow(z, 4) * Math.sin(x);
    }

    private static double g(double[] u) {
        double product = 1.0;
        for (int i = 0; i < G.length; i++) {
            product *= (Math.abs(4.0 * u[i] - 2.0) + G[i]) / (1.0 + G[i]);
        }
        return product;
    }

    private static List<SobolIndex> indices(int factors, int base, long seed, ToDoubleFunction<double[]> function) {
        FactorDesign.Uniform01 values = (group, factor, isSecond) ->
                new SplittableRandom(seed * 1_000_003L + group * 1009L + factor * 2L + (isSecond ? 1 : 0)).nextDouble();
        SaltelliDesign design = new SaltelliDesign(factors, base, values);
        List<double[]> groups = new ArrayList<>();
        for (int evaluation = 0; evaluation < design.size(); evaluation++) {
            if (evaluation % design.groupSize() == 0) {
                groups.add(new double[design.groupSize()]);
            }
            double[] point = new double[factors];
            for (int factor = 0; factor < factors; factor++) {
                point[factor] = design.quantile(evaluation, factor);
            }
            groups.get(design.group(evaluation))[evaluation % design.groupSize()] = function.applyAsDouble(point);
        }
        return new SobolEstimate(groups).indices(seed);
    }

    @Test
    void manyGroupsGiveTheIndicesOfIshigamisFunction() {
        List<SobolIndex> indices = indices(3, 30_000, 20260704, SobolEstimateTest::ishigami);

        for (int i = 0; i < 3; i++) {
            assertThat(indices.get(i).first()).isCloseTo(ISHIGAMI_FIRST[i], within(0.025));
            assertThat(indices.get(i).total()).isCloseTo(ISHIGAMI_TOTAL[i], within(0.025));
        }
    }

    @Test
    void manyGroupsGiveTheIndicesOfSobolsFunction() {
        List<SobolIndex> indices = indices(G.length, 10_000, 20260705, SobolEstimateTest::g);

        assertThat(indices.get(0).first()).isCloseTo(.71619, within(0.025));
        assertThat(indices.get(0).total()).isCloseTo(.78714, within(0.025));
        for (int i = 0; i < G.length; i++) {
            assertThat(indices.get(i).first()).isCloseTo(gFirst(i), within(0.035));
            assertThat(indices.get(i).total()).isCloseTo(gTotal(i), within(0.035));
        }
    }

    /** The variance of a factor alone. */
    private static double gAlone(int i) {
        return 1.0 / (3.0 * (1.0 + G[i]) * (1.0 + G[i]));
    }

    private static double gVariance() {
        double product = 1.0;
        for (int i = 0; i < G.length; i++) {
            product *= 1.0 + gAlone(i);
        }
        return product - 1.0;
    }

    private static double gFirst(int i) {
        return gAlone(i) / gVariance();
    }

    private static double gTotal(int i) {
        return gAlone(i) * (1.0 + gVariance()) / (1.0 + gAlone(i)) / gVariance();
    }

    /** If each holds with 0.95, at least 86 of 100 do with probability 0.9999; percentiles are approximate. */
    @Test
    void theBootstrapIntervalsContainTheIndices() {
        int[] heldFirst = new int[3];
        int[] heldTotal = new int[3];
        for (long seed = 1; seed <= 100; seed++) {
            List<SobolIndex> indices = indices(3, 256, seed, SobolEstimateTest::ishigami);
            for (int i = 0; i < 3; i++) {
                SobolIndex one = indices.get(i);
                heldFirst[i] += one.low() <= ISHIGAMI_FIRST[i] && ISHIGAMI_FIRST[i] <= one.high() ? 1 : 0;
                heldTotal[i] += one.totalLow() <= ISHIGAMI_TOTAL[i] && ISHIGAMI_TOTAL[i] <= one.totalHigh() ? 1 : 0;
            }
        }
        for (int i = 0; i < 3; i++) {
            assertThat(heldFirst[i]).as("first %d", i).isGreaterThanOrEqualTo(86);
            assertThat(heldTotal[i]).as("total %d", i).isGreaterThanOrEqualTo(86);
        }
    }

    /** If each holds with 0.95, fewer by four standard deviations are improbable; percentiles are approximate. */
    @Test
    void theBootstrapIntervalsContainTheIndicesOfSobolsFunction() {
        int seeds = LongForm.count(20, 300);
        double least = 0.95 * seeds - 4.0 * Math.sqrt(0.95 * 0.05 * seeds);
        int[] heldFirst = new int[G.length];
        int[] heldTotal = new int[G.length];
        for (long seed = 1; seed <= seeds; seed++) {
            List<SobolIndex> indices = indices(G.length, 512, seed, SobolEstimateTest::g);
            for (int i = 0; i < G.length; i++) {
                SobolIndex one = indices.get(i);
                heldFirst[i] += one.low() <= gFirst(i) && gFirst(i) <= one.high() ? 1 : 0;
                heldTotal[i] += one.totalLow() <= gTotal(i) && gTotal(i) <= one.totalHigh() ? 1 : 0;
            }
        }
        System.out.println(
                "of " + seeds + ": first " + Arrays.toString(heldFirst) + ", total " + Arrays.toString(heldTotal));
        for (int i = 0; i < G.length; i++) {
            assertThat((double) heldFirst[i]).as("first %d", i).isGreaterThanOrEqualTo(least);
            assertThat((double) heldTotal[i]).as("total %d", i).isGreaterThanOrEqualTo(least);
        }
    }

    @Test
    void aFactorWithoutInfluenceHasNone() {
        List<SobolIndex> indices = indices(2, 200, 3, u -> u[0]);

        assertThat(indices.get(1)).isEqualTo(new SobolIndex(0.0, 0.0, 0.0, 0.0, 0.0, 0.0));
        assertThat(indices.get(0).first()).isCloseTo(1.0, within(0.15));
        assertThat(indices.get(0).total()).isCloseTo(1.0, within(0.15));
    }

    /** Neither does one beside factors that interact, nor where the mean is much larger than the variation. */
    @Test
    void aFactorWithoutInfluenceHasNoneBesideOthersThatInteract() {
        List<SobolIndex> indices = indices(3, 200, 4, u -> 1000.0 + (u[0] - 0.5) * (u[1] - 0.5));
        List<SobolIndex> mean = indices(3, 2000, 4, u -> 1000.0 + u[0] + u[1]);

        assertThat(indices.get(2)).isEqualTo(new SobolIndex(0.0, 0.0, 0.0, 0.0, 0.0, 0.0));
        assertThat(mean.get(0).first()).isCloseTo(0.5, within(0.06));
    }

    @Test
    void aConstantHasNoIndices() {
        assertThat(indices(2, 20, 3, u -> 4.0)).isEmpty();
        assertThat(new SobolEstimate(List.of()).indices(1)).isEmpty();
    }
}
