package org.dronewatch.report.file;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Areas of a few cells do not become 0.00 ha. */
class AreaTextTest {
    @ParameterizedTest
    @CsvSource({
        "0.36, 0.36 m2",
        "23.76, 23.8 m2",
        "322.56, 323 m2",
        "999.9, 1000 m2",
        "1000, 0.10 ha",
        "250000, 25.00 ha"
    })
    void smallAreasAreInSquareMetres(double squareMetres, String text) {
        assertThat(Numbers.area(squareMetres)).isEqualTo(text);
    }
}
