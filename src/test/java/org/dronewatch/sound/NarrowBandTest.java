package org.dronewatch.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NarrowBandTest {

    /** Heutschi and others 2020: 0.5 % in still air, 0.52 % more per m/s; 205 Hz is the hovering Mavic 2. */
    @ParameterizedTest
    @CsvSource({"205, 0, 1.025", "205, 5, 6.355", "410, 0, 2.05", "615, 5, 19.065", "4100, 0, 20.5"})
    void windWidensALineAndItsHarmonicsInProportion(double frequency, double wind, double width) {
        NarrowBand band = NarrowBand.ofLine(frequency, wind).orElseThrow();
        assertThat(band.width()).isCloseTo(width, within(1e-9));
    }

    /** 10 lg(176.8 / 4) at the nominal frequency; the exact midband is 251.19 Hz. */
    @Test
    void fourHertzAtTwoHundredAndFiftyGainSixteenDecibels() {
        assertThat(new NarrowBand(250.0, 4.0, 2).gain()).isCloseTo(16.45, within(0.01));
    }

    /** IEC 61260-1: edges at the midband times 10^(+-0.15), without gaps from 44.7 Hz to 11.2 kHz. */
    @Test
    void everyFrequencyHasItsOctave() {
        assertThat(NarrowBand.ofLine(44.6, 0.0)).isEmpty();
        assertThat(NarrowBand.ofLine(44.7, 0.0).orElseThrow().octave()).isZero();
        assertThat(NarrowBand.ofLine(354.8, 0.0).orElseThrow().octave()).isEqualTo(2);
        assertThat(NarrowBand.ofLine(354.9, 0.0).orElseThrow().octave()).isEqualTo(3);
        assertThat(NarrowBand.ofLine(11_220.0, 0.0).orElseThrow().octave()).isEqualTo(7);
        assertThat(NarrowBand.ofLine(11_221.0, 0.0)).isEmpty();
        for (double frequency = 45.0; frequency < 11_220.0; frequency *= 1.001) {
            assertThat(NarrowBand.ofLine(frequency, 0.0)).isPresent();
        }
    }

    /** In a storm a line fills its octave, but no more. */
    @Test
    void noLineIsWiderThanItsOctave() {
        NarrowBand band = NarrowBand.ofLine(1000.0, 200.0).orElseThrow();
        assertThat(band.gain()).isZero();
        assertThat(band.width()).isCloseTo(1000.0 * (Math.pow(10, 0.15) - Math.pow(10, -0.15)), within(1e-9));
    }
}
