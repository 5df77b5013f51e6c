package org.dronewatch.placement.site;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Whether a part of the airspace was a gap and is none any more. */
class SectorGainTest {
    @ParameterizedTest
    @CsvSource({"0.0, 1.0, true", "0.79, 0.95, true", "0.945, 0.982, false", "0.5, 0.94, false"})
    void closesWhatWasAGap(double before, double after, boolean isClosed) {
        assertThat(new SectorGain(0.0, 15.0, 15.0, before, after).isClosed()).isEqualTo(isClosed);
    }
}
