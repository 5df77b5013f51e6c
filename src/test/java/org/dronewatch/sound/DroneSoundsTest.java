package org.dronewatch.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;

class DroneSoundsTest {

    @Test
    void theTableHoldsTheKindsEachWithItsSource() {
        assertThat(DroneSounds.names())
                .contains("c1-quadrotor", "c2-quadrotor-4kg", "hexacopter", "petrol-fixed-wing", "gliding");
        for (String name : DroneSounds.names()) {
            assertThat(DroneSounds.get(name).source()).isNotBlank();
        }
    }

    /** Whatever the spectrum, its A-weighted sum is what was asked for. */
    @Test
    void theOctavesAddUpToTheLoudness() {
        for (String name : DroneSounds.names()) {
            DroneSound sound = DroneSounds.get(name);
            List<Double> octaves = sound.octaves(sound.level());
            double[] weighted = new double[OctaveBands.COUNT];
            for (int band = 0; band < weighted.length; band++) {
                weighted[band] = octaves.get(band) + OctaveBands.aWeight(band);
            }
            assertThat(Levels.sum(weighted)).as(name).isCloseTo(sound.level(), within(1e-9));
        }
    }

    /** Regulation (EU) 2019/945, part 15: 85 dB up to 900 g, 18.5 dB more for ten times the mass. */
    @Test
    void theLimitsOfTheRegulationAreKept() {
        assertThat(DroneSounds.get("c1-quadrotor").level()).isEqualTo(85.0);
        assertThat(DroneSounds.get("c2-quadrotor-4kg").level())
                .isCloseTo(85.0 + 18.5 * Math.log10(4000.0 / 900.0), within(0.05));
    }

    @Test
    void aMistypedNameIsAnsweredWithTheNearest() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> DroneSounds.get("c1-quadcopter"))
                .withMessageContaining("'c1-quadcopter'")
                .withMessageContaining("c1-quadrotor");
    }
}
