package org.dronewatch.drone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.setting.Quantity;
import org.dronewatch.sound.Tone;
import org.junit.jupiter.api.Test;

class RotorTonesTest {

    /** Hovering, the Mavic 2 turns at 6150 r/min: 205 Hz (Heutschi and others, Acta Acustica 4, 24, 2020, table 4). */
    @Test
    void bladesPassTwiceInEachRevolution() {
        double speed = Quantity.FREQUENCY.parse("6150 rpm");
        RotorTones tones = RotorTones.of(speed);
        assertThat(tones.bladePassingFrequency()).isCloseTo(205.0, within(1e-9));
        assertThat(tones.lines()).extracting(Tone::harmonic).containsExactly(1, 2, 3, 4, 5, 6);
        assertThat(tones.lines().get(2).frequency()).isCloseTo(615.0, within(1e-9));
        assertThat(tones.withBlades(3).bladePassingFrequency()).isCloseTo(307.5, within(1e-9));
    }

    /** Six lines of any fundamental fit: none of the assumed shares needs more than an octave has. */
    @Test
    void theAssumedSharesFitEveryRotor() {
        for (double speed = 1.0; speed <= 1000.0; speed *= 1.003) {
            assertThat(RotorTones.of(speed).lines()).hasSize(6);
        }
    }

    @Test
    void anOctaveHasNoMoreThanAllItsPower() {
        // 410 and 615 Hz are in one octave, 205 Hz in another.
        assertThat(new RotorTones(102.5, 2, List.of(1.0, 0.5, 0.5)).lines()).hasSize(3);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new RotorTones(102.5, 2, List.of(1.0, 0.6, 0.5)))
                .withMessage("shares of the tones in the octave band at 500 Hz add up to 1.1"
                        + " but must add up to at most 1");
        assertThatIllegalArgumentException().isThrownBy(() -> new RotorTones(102.5, 2, List.of()));
        assertThatIllegalArgumentException().isThrownBy(() -> new RotorTones(102.5, 2, List.of(1.5)));
        assertThatIllegalArgumentException().isThrownBy(() -> RotorTones.of(0.0));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> RotorTones.of(100.0).withBlades(0));
    }
}
