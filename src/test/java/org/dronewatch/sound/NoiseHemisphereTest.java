package org.dronewatch.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;

/** The sound of a DJI Matrice 300: doi 10.1016/j.ast.2023.108537. */
class NoiseHemisphereTest {
    private final NoiseHemisphere hemisphere = new NoiseHemisphere("m300_hemisphere.csv");

    /** The third-octave levels straight below, from 50 Hz to 10 kHz, copied by hand from the published table. */
    @Test
    void straightBelowTheOctavesAreSumsOfTheirThirds() {
        double[][] thirds = {
            {60.2, 54.1, 68.6},
            {74.5, 63.0, 68.1},
            {74.4, 72.1, 71.1},
            {70.3, 73.6, 73.5},
            {75.9, 72.5, 72.6},
            {74.6, 75.4, 74.4},
            {74.0, 73.6, 69.5},
            {66.3, 62.3, 57.8}
        };
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            assertThat(hemisphere.level(band, 0.0)).isCloseTo(Levels.sum(thirds[band]), within(1e-9));
        }
        assertThat(aWeighted(band -> hemisphere.level(band, 0.0))).isCloseTo(84.8, within(0.1));
    }

    /** Each angle lies between the faintest and the loudest direction at it; these are the table's own, A-weighted. */
    @Test
    void toTheSideItIsFainter() {
        assertThat(aWeighted(band -> hemisphere.level(band, Math.toRadians(45))))
                .isBetween(81.6, 84.1);
        assertThat(aWeighted(band -> hemisphere.level(band, Math.toRadians(60))))
                .isBetween(79.9, 81.9);
        assertThat(aWeighted(band -> hemisphere.level(band, Math.toRadians(90))))
                .isCloseTo(74.8, within(0.1));
        assertThat(hemisphere.level(4, Math.toRadians(52.5)))
                .isCloseTo(
                        0.5 * (hemisphere.level(4, Math.toRadians(45)) + hemisphere.level(4, Math.toRadians(60))),
                        within(1e-9));
    }

    /**
     * The power in the table of sounds is the integral over both hemispheres, by rings of elevation; a point source
     * that is as loud straight below in all directions has 10 lg(4 pi) more than the level there.
     */
    @Test
    void theTableOfSoundsHasItsPower() {
        double[] power = new double[OctaveBands.COUNT];
        int rings = 9000;
        for (int band = 0; band < power.length; band++) {
            double sum = 0.0;
            for (int i = 0; i < rings; i++) {
                double angle = (i + 0.5) * 0.5 * Math.PI / rings;
                sum += Levels.toRatio(hemisphere.level(band, angle)) * Math.sin(angle);
            }
            power[band] = Levels.ofRatio(4.0 * Math.PI * sum * 0.5 * Math.PI / rings);
        }
        DroneSound sound = DroneSounds.get("m300");
        List<Double> octaves = sound.octaves(sound.level());
        for (int band = 0; band < power.length; band++) {
            assertThat(octaves.get(band)).as("band %d", band).isCloseTo(power[band], within(0.1));
            double below =
                    octaves.get(band) + Directivity.M300.index(band, -0.5 * Math.PI) - Levels.sphericalSpreading(1.0);
            assertThat(below).isCloseTo(hemisphere.level(band, 0.0), within(0.1));
        }
        assertThat(sound.basis()).isEqualTo(DroneSound.Basis.MEASURED);
        assertThat(aWeighted(band -> hemisphere.level(band, 0.0)) + Levels.sphericalSpreading(1.0))
                .isCloseTo(95.8, within(0.1));
    }

    private static double aWeighted(IntToDoubleFunction levels) {
        double[] weighted = new double[OctaveBands.COUNT];
        for (int band = 0; band < weighted.length; band++) {
            weighted[band] = levels.applyAsDouble(band) + OctaveBands.aWeight(band);
        }
        return Levels.sum(weighted);
    }
}
