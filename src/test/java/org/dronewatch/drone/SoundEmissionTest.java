package org.dronewatch.drone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.flight.Attitude;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Tone;
import org.junit.jupiter.api.Test;

/** What a drone radiates as it flies. */
class SoundEmissionTest {
    private static final KDTree NOTHING =
            KDTree.of(new TriangleMesh(new float[0], new int[0], new int[0], new int[0], List.of()));
    private static final DroneSettings DRONE = DroneSettings.of(
                    ModelSettings.of("none.obj"), Hover.at(new Position(0, 0, 0)))
            .withTones(RotorTones.of(100.0));

    private static Drone flying(DroneSettings settings, double speed, OptionalDouble gliding) {
        return new Drone("drone", settings, NOTHING)
                .at(new FlightState(
                        new Position(0, 0, 9), new Position(0, speed, 0), new Attitude(0.3, 0.1, -0.2), gliding));
    }

    private static BandLevels power(Drone drone) {
        return BandLevels.of(drone.soundPower());
    }

    @Test
    void aSteadyOneIsTheSameAtAnySpeedAndQuieterWithTheMotorsOff() {
        assertThat(DRONE.emission()).isEqualTo(SteadyEmission.DEFAULT);
        Drone slow = flying(DRONE, 0.0, OptionalDouble.empty());
        Drone fast = flying(DRONE, 40.0, OptionalDouble.empty());
        assertThat(fast.soundPower()).isEqualTo(slow.soundPower()).isEqualTo(DRONE.soundPower());
        assertThat(fast.soundLevel()).isEqualTo(slow.soundLevel()).isEqualTo(55.0);
        assertThat(power(fast).aWeighted()).isCloseTo(85.0, within(1e-9));
        assertThat(fast.tones()).extracting(Tone::frequency).startsWith(200.0, 400.0);

        Drone silent = flying(DRONE, 40.0, OptionalDouble.of(0.0));
        assertThat(power(silent).aWeighted()).isCloseTo(55.0, within(1e-9));
        assertThat(silent.soundLevel()).isEqualTo(25.0);
        assertThat(silent.tones()).isEmpty();
    }

    /** Louder with the fifth power of the speed, only there where it flies fast. */
    @Test
    void oneOfOnesOwnIsAskedAboutTheDroneAsItFlies() {
        DroneSettings own = DRONE.withEmission(drone -> SteadyEmission.DEFAULT
                .soundPower(drone)
                .plus(50.0
                        * Math.log10(
                                drone.velocity().length() / drone.settings().speed())));
        for (double speed : new double[] {2.5, 5.0, 50.0}) {
            for (OptionalDouble gliding : List.of(OptionalDouble.empty(), OptionalDouble.of(3.0))) {
                Drone drone = flying(own, speed, gliding);
                Drone steady = flying(DRONE, speed, gliding);
                assertThat(power(drone).total() - power(steady).total())
                        .isCloseTo(50.0 * Math.log10(speed / 5.0), within(1e-9));
                // What it does not override is that of a steady one.
                assertThat(drone.soundLevel()).isEqualTo(steady.soundLevel());
                assertThat(drone.tones()).isEqualTo(steady.tones());
            }
        }
    }

    @Test
    void silenceIsAVeryLowLevelAndNoEmissionIsNone() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> DRONE.withEmission(null))
                .withMessageContaining("emission");
        double[] levels = new double[8];
        Arrays.fill(levels, Double.NEGATIVE_INFINITY);
        Drone broken = flying(DRONE.withEmission(drone -> BandLevels.of(levels)), 1.0, OptionalDouble.empty());
        assertThatIllegalArgumentException().isThrownBy(broken::soundPower).withMessageContaining("hz63");
    }
}
