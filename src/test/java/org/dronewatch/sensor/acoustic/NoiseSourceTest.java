package org.dronewatch.sensor.acoustic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.sensor.acoustic.propagation.Diffraction;
import org.dronewatch.sensor.acoustic.propagation.Propagation;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.NoiseSource;
import org.dronewatch.world.SurfaceSettings;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What noise sources add to the noise of a microphone, against closed forms. */
class NoiseSourceTest {
    private static final EnergyModel FEW = EnergyModel.DEFAULT.withRays(1000);
    private static final Position MICROPHONE = new Position(0, 0, 0);
    private static final double THRESHOLD = 15.0;

    /** All of it in the band of 63 Hz, where 1 km of air takes 0.09 dB. */
    private static final BandLevels RUMBLE = BandLevels.of(0, -200, -200, -200, -200, -200, -200, -200);

    private static World open(double background) {
        return site(background, new float[] {0, 0, -5000, 1, 0, -5000, 0, 1, -5000});
    }

    /** An opaque wall of 200 m x 200 m at 10 m to the east. */
    private static World walled(double background) {
        return site(
                background,
                new float[] {10, -100, -100, 10, 100, -100, 10, 100, 100, 10, -100, -100, 10, 100, 100, 10, -100, 100});
    }

    private static World site(double background, float[] corners) {
        int[] numbers = new int[corners.length / 3];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = i;
        }
        return new World(
                KDTree.of(TriangleMesh.of(corners, numbers)),
                BackgroundNoise.of(background),
                SurfaceSettings.DEFAULT,
                Atmosphere.STANDARD);
    }

    private static Drone drone(double range) {
        Position place = new Position(0, range, 0);
        TriangleMesh any = TriangleMesh.of(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
        DroneSettings settings = DroneSettings.of(ModelSettings.of("none.obj"), new Hover(place, 0.0))
                .withSoundLevel(50);
        return new Drone("drone", settings, KDTree.of(any)).move(place.toVector3d());
    }

    private static Observation observe(World world, Propagation model, double range, long seed) {
        return AcousticSettings.at(MICROPHONE)
                .withPropagation(model)
                .create()
                .observe(world, List.of(drone(range)), Look.of(seed, "microphone", 0, 10.0))
                .get(0);
    }

    private static double noise(World world, Propagation model) {
        return observe(world, model, 20.0, 1).threshold() - THRESHOLD;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 10, 80, 700})
    void aPointInTheOpenAddsWhatSpreadingAndAirLeave(double distance) {
        NoiseSource plant = NoiseSource.at(new Position(distance, 0, 0), 90);
        World world = open(25).withNoiseSources(Map.of("plant", plant));

        double energy = Levels.toRatio(25);
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double air = Atmosphere.STANDARD.attenuation(OctaveBands.midband(band)) * distance;
            energy += Levels.toRatio(
                    plant.power().level(band) + OctaveBands.aWeight(band) - Levels.sphericalSpreading(distance) - air);
        }
        assertThat(plant.power().aWeighted()).isCloseTo(90, within(1e-9));
        assertThat(noise(world, FEW)).isCloseTo(Levels.ofRatio(energy), within(1e-3));
        assertThat(observe(world, FEW, 20, 1).figures().get("background_db"))
                .isCloseTo(Levels.ofRatio(energy), within(1e-3));
        assertThat(observe(open(25), FEW, 20, 1).figures()).doesNotContainKey("background_db");
    }

    @Test
    void aSourceThatCannotBeHeardLeavesTheNoiseAsItIs() {
        NoiseSource plant = NoiseSource.at(new Position(100, 0, 0), 90);
        World world = walled(25).withNoiseSources(Map.of("plant", plant));
        Observation look = observe(world, FEW.withDiffraction(Diffraction.OFF), 5, 1);
        assertThat(look.figures()).containsEntry("background_converged", 1.0);
        assertThat(look.figures().get("background_db")).isCloseTo(25, within(1e-9));
    }

    /**
     * A straight road is {@code Lw' + 10 lg((t2 - t1) / (4 pi d))}, between the angles under which its ends are seen.
     */
    @ParameterizedTest
    @CsvSource({"50, -500, 500", "50, 0, 300", "5, -200, 30", "200, 400, 900", "300, -20, 20"})
    void aRoadIsTheAngleUnderWhichItIsSeen(double away, double from, double to) {
        NoiseSource road = NoiseSource.along(
                        List.of(
                                new Position(from, away, 0),
                                new Position((from + to) / 3, away, 0),
                                new Position(to, away, 0)),
                        80)
                .withShape(RUMBLE);
        double perMetre = 80 - 10 * Math.log10(to - from);
        double angle = Math.atan(to / away) - Math.atan(from / away);
        double closed = perMetre + 10 * Math.log10(angle / (4 * Math.PI * away));

        double heard = noise(open(-20).withNoiseSources(Map.of("road", road)), FEW);
        double air = Math.hypot(away, Math.max(Math.abs(from), Math.abs(to)))
                * Atmosphere.STANDARD.attenuation(OctaveBands.midband(0));
        assertThat(heard).isBetween(Levels.sum(closed - air, -20) - 0.03, Levels.sum(closed, -20) + 0.03);
        assertThat(road.pieces(MICROPHONE).stream()
                        .mapToDouble(NoiseSource.Piece::fraction)
                        .sum())
                .isCloseTo(1.0, within(1e-9));
    }

    @Test
    void inTheBandsTheRatioFallsByTheNoiseOfTheBand() {
        World quiet = open(20);
        World rumbling = quiet.withNoiseSources(
                Map.of("plant", NoiseSource.at(new Position(30, 0, 0), 85).withShape(RUMBLE)));
        for (String band : List.of("63", "1000")) {
            String figure = "snr_" + band + "hz_db";
            double lost = observe(quiet, FEW, 20, 1).figures().get(figure)
                    - observe(rumbling, FEW, 20, 1).figures().get(figure);
            double background = BackgroundNoise.of(20).spectrum().hz63();
            double closed = Levels.sum(85 + 26.2 - Levels.sphericalSpreading(30), background) - background;
            assertThat(lost).isCloseTo(band.equals("63") ? closed : 0.0, within(0.01));
        }
    }

    /**
     * In the level model 35 dB at 100 m leave 30 dB; with 20 dB of background the range is {@code (P - N - 15) / m}.
     */
    @Test
    void inTheLevelModelTheRangeShrinksAsTheNoiseGrows() {
        World world = open(20).withNoiseSources(Map.of(
                "road", NoiseSource.at(new Position(100, 0, 0), 90).withSoundLevel(35)));
        double noise = Levels.sum(20, 30);
        assertThat(noise(world, LevelModel.DEFAULT)).isCloseTo(noise, within(1e-9));
        double range = (50 - noise - THRESHOLD) / 0.05;
        assertThat(observe(world, LevelModel.DEFAULT, range - 0.1, 1).isDetected())
                .isTrue();
        assertThat(observe(world, LevelModel.DEFAULT, range + 0.1, 1).isDetected())
                .isFalse();
        assertThat(observe(open(20), LevelModel.DEFAULT, 299, 1).isDetected()).isTrue();
        assertThat(noise(
                        open(20).withNoiseSources(Map.of("p", NoiseSource.at(new Position(9, 0, 0), 120))),
                        LevelModel.DEFAULT))
                .as("without a level for this model")
                .isEqualTo(20);
    }

    @Test
    void aWallKeepsNoiseOff() {
        NoiseSource behind = NoiseSource.at(new Position(30, 0, 0), 90).withSoundLevel(60);
        NoiseSource before = NoiseSource.at(new Position(-30, 0, 0), 90).withSoundLevel(60);
        for (Propagation model : List.of(FEW, LevelModel.DEFAULT)) {
            double hidden = noise(walled(10).withNoiseSources(Map.of("plant", behind)), model);
            double open = noise(walled(10).withNoiseSources(Map.of("plant", before)), model);
            assertThat(open - hidden).as("%s", model).isGreaterThan(15.0);
        }
        assertThat(noise(walled(10).withNoiseSources(Map.of("plant", behind)), LevelModel.DEFAULT))
                .isEqualTo(10);
    }

    @Test
    void theNoiseIsTheSameInEveryRunOnAnyNumberOfThreads() {
        World world = walled(10)
                .withNoiseSources(Map.of(
                        "plant", NoiseSource.at(new Position(30, 0, 0), 90).withSoundLevel(60)));
        for (Propagation model : List.of(FEW, LevelModel.DEFAULT)) {
            double one = observe(world, model, 20, 1).threshold();
            assertThat(observe(world, model, 20, 99).threshold()).isEqualTo(one);
            try (Workers three = new Workers(3)) {
                assertThat(three.call(() -> observe(world, model, 20, 1).threshold()))
                        .isEqualTo(one);
            }
            assertThat(AcousticSettings.at(MICROPHONE)
                            .withPropagation(model)
                            .create()
                            .signal(world, drone(20), Optional.empty(), new SplittableRandom(5))
                            .threshold())
                    .isEqualTo(one);
        }
    }

    @Test
    void aLineNeedsALength() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> NoiseSource.along(List.of(MICROPHONE, MICROPHONE), 80))
                .withMessage("positions are all the same: a line needs a length");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> NoiseSource.along(List.of(), 80))
                .withMessage("positions is empty: a noise source needs at least one");
        assertThat(NoiseSource.along(List.of(MICROPHONE, new Position(10, 0, 0)), 80)
                        .pieces(MICROPHONE))
                .as("a microphone on the line")
                .hasSizeBetween(20, 300);
    }
}
