package org.dronewatch.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WindTest {
    private static final Wind WIND = new Wind(5, 0, 0.03);

    /** By hand: 5 m/s times ln(1 + z / 0.03) / ln(1 + 10 / 0.03). */
    @ParameterizedTest
    @CsvSource({"10, 5", "0, 0", "-1, 0", "1.5, 3.383", "30, 5.944"})
    void speedGrowsWithTheLogarithmOfHeight(double height, double speed) {
        assertThat(WIND.speedAt(height)).isCloseTo(speed, within(1e-3));
    }

    @Test
    void shearIsTheDifferenceOfSpeedsOverThatOfHeights() {
        assertThat(WIND.shear(30, 1.5)).isCloseTo((WIND.speedAt(30) - WIND.speedAt(1.5)) / 28.5, within(1e-12));
        assertThat(WIND.shear(1.5, 30)).isEqualTo(WIND.shear(30, 1.5));
        double slope = (WIND.speedAt(2.001) - WIND.speedAt(1.999)) / 0.002;
        assertThat(WIND.shear(2, 2)).isCloseTo(slope, within(1e-6));
        assertThat(WIND.shear(2, 2.0019)).isCloseTo(WIND.shear(2, 2.0021), within(1e-4));
        assertThat(WIND.shear(0, 0)).isFinite();
        assertThat(Wind.CALM.shear(10, 2)).isZero();
    }

    @Test
    void fromTheWestItBlowsEast() {
        Wind west = WIND.withFrom(Math.toRadians(270));
        assertThat(west.eastward()).isCloseTo(1, within(1e-12));
        assertThat(west.northward()).isCloseTo(0, within(1e-12));
    }

    @Test
    void limits() {
        assertThatThrownBy(() -> WIND.withSpeed(61)).hasMessageContaining("speed 61 m/s must be 0 to 60");
        assertThatThrownBy(() -> WIND.withRoughness(0)).hasMessageContaining("roughness");
    }

    /** Strasberg's formula by hand at 5 m/s: 42.96 - 23 lg(f 0.09 / 5) in thirds of octaves, here those of 63 Hz. */
    @Test
    void windNoiseFallsByAlmostSevenDecibelsAnOctave() {
        double[] thirds = new double[3];
        double[] frequencies = {50.119, 63.096, 79.433};
        for (int i = 0; i < 3; i++) {
            thirds[i] = 40 * Math.log10(5) + 15 - 23 * Math.log10(frequencies[i] * 0.09 / 5);
        }
        assertThat(WindNoise.level(0, 5)).isCloseTo(Levels.sum(thirds), within(0.01));
        assertThat(WindNoise.level(1, 5) - WindNoise.level(0, 5)).isCloseTo(-6.9, within(0.1));
        assertThat(WindNoise.level(0, 10) - WindNoise.level(0, 5)).isCloseTo(63 * Math.log10(2), within(0.01));
        assertThat(WindNoise.level(0, 0)).isEqualTo(Double.NEGATIVE_INFINITY);
    }
}
