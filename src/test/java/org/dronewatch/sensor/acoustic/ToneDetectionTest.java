package org.dronewatch.sensor.acoustic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RotorTones;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Criterion;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.Wind;
import org.dronewatch.world.SurfaceSettings;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** Tones in the open, in the energy model: at which frequency and how far above the noise a microphone hears them. */
class ToneDetectionTest {
    private static final double BLADE_PASSING = 205.0;
    private static final RotorTones TONES = RotorTones.of(102.5).withShares(List.of(0.5, 0.25));
    private static final Position STILL = new Position(0, 0, 0);
    private static final BackgroundNoise NOISE = BackgroundNoise.of(30.0);
    private static final double SOUND = Atmosphere.STANDARD.speedOfSound();

    private static DroneSettings quadrotor() {
        return DroneSettings.of(ModelSettings.of("none.obj"), new Hover(STILL, 0.0));
    }

    private static Drone drone(DroneSettings settings, double range, Position velocity, OptionalDouble gliding) {
        TriangleMesh any = TriangleMesh.of(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
        return new Drone("drone", settings, KDTree.of(any))
                .at(new FlightState(new Position(0, range, 0), velocity, 0.0, gliding));
    }

    private static Observation observe(Drone drone, Criterion criterion) {
        return observe(drone, criterion, Atmosphere.STANDARD);
    }

    private static Observation observe(Drone drone, Criterion criterion, Atmosphere air) {
        TriangleMesh farGround =
                TriangleMesh.of(new float[] {0, 0, -5000, 1, 0, -5000, 0, 1, -5000}, new int[] {0, 1, 2});
        World open = new World(KDTree.of(farGround), NOISE, SurfaceSettings.DEFAULT, air);
        return AcousticSettings.at(STILL)
                .withPropagation(EnergyModel.DEFAULT.withRays(1000).withCriterion(criterion))
                .create()
                .observe(open, List.of(drone), Look.of(1, "microphone", 0, 10.0))
                .get(0);
    }

    private static Observation hovering(DroneSettings settings, double range, Criterion criterion) {
        return observe(drone(settings, range, STILL, OptionalDouble.empty()), criterion);
    }

    /**
     * Level and noise of the octave at 250 Hz, half the power in 1.025 Hz of its 177 Hz, the other half spread over it.
     */
    @Test
    void theRatioIsThatOfTheLineToTheNoiseInItsOwnWidth() {
        Observation heard = hovering(quadrotor().withTones(TONES), 100.0, Criterion.NARROW_BAND);
        double octave = quadrotor().soundPower().get(2)
                - Levels.sphericalSpreading(100.0)
                - Atmosphere.STANDARD.attenuation(OctaveBands.midband(2)) * 100.0;
        double gain = 10.0 * Math.log10(251.1886 * (Math.pow(10, 0.15) - Math.pow(10, -0.15)) / 1.025);
        double expected = octave
                + 10.0 * Math.log10(0.5 + 0.5 * Math.pow(10, -0.1 * gain))
                - NOISE.spectrum().level(2)
                + gain;

        assertThat(heard.figures().get("tone_1_snr_db")).isCloseTo(expected, within(0.01));
        assertThat(heard.figures().get("tone_1_hz")).isEqualTo(BLADE_PASSING);
        assertThat(heard.figures().get("tone_1_width_hz")).isCloseTo(1.025, within(1e-9));
        assertThat(heard.figures().get("tone_2_hz")).isEqualTo(2.0 * BLADE_PASSING);
        assertThat(heard.value())
                .isEqualTo(Math.max(
                        heard.figures().get("tone_1_snr_db"), heard.figures().get("tone_2_snr_db")));
        assertThat(heard.threshold()).isEqualTo(15.0);
    }

    /**
     * A drone that comes at 15 m/s is heard at 1.0457 of its frequency, one that goes at 0.9581, and one that passes at
     * 1.
     */
    @Test
    void motionShiftsWhatIsHeard() {
        double[][] flights = {{-15, 1.0 / (1.0 - 15.0 / SOUND)}, {15, 1.0 / (1.0 + 15.0 / SOUND)}};
        for (double[] flight : flights) {
            Drone drone =
                    drone(quadrotor().withTones(TONES), 100.0, new Position(0, flight[0], 0), OptionalDouble.empty());
            Map<String, Double> figures = observe(drone, Criterion.A_WEIGHTED).figures();
            assertThat(figures.get("tone_1_hz")).isCloseTo(BLADE_PASSING * flight[1], within(1e-9));
            assertThat(figures.get("tone_1_width_hz")).isCloseTo(0.005 * BLADE_PASSING * flight[1], within(1e-9));
        }
        Drone passing = drone(quadrotor().withTones(TONES), 100.0, new Position(15, 0, 0), OptionalDouble.empty());
        assertThat(observe(passing, Criterion.A_WEIGHTED).figures().get("tone_1_hz"))
                .isEqualTo(BLADE_PASSING);
    }

    /** In 5 m/s of wind at its height the line at 205 Hz is 6 Hz wide, and its harmonic twice as wide. */
    @Test
    void theWindAtTheDroneWidensItsLines() {
        Drone hovering = drone(quadrotor().withTones(TONES), 100.0, STILL, OptionalDouble.empty())
                .move(new Position(0, 0, 10).toVector3d());
        Atmosphere windy = Atmosphere.STANDARD.withWind(Wind.CALM.withSpeed(5.0));
        Map<String, Double> calm = observe(hovering, Criterion.NARROW_BAND).figures();
        Map<String, Double> wide =
                observe(hovering, Criterion.NARROW_BAND, windy).figures();

        assertThat(calm.get("tone_1_width_hz")).isCloseTo(1.025, within(1e-9));
        assertThat(wide.get("tone_1_width_hz")).isCloseTo(6.355, within(1e-9));
        assertThat(wide.get("tone_2_width_hz")).isCloseTo(12.71, within(1e-9));
        assertThat(wide.get("tone_1_snr_db")).isLessThan(calm.get("tone_1_snr_db"));
    }

    /** Lines rise out of noise that hides their octave. */
    @Test
    void linesAreHeardFartherThanBands() {
        DroneSettings drone = quadrotor().withTones(TONES);
        assertThat(hovering(drone, 180.0, Criterion.BEST_BAND).isDetected()).isFalse();
        assertThat(hovering(drone, 180.0, Criterion.NARROW_BAND).isDetected()).isTrue();
        assertThat(hovering(drone, 5000.0, Criterion.NARROW_BAND).isDetected()).isFalse();
    }

    /** Tones are part of the sound power: whoever does not listen for them hears the same with and without. */
    @Test
    void tonesChangeNoOtherCriterion() {
        for (Criterion criterion : List.of(Criterion.A_WEIGHTED, Criterion.BEST_BAND)) {
            Observation with = hovering(quadrotor().withTones(TONES), 100.0, criterion);
            Observation without = hovering(quadrotor(), 100.0, criterion);
            assertThat(with.value()).isEqualTo(without.value());
            assertThat(with.threshold()).isEqualTo(without.threshold());
            assertThat(with.figures()).containsAllEntriesOf(without.figures());
            assertThat(without.figures().keySet()).noneMatch(name -> name.startsWith("tone"));
        }
    }

    @Test
    void withoutTonesTheBestBandDecides() {
        assertThat(hovering(quadrotor(), 100.0, Criterion.NARROW_BAND).value())
                .isEqualTo(hovering(quadrotor(), 100.0, Criterion.BEST_BAND).value());
        Drone gliding = drone(quadrotor().withTones(TONES), 100.0, STILL, OptionalDouble.of(3.0));
        Observation heard = observe(gliding, Criterion.NARROW_BAND);
        assertThat(heard.figures()).doesNotContainKey("tone_1_hz");
        assertThat(heard.value())
                .isEqualTo(observe(gliding, Criterion.BEST_BAND).value());
    }
}
