package org.dronewatch.sensor.acoustic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
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
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.DroneSound;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.Wind;
import org.dronewatch.world.SurfaceSettings;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** By the energy model, in the open: what counts as heard over which background. */
class AcousticSensorTest {
    private static final EnergyModel FEW = EnergyModel.DEFAULT.withRays(1000);
    private static final Position MICROPHONE = new Position(0, 0, 0);

    private static World open(BackgroundNoise noise) {
        TriangleMesh farGround =
                TriangleMesh.of(new float[] {0, 0, -5000, 1, 0, -5000, 0, 1, -5000}, new int[] {0, 1, 2});
        return new World(KDTree.of(farGround), noise, SurfaceSettings.DEFAULT, Atmosphere.STANDARD);
    }

    private static Drone drone(double range) {
        Position place = new Position(0, range, 0);
        TriangleMesh any = TriangleMesh.of(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
        DroneSettings settings = DroneSettings.of(ModelSettings.of("none.obj"), new Hover(place, 0.0));
        return new Drone("drone", settings, KDTree.of(any)).move(place.toVector3d());
    }

    private static Observation observe(World world, EnergyModel model, AcousticSettings settings, double range) {
        return settings.withPropagation(model)
                .create()
                .observe(world, List.of(drone(range)), Look.of(1, "microphone", 0, 10.0))
                .get(0);
    }

    private static Observation observe(World world, EnergyModel model, double range) {
        return observe(world, model, AcousticSettings.at(MICROPHONE), range);
    }

    /** A-weighted level of a drone in the open, band by band from its spectrum. */
    private static double expected(double range) {
        List<Double> power = drone(range).settings().soundPower();
        double energy = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double air = Atmosphere.STANDARD.attenuation(OctaveBands.midband(band)) * range;
            energy += Levels.toRatio(
                    power.get(band) + OctaveBands.aWeight(band) - Levels.sphericalSpreading(range) - air);
        }
        return Levels.ofRatio(energy);
    }

    @Test
    void theAWeightedLevelIsComparedWithThatOfTheBackground() {
        World world = open(BackgroundNoise.of(28.0));
        Observation heard = observe(world, FEW, 60.0);

        assertThat(heard.value()).isCloseTo(expected(60.0), within(1e-3));
        assertThat(heard.threshold()).isCloseTo(28.0 + 15.0, within(1e-9));
        assertThat(heard.figures().get("direct_db")).isCloseTo(heard.value(), within(1e-3));
        assertThat(heard.figures().get("reverberant_db")).isLessThan(-30.0);
        assertThat(heard.arrival()).isEqualTo(10.0);
        assertThat(heard.time()).isCloseTo(10.0 - 60.0 / Atmosphere.STANDARD.speedOfSound(), within(1e-9));
    }

    private static Observation hear(DroneSettings settings) {
        TriangleMesh any = TriangleMesh.of(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
        Drone drone = new Drone("drone", settings, KDTree.of(any)).move(new Position(0, 60, 0).toVector3d());
        return AcousticSettings.at(MICROPHONE)
                .withPropagation(FEW.withCriterion(Criterion.BEST_BAND))
                .create()
                .observe(open(BackgroundNoise.of(28.0)), List.of(drone), Look.of(1, "microphone", 0, 10.0))
                .get(0);
    }

    private static DroneSettings hovering() {
        return DroneSettings.of(ModelSettings.of("none.obj"), new Hover(new Position(0, 60, 0), 0.0));
    }

    /**
     * In the free field each octave travels alone: 6 dB more at the source are 6 dB more in that band, and in no other.
     */
    @Test
    void sixDecibelsInOneBandAreHeardInThatBand() {
        double[] power = {70, 72, 74, 76, 78, 76, 74, 70};
        DroneSound quiet = DroneSound.of("own", BandLevels.of(power), DroneSound.Basis.ASSUMED, "test");
        power[5] += 6.0;
        DroneSound loud = DroneSound.of("own", BandLevels.of(power), DroneSound.Basis.ASSUMED, "test");
        Observation before = hear(hovering().withSound(quiet));
        Observation after = hear(hovering().withSound(loud));
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            String figure = "level_" + OctaveBands.nominal(band) + "hz_db";
            double raised = after.figures().get(figure) - before.figures().get(figure);
            assertThat(raised).as(figure).isCloseTo(band == 5 ? 6.0 : 0.0, within(1e-9));
        }
    }

    /**
     * A background that is loud but in one band: by the A-weighted level the drone is lost in it, by bands it is not.
     */
    @Test
    void theBestBandIsComparedWithItsOwnBackground() {
        BandLevels spectrum = BandLevels.of(60, 55, 50, 45, 40, 5, 20, 30);
        World world = open(BackgroundNoise.of(spectrum));
        Observation broad = observe(world, FEW, 100.0);
        Observation band = observe(world, FEW.withCriterion(Criterion.BEST_BAND), 100.0);

        assertThat(broad.isDetected()).isFalse();
        assertThat(broad.threshold()).isCloseTo(spectrum.aWeighted() + 15.0, within(1e-9));
        assertThat(band.isDetected()).isTrue();
        assertThat(band.threshold()).isEqualTo(15.0);
        double level = band.figures().get("level_2000hz_db");
        assertThat(band.value()).isCloseTo(level - 5.0, within(1e-9));
        assertThat(band.figures().get("snr_2000hz_db")).isCloseTo(band.value(), within(1e-9));
        assertThat(band.figures().get("snr_1000hz_db"))
                .isCloseTo(band.figures().get("level_1000hz_db") - 40.0, within(1e-9));
    }

    @Test
    void anArrayHearsSoMuchMore() {
        World world = open(BackgroundNoise.of(28.0));
        AcousticSettings array = AcousticSettings.at(MICROPHONE).withArrayGain(9.0);
        for (Criterion criterion : Criterion.values()) {
            EnergyModel model = FEW.withCriterion(criterion);
            assertThat(observe(world, model, array, 60.0).threshold())
                    .isCloseTo(observe(world, model, 60.0).threshold() - 9.0, within(1e-9));
        }
    }

    @Test
    void moreNoiseOrDistanceNeverHelps() {
        double level = Double.POSITIVE_INFINITY;
        for (double range : new double[] {10, 20, 50, 100, 200, 500}) {
            Observation heard = observe(open(BackgroundNoise.of(20.0)), FEW, range);
            assertThat(heard.value()).isLessThan(level);
            level = heard.value();
        }
        double over = Double.POSITIVE_INFINITY;
        for (double noise : new double[] {0, 10, 20, 30, 40}) {
            Observation heard = observe(open(BackgroundNoise.of(noise)), FEW, 50.0);
            assertThat(heard.value() - heard.threshold()).isLessThan(over);
            over = heard.value() - heard.threshold();
        }
    }

    /**
     * Wind adds its noise to the background, band by band: Strasberg's formula in thirds of octaves, with a screen of 9
     * cm, for the wind at the height of the microphone, here 4.35 m/s.
     */
    @Test
    void windAddsItsNoiseToTheBackground() {
        BackgroundNoise background = BackgroundNoise.of(28.0);
        TriangleMesh ground = TriangleMesh.of(
                new float[] {-900, -900, -2, 900, -900, -2, 900, 900, -2, -900, 900, -2}, new int[] {0, 1, 2, 0, 2, 3});
        World windy = new World(
                KDTree.of(ground),
                background,
                SurfaceSettings.DEFAULT,
                Atmosphere.STANDARD.withWind(new Wind(6.0, 0.0, 0.03)));
        double speed = 6.0 * Math.log(1 + 2 / 0.03) / Math.log(1 + 10 / 0.03);
        assertThat(speed).isCloseTo(4.35, within(0.01));
        double all = 0;
        double[] expected = new double[OctaveBands.COUNT];
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double energy = Levels.toRatio(background.spectrum().level(band));
            for (int third = -1; third <= 1; third++) {
                double frequency = 1000 * Math.pow(10, 0.3 * (band - 4) + 0.1 * third);
                energy += Levels.toRatio(40 * Math.log10(speed) - 23 * Math.log10(frequency * 0.09 / speed) + 15);
            }
            expected[band] = Levels.ofRatio(energy);
            all += energy * Levels.toRatio(OctaveBands.aWeight(band));
        }
        Observation heard = observe(windy, FEW, 60.0);

        assertThat(heard.threshold()).isCloseTo(Levels.ofRatio(all) + 15.0, within(1e-6));
        assertThat(heard.figures().get("background_db")).isCloseTo(Levels.ofRatio(all), within(1e-6));
        assertThat(Levels.ofRatio(all)).isGreaterThan(background.spectrum().aWeighted() + 1.0);
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            String name = OctaveBands.nominal(band) + "hz_db";
            double noise =
                    heard.figures().get("level_" + name) - heard.figures().get("snr_" + name);
            assertThat(noise).as(name).isCloseTo(expected[band], within(1e-6));
        }
    }

    /** However it falls on the bands, all of it together is what it is said to be. */
    @Test
    void theShapeOfABackgroundKeepsItsLevel() {
        for (BandLevels shape : List.of(BackgroundNoise.FALLING, BandLevels.flat(0), BandLevels.flat(70))) {
            BackgroundNoise noise = new BackgroundNoise(33.0, shape);
            assertThat(noise.spectrum().aWeighted()).isCloseTo(33.0, within(1e-9));
            assertThat(noise.spectrum().level(2) - noise.spectrum().level(5))
                    .isCloseTo(shape.level(2) - shape.level(5), within(1e-9));
        }
        BandLevels measured = BandLevels.of(50, 48, 44, 41, 38, 33, 27, 20);
        assertThat(BackgroundNoise.of(measured).spectrum().toArray())
                .usingComparatorWithPrecision(1e-9)
                .containsExactly(measured.toArray());
    }
}
