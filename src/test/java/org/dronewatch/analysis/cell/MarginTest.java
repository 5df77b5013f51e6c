package org.dronewatch.analysis.cell;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The limits of what a margin may be. */
class MarginTest {
    @ParameterizedTest
    @CsvSource({
        "VALUE, 3.0, 2.9, 3.1",
        "VALUE, -0.5, -0.6, -0.4",
        "VALUE, 0.0, -0.1, 0.1",
        "AT_LEAST, 3.0, 3.0, Infinity",
        "AT_LEAST, -51.0, -51.0, Infinity",
        "AT_MOST, 3.0, -Infinity, 3.0",
        "AT_MOST, -51.1, -Infinity, -51.1",
        "NO_SIGNAL, 0.0, -Infinity, -Infinity",
        "NOTHING, 0.0, -Infinity, Infinity"
    })
    void liesBetweenItsLeastAndItsGreatestValue(Margin.Known kind, double db, double least, double greatest) {
        Margin margin = new Margin(kind, db);

        assertThat(margin.least()).isEqualTo(least);
        assertThat(margin.greatest()).isEqualTo(greatest);
    }
}
