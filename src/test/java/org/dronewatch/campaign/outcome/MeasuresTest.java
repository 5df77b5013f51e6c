package org.dronewatch.campaign.outcome;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;

/** Quantiles of more values than are kept in memory are those of the sorted values. */
class MeasuresTest {
    private static final int MANY = 5 * Measures.MOST_IN_MEMORY + 17;

    private static void assertSameAsSorted(int count, IntToDoubleFunction values) {
        Measures measures = new Measures();
        double[] all = new double[count];
        for (int i = 0; i < count; i++) {
            all[i] = values.applyAsDouble(i);
            measures.add(all[i] == Double.NEGATIVE_INFINITY ? OptionalDouble.empty() : OptionalDouble.of(all[i]));
        }
        Arrays.sort(all);
        for (double share : new double[] {1e-9, 0.05, 0.3, 0.5, 0.95, 1.0 - 1e-5, 1.0}) {
            double expected = all[Math.max(0, (int) Math.ceil(share * count - 1e-9) - 1)];
            OptionalDouble quantile = measures.quantile(share);
            if (Double.isFinite(expected)) {
                assertThat(Double.doubleToLongBits(quantile.orElseThrow()))
                        .as("quantile %s of %d", share, count)
                        .isEqualTo(Double.doubleToLongBits(expected));
            } else {
                assertThat(quantile).as("quantile %s of %d", share, count).isEmpty();
            }
        }
    }

    @Test
    void valuesOfAllMagnitudesAndSigns() {
        long seed = 20_261_126L;
        System.out.println("seed of the values: " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        assertSameAsSorted(MANY, i -> (random.nextDouble() - 0.5) * Math.pow(10.0, random.nextInt(-300, 300)));
        assertSameAsSorted(MANY, i -> random.nextInt(3) == 0 ? Double.NEGATIVE_INFINITY : 1500.0 * random.nextDouble());
        for (int count : new int[] {1, 2, Measures.MOST_IN_MEMORY, Measures.MOST_IN_MEMORY + 1}) {
            assertSameAsSorted(count, i -> random.nextDouble());
        }
    }

    /** The worst case for counting by digits: all have the leading ones in common, or all digits. */
    @Test
    void valuesThatAreAlmostOrExactlyEqual() {
        assertSameAsSorted(MANY, i -> 350.0);
        assertSameAsSorted(MANY, i -> i % 2 == 0 ? 0.0 : -0.0);
        assertSameAsSorted(MANY, i -> Double.longBitsToDouble(Double.doubleToLongBits(350.0) + i % 10_007));
        assertSameAsSorted(MANY, i -> Double.NEGATIVE_INFINITY);
    }

    @Test
    void withoutCasesThereIsNone() {
        assertThat(new Measures().quantile(0.5)).isEmpty();
    }
}
