package org.dronewatch.sensor.acoustic.tone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.Tone;
import org.junit.jupiter.api.Test;

class LineSpectrumTest {
    private static final double SOUND = 343.2;
    private static final List<Double> POWER = List.of(60.0, 65.0, 80.0, 78.0, 76.0, 74.0, 72.0, 70.0);
    private static final BandLevels NOISE = BandLevels.of(40, 36, 32, 28, 24, 20, 16, 12);

    /** Every band is attenuated by 50 dB. */
    private static double arriving(int band) {
        return Levels.toRatio(POWER.get(band) - 50.0);
    }

    private static List<HeardTone> heard(double approach, double wind, Tone... tones) {
        return new LineSpectrum(List.of(tones), POWER, approach, SOUND, wind).heard(LineSpectrumTest::arriving, NOISE);
    }

    /** Brute force: spectral densities of line, broadband sound and noise, added up in steps of 1 mHz. */
    @Test
    void signalAndNoiseAreTheIntegralsOverTheBand() {
        double low = 251.18864315 * Math.pow(10, -0.15);
        double high = 251.18864315 * Math.pow(10, 0.15);
        double width = 205.0 * (0.005 + 0.0052 * 2.0);
        double step = 1e-3;
        double signal = 0.0;
        double noise = 0.0;
        for (double f = low + 0.5 * step; f < high; f += step) {
            double density = 0.7 * Levels.toRatio(30.0) / (high - low);
            if (Math.abs(f - 205.0) < 0.5 * width) {
                signal += (density + 0.3 * Levels.toRatio(30.0) / width) * step;
                noise += Levels.toRatio(32.0) / (high - low) * step;
            }
        }
        HeardTone tone = heard(0.0, 2.0, new Tone(1, 205.0, 0.3)).get(0);
        assertThat(tone.snr()).isCloseTo(Levels.ofRatio(signal / noise), within(5e-3));
    }

    /**
     * All power in one line: what the narrow band gains over the octave is 10 lg of their widths, 16.45 dB for 4 Hz at
     * 250 Hz.
     */
    @Test
    void aPureToneGainsTheRatioOfTheWidths() {
        double wind = (4.0 / 250.0 - 0.005) / 0.0052;
        HeardTone tone = heard(0.0, wind, new Tone(1, 250.0, 1.0)).get(0);
        assertThat(tone.band().width()).isCloseTo(4.0, within(1e-9));
        assertThat(tone.snr() - (30.0 - 32.0)).isCloseTo(16.45, within(0.01));
    }

    /** Noise in a narrow band is no easier to hear than in its octave. */
    @Test
    void aLineWithoutPowerGainsNothing() {
        assertThat(heard(0.0, 0.0, new Tone(1, 205.0, 0.0)).get(0).snr()).isCloseTo(30.0 - 32.0, within(1e-9));
    }

    /**
     * 350 Hz belongs to the octave of 250 Hz; heard from a drone that comes at 15 m/s it is at 366 Hz, in that of 500
     * Hz.
     */
    @Test
    void motionMovesALineToTheNextOctave() {
        HeardTone tone = heard(15.0, 0.0, new Tone(1, 350.0, 1.0)).get(0);
        assertThat(tone.band().octave()).isEqualTo(3);
        assertThat(tone.band().frequency()).isCloseTo(350.0 * 1.0457, within(0.02));
        double fraction = tone.band().fraction();
        double signal = Levels.toRatio(30.0) + Levels.toRatio(28.0) * fraction;
        assertThat(tone.snr()).isCloseTo(Levels.ofRatio(signal / (Levels.toRatio(28.0) * fraction)), within(1e-9));
    }

    /**
     * Where the drone is silent in the band in which the line is heard, the line is as faint as in the band that it
     * left.
     */
    @Test
    void aSilentOctaveStillCarriesALine() {
        List<Double> power = new ArrayList<>(Collections.nCopies(OctaveBands.COUNT, Double.NEGATIVE_INFINITY));
        power.set(2, 80.0);
        HeardTone tone = new LineSpectrum(List.of(new Tone(1, 350.0, 1.0)), power, 15.0, SOUND, 0.0)
                .heard(band -> band == 2 ? 1000.0 : 0.0, NOISE)
                .get(0);
        assertThat(tone.snr()).isCloseTo(30.0 - 28.0 + tone.band().gain(), within(1e-9));
    }

    @Test
    void theLineFarthestAboveTheNoiseIsTheBest() {
        LineSpectrum lines = new LineSpectrum(
                List.of(new Tone(1, 20.0, 1.0), new Tone(2, 205.0, 0.1), new Tone(3, 410.0, 0.9)), POWER, 0, SOUND, 0);
        // 20 Hz is outside the octave bands.
        assertThat(lines.heard(LineSpectrumTest::arriving, NOISE))
                .extracting(HeardTone::harmonic)
                .containsExactly(2, 3);
        assertThat(lines.best(LineSpectrumTest::arriving, NOISE).orElseThrow().harmonic())
                .isEqualTo(3);
        assertThat(LineSpectrum.NONE.best(LineSpectrumTest::arriving, NOISE)).isEmpty();
    }
}
