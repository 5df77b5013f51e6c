package org.dronewatch.setting;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The limits that components of records name are kept, and told in words. */
class LimitsTest {
    private record Sample(
            @In(value = Quantity.LENGTH, above = 0, to = 100) double open,
            @In(value = Quantity.NUMBER, from = 1, to = 20_000) int count,
            @In(Quantity.ANGLE) double any,
            @In(value = Quantity.LEVEL, from = -20) double least,
            @In(value = Quantity.RATIO, below = 0.5) double half,
            String text) {}

    private static void check(double open, int count, double any, double least, double half, String text) {
        Limits.check(Sample.class, open, count, any, least, half, text);
    }

    @Test
    void whatLiesOnAnIncludedLimitFits() {
        assertThatCode(() -> check(100, 1, -7, -20, 0.49, "")).doesNotThrowAnyException();
        assertThatCode(() -> check(1e-300, 20_000, 1e30, 1e9, -1e9, "")).doesNotThrowAnyException();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0     | 1     | 0        | 0     | 0        | open 0 m must be above 0 and at most 100",
                "100.5 | 1     | 0        | 0     | 0        | open 100.5 m must be above 0 and at most 100",
                "1     | 0     | 0        | 0     | 0        | count 0 must be 1 to 20000",
                "1     | 20001 | 0        | 0     | 0        | count 20001 must be 1 to 20000",
                "1     | 1     | Infinity | 0     | 0        | any Infinity deg must be finite",
                "NaN   | 1     | 0        | 0     | 0        | open NaN m must be finite",
                "1     | 1     | 0        | -20.1 | 0        | least -20.1 dB must be -20 or more",
                "1     | 1     | 0        | 0     | 0.5      | half 0.5 must be below 0.5",
                "1e-20 | 1     | 0        | 0     | 1e30     | half 1e30 must be below 0.5",
            })
    void whatDoesNotFitIsNamedWithValueAndLimit(
            double open, int count, double any, double least, double half, String message) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> check(open, count, any, least, half, ""))
                .withMessage(message);
    }

    private record Turn(@In(value = Quantity.ANGLE, from = -Math.PI / 2, to = Math.PI / 2) double latitude) {}

    /** How to write it is said if that would be allowed, and if it seems to be typed. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "43.7314    | latitude 2505.625 deg (43.7314 rad) must be -90 to 90 deg; for degrees, write 43.7314 deg",
                "-89.123456 | latitude -5106.398 deg (-89.123456 rad) must be -90 to 90 deg; for degrees, write -89.123456 deg",
                "91         | latitude 5213.916 deg (91 rad) must be -90 to 90 deg",
                "1.6580627893946132 | latitude 95 deg must be -90 to 90 deg",
            })
    void degreesWithoutAUnitGetARemedy(double value, String message) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Limits.check(Turn.class, value))
                .withMessage(message);
    }

    @Test
    void nothingMayBeMissing() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> check(1, 1, 0, 0, 0, null))
                .withMessage("text is missing");
    }

    @Test
    void everyComponentMustBeGiven() {
        assertThatIllegalStateException().isThrownBy(() -> Limits.check(Sample.class, 1.0, 2));
    }
}
