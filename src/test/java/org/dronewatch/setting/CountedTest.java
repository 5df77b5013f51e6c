package org.dronewatch.setting;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** A noun agrees with its number. */
class CountedTest {
    @Test
    void onlyOneIsSingular() {
        assertThat(Counted.of(0, "sensor")).isEqualTo("0 sensors");
        assertThat(Counted.of(1, "sensor")).isEqualTo("1 sensor");
        assertThat(Counted.of(1200, "sensor")).isEqualTo("1,200 sensors");
    }

    @Test
    void aPluralMayBeIrregular() {
        assertThat(Counted.of(1, "run has failed", "runs have failed")).isEqualTo("1 run has failed");
        assertThat(Counted.of(2, "run has failed", "runs have failed")).isEqualTo("2 runs have failed");
    }
}
