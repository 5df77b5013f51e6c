package org.dronewatch.sound.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Direct and ground-reflected sound over flat ground, at 343.2 m/s. */
class GroundInterferenceTest {
    private static final double SOUND_SPEED = 343.2;
    private static final TurbulentCoherence STILL = new TurbulentCoherence(0.0, 1.1);

    /** Over grass, flow resistivity 200 kPa s/m2: what the octave bands from 63 Hz to 8 kHz gain, dB. */
    private static final double[] GRASS = {5.5, 3.7, -2.6, -11.0, -2.0, 3.9, 3.4, 2.4};

    private static GroundInterference over(double sigma, double source, double receiver, double distance) {
        return over(sigma, source, receiver, distance, STILL);
    }

    private static GroundInterference over(
            double sigma, double source, double receiver, double distance, TurbulentCoherence turbulence) {
        return new GroundInterference(
                new GroundImpedance(sigma),
                SOUND_SPEED,
                Math.hypot(distance, source - receiver),
                Math.hypot(distance, source + receiver),
                source,
                receiver,
                0.0,
                turbulence);
    }

    private static double gain(GroundInterference ground, double frequency) {
        return Levels.ofRatio(ground.atFrequency(frequency, 1.0, spread(ground)));
    }

    private static double bandGain(GroundInterference ground, int band) {
        return Levels.ofRatio(ground.inBand(band, 1.0, spread(ground)));
    }

    private static double spread(GroundInterference ground) {
        return Math.pow(ground.direct() / ground.reflected(), 2);
    }

    /**
     * Source at 2 m, microphone at 1.5 m, 100 m apart. The figures were computed from the same formulas in another
     * language, with 30 digits.
     */
    @ParameterizedTest
    @CsvSource({
        "Infinity, 500, 5.6865",
        "Infinity, 1000, 4.6371",
        "200, 250, -3.2746",
        "200, 500, -12.6096",
        "200, 1000, -2.4785",
        "20000, 500, 5.1766",
        "20000, 1000, 2.9760"
    })
    void pureTonesInterfere(double sigma, double frequency, double gain) {
        assertThat(gain(over(sigma, 2, 1.5, 100), frequency)).isCloseTo(gain, within(1e-4));
    }

    @Test
    void grassTakesTheMiddleBands() {
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            assertThat(bandGain(over(200, 2, 1.5, 100), band))
                    .as("band %d", band)
                    .isCloseTo(GRASS[band], within(0.05));
        }
    }

    /** Against a sum over 20,000 frequencies, from near to far and from low to high. */
    @ParameterizedTest
    @CsvSource({"200, 2, 1.5, 100", "80, 30, 1.5, 500", "200, 100, 1.5, 60", "20000, 10, 4, 20", "Infinity, 50, 2, 30"})
    void aBandIsTheMeanOfItsFrequencies(double sigma, double source, double receiver, double distance) {
        GroundInterference ground = over(sigma, source, receiver, distance, TurbulentCoherence.MODERATE);
        int count = 20_000;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double sum = 0.0;
            for (int i = 0; i < count; i++) {
                double lg = 0.3 * ((i + 0.5) / count - 0.5);
                sum += ground.atFrequency(OctaveBands.midband(band) * Math.pow(10, lg), 1.0, spread(ground));
            }
            assertThat(bandGain(ground, band)).as("band %d", band).isCloseTo(Levels.ofRatio(sum / count), within(0.02));
        }
    }

    /** Two sources in step, in closed form. */
    @ParameterizedTest
    @ValueSource(doubles = {63, 500, 1000, 3000})
    void veryHardGroundIsAMirror(double frequency) {
        GroundInterference rigid = over(Double.POSITIVE_INFINITY, 2, 1.5, 100);
        double ratio = rigid.direct() / rigid.reflected();
        double phase = 2 * Math.PI * frequency / SOUND_SPEED * (rigid.reflected() - rigid.direct());
        double image = Levels.ofRatio(1 + ratio * ratio + 2 * ratio * Math.cos(phase));

        assertThat(gain(rigid, frequency)).isCloseTo(image, within(1e-9));
        assertThat(gain(over(1e12, 2, 1.5, 100), frequency)).isCloseTo(image, within(1e-3));
    }

    /** Many wavelengths from the ground and far from grazing incidence, Q is that of a plane wave. */
    @Test
    void farFromTheGroundTheWaveIsPlane() {
        GroundImpedance grass = new GroundImpedance(200);
        Complex q = SphericalReflection.coefficient(grass, 1000, SOUND_SPEED, 5000, 0.7);
        Complex admittance = grass.admittance(1000);
        Complex plane = new Complex(0.7, 0).minus(admittance).over(admittance.plus(0.7));
        assertThat(q.minus(plane).absolute()).isLessThan(1e-3);
    }

    /** Bands hold many periods of a long path difference: what is left is the sum of two energies. */
    @Test
    void highAboveHardGroundEnergiesAdd() {
        GroundInterference rigid = over(Double.POSITIVE_INFINITY, 120, 100, 30);
        double incoherent = Levels.ofRatio(1 + spread(rigid));
        for (int band = 3; band < OctaveBands.COUNT; band++) {
            assertThat(bandGain(rigid, band)).isCloseTo(incoherent, within(0.1));
        }
        GroundInterference far = over(Double.POSITIVE_INFINITY, 2000, 50, 100);
        assertThat(bandGain(far, 4)).isCloseTo(3.01, within(0.25));
    }

    /**
     * On a hard plate on the ground pressure doubles in every band, from wherever the sound comes; 0.1 mm above it a
     * thousandth of a decibel is missing at 8 kHz.
     */
    @ParameterizedTest
    @CsvSource({"10, 0", "10, 5", "30, 100"})
    void onAHardPlatePressureDoubles(double height, double distance) {
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            GroundInterference plate =
                    over(Double.POSITIVE_INFINITY, height, 1e-4, distance, TurbulentCoherence.MODERATE);
            assertThat(bandGain(plate, band)).isCloseTo(20 * Math.log10(2), within(2e-3));
        }
    }

    /** Uneven by a quarter of a wavelength, ground at steep incidence reflects nothing in step. */
    @Test
    void unevenGroundIsOutOfStep() {
        double wavelength = SOUND_SPEED / 1000;
        GroundInterference even = over(Double.POSITIVE_INFINITY, 10, 10, 0.1);
        double cosine = 20 / even.reflected();
        double s = 0.05;
        GroundInterference uneven = new GroundInterference(
                GroundImpedance.RIGID, SOUND_SPEED, even.direct(), even.reflected(), 10, 10, s, STILL);
        double expected = Math.exp(-2 * Math.pow(2 * Math.PI / wavelength * s * cosine, 2));
        double both = 1 + spread(even);
        assertThat((uneven.atFrequency(1000, 1, spread(even)) - both)
                        / (even.atFrequency(1000, 1, spread(even)) - both))
                .isCloseTo(expected, within(1e-9));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.0, -1.0, Double.NaN})
    void groundWithoutResistanceIsRefused(double sigma) {
        assertThatThrownBy(() -> new GroundImpedance(sigma))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("flow resistivity");
    }
}
