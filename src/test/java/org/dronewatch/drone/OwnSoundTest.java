package org.dronewatch.drone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.DroneSound;
import org.dronewatch.sound.DroneSound.Basis;
import org.dronewatch.sound.DroneSounds;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.junit.jupiter.api.Test;

/** A drone whose spectrum is not in the library's table. */
class OwnSoundTest {
    private static final DroneSettings DRONE =
            DroneSettings.of(ModelSettings.of("none.obj"), new Hover(new Position(0, 0, 0), 0.0));

    @Test
    void aSoundOfOnesOwnGivesSpectrumAndLoudness() {
        DroneSound own = new DroneSound(
                "tricopter", 91.0, List.of(-40.0, -20.0, -3.0, 0.0, -1.0, -4.0, -9.0, -15.0), Basis.MEASURED, "mine");
        DroneSettings drone = DRONE.withSound(own);

        assertThat(drone.sound()).isEqualTo("tricopter");
        assertThat(drone.soundPowerLevel()).isEqualTo(91.0);
        assertThat(drone.soundPower()).isEqualTo(own.octaves(91.0));
        double weighted = Levels.sum(IntStream.range(0, OctaveBands.COUNT)
                .mapToDouble(band -> drone.soundPower().get(band) + OctaveBands.aWeight(band))
                .toArray());
        assertThat(weighted).isCloseTo(91.0, within(1e-9));
    }

    /** All in one octave: its unweighted level is the A-weighted one less the weight of that band. */
    @Test
    void aHumOfOneOctaveHasItsWholeLevelThere() {
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double[] shape = new double[OctaveBands.COUNT];
            Arrays.fill(shape, -200.0);
            shape[band] = -7.0;
            List<Double> power = DRONE.withSpectrum(BandLevels.of(shape)).soundPower();
            assertThat(power.get(band)).isCloseTo(85.0 - OctaveBands.aWeight(band), within(1e-9));
            assertThat(Collections.max(power)).isEqualTo(power.get(band));
        }
    }

    @Test
    void packagedSoundsAreTakenFromTheTableAgain() {
        DroneSettings own = DRONE.withSpectrum(BandLevels.flat(0.0));
        for (String name : DroneSounds.names()) {
            DroneSettings packaged = own.withSound(DroneSounds.get(name));
            assertThat(packaged.spectrum()).isEmpty();
            assertThat(packaged.soundPower())
                    .isEqualTo(
                            DroneSounds.get(name).octaves(DroneSounds.get(name).level()));
        }
    }

    /** Measured levels by angle are levels only with their own directivity; assumed sounds leave it as it is. */
    @Test
    void aMeasuredSoundBringsItsDirectivity() {
        assertThat(DRONE.withSound(DroneSounds.get("m300")).directivity()).isEqualTo(Directivity.M300);
        DroneSettings rotor = DRONE.withDirectivity(Directivity.ROTOR);
        assertThat(rotor.withSound(DroneSounds.get("hexacopter")).directivity()).isEqualTo(Directivity.ROTOR);
        assertThat(DroneSounds.measuredDirectivity("hexacopter")).isEmpty();
    }

    /** A name from the table with other figures would mislead whoever reads the settings. */
    @Test
    void aSoundOfItsOwnNeedsAnotherName() {
        DroneSound packaged = DroneSounds.get("hexacopter");
        double louder = packaged.level() + 3;
        assertThatIllegalArgumentException()
                .isThrownBy(() -> DRONE.withSound(mine(packaged.name(), louder)))
                .withMessageContaining("spectrum and sound 'hexacopter' are mutually exclusive");
        DroneSettings drone = DRONE.withSound(mine("my hexacopter", louder));
        assertThat(drone.spectrum()).contains(BandLevels.flat(0.0));
        assertThat(drone.soundPower()).isEqualTo(mine("any", louder).octaves(louder));
        assertThat(DRONE.withSound(packaged).withSpectrum(BandLevels.flat(0.0)).sound())
                .as("a spectrum takes the place of a sound of the table")
                .isEqualTo(DroneSounds.SMALL_QUADROTOR);
    }

    private static DroneSound mine(String name, double level) {
        return new DroneSound(name, level, Collections.nCopies(8, 0.0), Basis.ASSUMED, "mine");
    }

    @Test
    void aSpectrumHasLimits() {
        assertThatIllegalArgumentException().isThrownBy(() -> DRONE.withSpectrum(null));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> DRONE.withSound(
                        new DroneSound("loud", 300.0, Collections.nCopies(8, 0.0), Basis.ASSUMED, "mine")))
                .withMessageContaining("soundPowerLevel 300");
        assertThatIllegalArgumentException()
                .isThrownBy(() ->
                        DRONE.withSound(new DroneSound(" ", 80.0, Collections.nCopies(8, 0.0), Basis.ASSUMED, "mine")))
                .withMessage("sound ' ' must be a name");
    }

    /** What cannot be written into a scene file and read again is refused in Java as well. */
    @Test
    void theLimitsOfAFileHoldInJava() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> DRONE.withSpectrum(BandLevels.of(0, 0, 0, 0, 0, 201, 0, 0)))
                .withMessageContaining("hz2000 201")
                .withMessageContaining("-200 to 200");
    }

    /** What was measured by band without weighting comes back by band, through the A-weighted sum and shape. */
    @Test
    void measuredSoundPowerIsKept() {
        BandLevels power = BandLevels.of(90, 88, 86, 84, 82, 80, 78, 76);
        DroneSettings drone = DRONE.withSound(DroneSound.of("own", power, Basis.MEASURED, "field test"));

        assertThat(drone.soundPowerLevel()).isCloseTo(power.aWeighted(), within(1e-12));
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            assertThat(drone.soundPower().get(band)).isCloseTo(power.level(band), within(1e-9));
        }
    }
}
