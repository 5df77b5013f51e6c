package org.dronewatch.placement.site;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The middle of an area as the commands that give the same figures name it. */
class PrintableMiddleTest {
    @ParameterizedTest
    @CsvSource({
        "199.99999999999991, 200.0",
        "-0.30000000000000004, -0.3",
        "33.333333333333336, 33.333333333",
        "12345.678, 12345.678",
        "1e-13, 0.0"
    })
    void hasNoDigitsOfRounding(double middle, String printed) {
        assertThat(Double.toString(AirGrid.printable(middle))).isEqualTo(printed);
    }
}
