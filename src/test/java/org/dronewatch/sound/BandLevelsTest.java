package org.dronewatch.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;

class BandLevelsTest {
    private static final BandLevels STAIRS = BandLevels.of(10, 20, 30, 40, 50, 60, 70, 80);

    @Test
    void theBandsKeepTheirOrder() {
        assertThat(STAIRS.hz63()).isEqualTo(10);
        assertThat(STAIRS.hz1000()).isEqualTo(50);
        assertThat(STAIRS.hz8000()).isEqualTo(80);
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            assertThat(STAIRS.level(band)).isEqualTo(10 * (band + 1));
        }
        assertThat(BandLevels.of(List.of(10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0)))
                .isEqualTo(STAIRS);
        assertThatExceptionOfType(IndexOutOfBoundsException.class).isThrownBy(() -> STAIRS.level(8));
    }

    /** Eight equal bands are 10 lg 8 over one of them. */
    @Test
    void theBandsAddUpAsEnergies() {
        assertThat(BandLevels.flat(60).total()).isCloseTo(60 + 10 * Math.log10(8), within(1e-9));
        assertThat(STAIRS.total()).isCloseTo(80 + 10 * Math.log10(1.1111111), within(1e-9));
    }

    /** One band far above the others: its A-weight is the whole difference. */
    @Test
    void theEarHearsLessOfLowTones() {
        BandLevels low = BandLevels.of(100, -200, -200, -200, -200, -200, -200, -200);
        assertThat(low.aWeighted()).isCloseTo(100 - 26.2, within(1e-9));
        assertThat(low.plus(-7).aWeighted()).isCloseTo(93 - 26.2, within(1e-9));
    }

    @Test
    void twoSoundsAddBandByBand() {
        BandLevels sum = BandLevels.flat(60).energySumWith(STAIRS);

        assertThat(sum.hz1000()).isCloseTo(60.4139, within(5e-5));
        assertThat(sum.hz2000()).isCloseTo(63.0103, within(5e-5));
        assertThat(sum).isEqualTo(STAIRS.energySumWith(BandLevels.flat(60)));
    }

    @Test
    void whatIsNoSpectrumIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> BandLevels.of(1, 2, 3))
                .withMessageContaining("3 levels");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> BandLevels.of(1, 2, 3, 4, 5, 6, Double.NaN, 8))
                .withMessageContaining("hz4000 NaN dB must be finite");
        assertThatIllegalArgumentException().isThrownBy(() -> BandLevels.flat(Double.NEGATIVE_INFINITY));
    }
}
