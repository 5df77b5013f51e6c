package org.dronewatch.setting;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AdvisedLimitTest {
    @ParameterizedTest
    @CsvSource({
        "0.033333335, 0.0333",
        "0.13999999999999999, 0.14",
        "0.5559, 0.555",
        "3.9999999999999996, 4",
        "72, 72",
        "33.19, 33.1",
        "-0.12345, -0.124",
        "0, 0",
        "29999999, 2.99e7",
        "0.00001239, 1.23e-5"
    })
    void threeDigitsAreRoundedDown(double limit, String written) {
        assertThat(AdvisedLimit.inWords(limit)).isEqualTo(written);
    }

    @Test
    void noLimitIsExceededByMoreThanItsOwnRounding() {
        long seed = 25;
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 10_000; i++) {
            double limit = Math.pow(10.0, random.nextDouble(-9, 9)) * (random.nextBoolean() ? 1 : -1);
            double advised = Double.parseDouble(AdvisedLimit.inWords(limit));
            assertThat(advised)
                    .as("seed %d, limit %s", seed, limit)
                    .isLessThanOrEqualTo(limit + 1.1e-12 * Math.abs(limit))
                    .isGreaterThan(limit - 0.0101 * Math.abs(limit));
        }
    }
}
