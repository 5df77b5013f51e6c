package org.dronewatch.campaign.sensitivity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;

class MorrisEstimateTest {
    private static final MorrisDesign DESIGN = new MorrisDesign(
            4,
            20,
            (group, factor, isSecond) -> draw(group, factor, 1),
            (group, factor, isSecond) -> draw(group, factor, 2));

    private static double draw(int group, int factor, int purpose) {
        return new SplittableRandom(1000L * group + 10L * factor + purpose).nextDouble();
    }

    private static List<MorrisEffect> effects(ToDoubleFunction<double[]> function) {
        Map<Integer, double[]> groups = new HashMap<>();
        for (int evaluation = 0; evaluation < DESIGN.size(); evaluation++) {
            double[] point = new double[DESIGN.factors()];
            for (int factor = 0; factor < point.length; factor++) {
                point[factor] = DESIGN.quantile(evaluation, factor);
            }
            groups.computeIfAbsent(DESIGN.group(evaluation), unseen -> new double[DESIGN.groupSize()])[
                            evaluation % DESIGN.groupSize()] =
                    function.applyAsDouble(point);
        }
        return new MorrisEstimate(DESIGN, groups).effects();
    }

    @Test
    void theEffectsOfALinearFunctionAreItsCoefficients() {
        double[] coefficients = {3.0, -2.0, 0.5, 0.0};
        List<MorrisEffect> effects = effects(u -> {
            double sum = 7.0;
            for (int i = 0; i < u.length; i++) {
                sum += coefficients[i] * u[i];
            }
            return sum;
        });

        for (int i = 0; i < coefficients.length; i++) {
            assertThat(effects.get(i).magnitude()).isCloseTo(Math.abs(coefficients[i]), within(1e-12));
            assertThat(effects.get(i).deviation()).isCloseTo(0.0, within(1e-12));
        }
    }

    /** The effect of x in x y is y, which lies at 1/8, 3/8, 5/8 or 7/8: deviation sqrt(5)/8 = 0.28 on average. */
    @Test
    void anInteractionShowsInTheDeviation() {
        List<MorrisEffect> effects = effects(u -> u[0] * u[1]);

        assertThat(effects.get(0).magnitude()).isCloseTo(0.5, within(0.2));
        assertThat(effects.get(0).deviation()).isCloseTo(Math.sqrt(5.0) / 8.0, within(0.08));
        assertThat(effects.get(2)).isEqualTo(new MorrisEffect(0.0, 0.0));
    }

    @Test
    void oneFactorChangesAtATime() {
        for (int evaluation = 0; evaluation < DESIGN.size(); evaluation++) {
            int changed = 0;
            for (int factor = 0; factor < DESIGN.factors(); factor++) {
                double quantile = DESIGN.quantile(evaluation, factor);
                assertThat(8.0 * quantile % 2.0).isEqualTo(1.0);
                assertThat(quantile).isBetween(0.0, 1.0);
                if (evaluation % DESIGN.groupSize() > 0 && quantile != DESIGN.quantile(evaluation - 1, factor)) {
                    changed++;
                    assertThat(Math.abs(quantile - DESIGN.quantile(evaluation - 1, factor)))
                            .isEqualTo(0.5);
                }
            }
            assertThat(changed).isEqualTo(evaluation % DESIGN.groupSize() == 0 ? 0 : 1);
        }
    }
}
