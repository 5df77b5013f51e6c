package org.dronewatch.sound.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SurfaceRoughnessTest {

    /** For little scattering the mean of {@code g cos^2 t} over all directions is {@code g / 2}. */
    @Test
    void littleScatteringFollowsTheSquareOfTheCosine() {
        assertThat(SurfaceRoughness.scattered(0.001, 0.5)).isCloseTo(0.0005, within(1e-6));
        assertThat(SurfaceRoughness.scattered(0.001, 0.1)).isCloseTo(2e-5, within(1e-7));
    }

    /**
     * The curve before it is capped, summed over all directions of a diffuse field, is the figure for a diffuse field.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.3, 0.5})
    void theMeanOverAllDirectionsIsThatOfTheMaterial(double material) {
        // Where the curve is below the figure it is not capped: that gives g.
        double cosine = 0.2;
        double g = -Math.log(1 - SurfaceRoughness.scattered(material, cosine)) / (cosine * cosine);
        int steps = 100_000;
        double mean = 0.0;
        for (int i = 0; i < steps; i++) {
            double square = (i + 0.5) / steps;
            mean += (1 - Math.exp(-g * square)) / steps;
        }
        assertThat(mean).isCloseTo(material, within(1e-6));
    }

    @Test
    void smoothSurfacesScatterNothingAndRoughOnesNoMoreThanStated() {
        assertThat(SurfaceRoughness.scattered(0, 1)).isZero();
        assertThat(SurfaceRoughness.scattered(0.4, 1)).isEqualTo(0.4);
        assertThat(SurfaceRoughness.scattered(1, 1)).isCloseTo(1, within(1e-9));
        assertThat(SurfaceRoughness.scattered(0.4, 0)).isZero();
    }
}
