package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.acoustic.energy.Sites.LOWEST;
import static org.dronewatch.sensor.acoustic.energy.Sites.LW;
import static org.dronewatch.sensor.acoustic.energy.Sites.readInFull;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.propagation.Diffraction;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The energy model against closed forms, an exact image-source sum and an independent Monte Carlo simulation. */
class EnergyModelTest {
    private static final int READINGS = 12;
    /** The band of 1 kHz, in which rotors are directed. */
    private static final int KILOHERTZ = 4;

    private static final Position SOURCE = new Position(2, 3, 1.5);

    @Test
    void inTheOpenTheLevelFallsBySpreadingAndAir() {
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double a = Atmosphere.STANDARD.attenuation(OctaveBands.midband(band));
            for (double r : new double[] {1, 2, 10, 100, 1000}) {
                EnergyReading reading =
                        readInFull(Sites.open(), new Position(0, r, 0), new Position(0, 0, 0), 0.5, 1, band, 1);
                assertThat(reading.totalLevel())
                        .as("%d Hz at %f m", OctaveBands.nominal(band), r)
                        .isCloseTo(LW - 10.99 - 20 * Math.log10(r) - a * r, within(0.05));
            }
        }
    }

    /** By the scene's air: 413.2 Pa s/m at 20 degrees, dry; a mountain's are less than the reference. */
    @ParameterizedTest
    @CsvSource({"20, 101325, 0.141", "0, 60000, -1.981"})
    void pressureMayFollowTheAir(double celsius, double pascal, double more) {
        Atmosphere dry = new Atmosphere(celsius + 273.15, 0, pascal);
        World air = new World(
                KDTree.of(Sites.room(10, 8, 4)),
                BackgroundNoise.of(20),
                List.of(SurfaceMaterial.uniform("wall", 0.3, 0.2)),
                dry);
        EnergyModel physical = EnergyModel.DEFAULT.withPressure(EnergyModel.Pressure.PHYSICAL);
        Position sensor = new Position(7, 5, 1.7);
        double level = Sites.read(physical, air, Sites.sound(SOURCE, LOWEST), sensor, 3)
                .totalLevel();
        double reference = Sites.read(EnergyModel.DEFAULT, air, Sites.sound(SOURCE, LOWEST), sensor, 3)
                .totalLevel();
        assertThat(level - reference).isCloseTo(more, within(0.01));
    }

    /**
     * Source 50 m, receiver 1.5 m over a rigid plane, 100 m apart: the mirror image adds 2.9585 dB (less its own air).
     */
    @Test
    void aRigidPlaneAddsItsMirrorImage() {
        World plane = Sites.world(Sites.square(5000, 0), SurfaceMaterial.uniform("rigid", 0, 0));
        EnergyReading reading =
                readInFull(plane, new Position(100, 0, 50), new Position(0, 0, 1.5), 0.5, 1000, LOWEST, 1);

        double gain = reading.totalLevel() - Levels.ofRatio(reading.direct().get(LOWEST));
        assertThat(gain).isCloseTo(2.9585, within(2e-3));
        assertThat(reading.reverberant().get(LOWEST)).isZero();
    }

    /** Over the common edge of a wall's two triangles there is one reflection, not two. */
    @Test
    void aReflectionOnTheEdgeOfTwoTrianglesCountsOnce() {
        World plane = Sites.world(Sites.square(50, 0), SurfaceMaterial.uniform("rigid", 0, 0));
        EnergyReading reading = readInFull(plane, new Position(-3, -3, 4), new Position(3, 3, 4), 0.5, 1, LOWEST, 1);

        double direct = 6 * Math.sqrt(2);
        assertThat(reading.mirrored().get(LOWEST) / reading.direct().get(LOWEST))
                .isCloseTo(direct * direct / (direct * direct + 64), within(1e-3));
    }

    /**
     * A room of 10 x 8 x 4 m with absorption 0.2 and mirror walls; levels over the direct sound. Exact image-source
     * sums with the air of 20 degrees and 70 % (4.978 dB/km at 1 kHz), all images within 600 m.
     */
    @ParameterizedTest
    @CsvSource({"7, 5, 1.7, 12.431, 1.0171", "4, 3, 1.5, 5.6829, 0.9952"})
    void aRoomOfMirrorsIsTheSumOfItsImages(double x, double y, double z, double level, double t30) {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.2, 0));
        Position sensor = new Position(x, y, z);
        EnergyReading reading = readInFull(room, SOURCE, sensor, 0.4, 100_000, OctaveBands.ONE_KILOHERTZ, 7);

        double direct = LW - Levels.sphericalSpreading(SOURCE.distance(sensor));
        assertThat(reading.totalLevel() - direct)
                .as("standard error %f dB, seed 7", reading.standardError())
                .isCloseTo(level, within(4 * reading.standardError() + 0.05));
        assertThat(reading.standardError()).isLessThan(0.1);
        assertThat(reading.decay().t30().orElseThrow()).isCloseTo(t30, within(0.05 * t30));
        assertThat(reading.audit().imbalance()).isCloseTo(0.0, within(1e-9));
    }

    /**
     * In a corridor of 30 m whose walls scatter 0.3, at 63 Hz with its air: an independent simulation followed 10
     * million rays from the drone and measured their chords in a ball of 0.25 m.
     */
    @Test
    void aCorridorThatScattersAgreesWithAnIndependentSimulation() {
        World corridor = Sites.world(Sites.room(30, 3, 2.5), SurfaceMaterial.uniform("wall", 0.2, 0.3));
        Position source = new Position(2, 1, 1.5);
        Position sensor = new Position(10, 2, 1.2);
        EnergyModel model = EnergyModel.DEFAULT.withRays(60_000).withAccuracy(0.0);
        EnergyReading reading = Sites.read(model, corridor, Sites.sound(source, LOWEST), sensor, 11);

        double direct = LW - Levels.sphericalSpreading(source.distance(sensor));
        assertThat(reading.standardError()).isLessThan(0.1);
        assertThat(reading.totalLevel() - direct)
                .as("standard error %f dB, seed 11", reading.standardError())
                .isCloseTo(15.280, within(4 * Math.hypot(reading.standardError(), 0.010)));
    }

    /**
     * The same room with scattering walls, without air (here at 63 Hz, where air takes 0.09 dB/km). Means, standard
     * errors and T30 of an independent energy-conserving Monte Carlo simulation of 400,000 rays.
     */
    @ParameterizedTest
    @CsvSource({
        "0.1, 7, 5, 1.7, 12.452, 0.031, 0.8801",
        "0.1, 4, 3, 1.5, 5.825, 0.030, 0.8679",
        "0.1, 9, 7, 3.4, 15.794, 0.031, 0.8807",
        "0.5, 7, 5, 1.7, 12.352, 0.031, 0.7881",
        "0.5, 4, 3, 1.5, 5.976, 0.029, 0.7885",
        "0.5, 9, 7, 3.4, 15.458, 0.033, 0.7896",
        "1.0, 7, 5, 1.7, 12.197, 0.032, 0.7977",
        "1.0, 4, 3, 1.5, 6.191, 0.028, 0.7953",
        "1.0, 9, 7, 3.4, 15.077, 0.035, 0.7958",
    })
    void aRoomThatScattersAgreesWithAnIndependentSimulation(
            double scattering, double x, double y, double z, double level, double error, double t30) {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.2, scattering));
        Position sensor = new Position(x, y, z);
        EnergyReading reading = readInFull(room, SOURCE, sensor, 0.4, 30_000, LOWEST, 11);

        double direct = LW - Levels.sphericalSpreading(SOURCE.distance(sensor));
        double both = Math.hypot(reading.standardError(), error);
        assertThat(reading.totalLevel() - direct)
                .as("standard error %f dB, seed 11", reading.standardError())
                .isCloseTo(level, within(4 * both + 0.05));
        assertThat(reading.decay().t30().orElseThrow()).isCloseTo(t30, within(0.05 * t30));
        assertThat(reading.audit().imbalance()).isCloseTo(0.0, within(1e-9));
    }

    /** The level must scatter as its standard error says: the spread of many readings against the mean stated error. */
    @Thorough
    @Test
    void theStandardErrorIsHonest() {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.3, 0.5));
        int runs = 60;
        double sum = 0;
        double squares = 0;
        double stated = 0;
        for (int i = 0; i < runs; i++) {
            EnergyReading reading = readInFull(room, SOURCE, new Position(7, 5, 1.7), 0.4, 2000, LOWEST, 100 + i);
            sum += reading.totalLevel();
            squares += reading.totalLevel() * reading.totalLevel();
            stated += reading.standardError() / runs;
        }
        double spread = Math.sqrt((squares - sum * sum / runs) / (runs - 1));
        // The spread of 60 values is known to 9 %; three of that.
        assertThat(spread / stated).as("seeds 100 to 159").isBetween(0.73, 1.27);
    }

    /** Neither the number of rays nor where chance begins moves the level beyond what the standard errors allow. */
    @Thorough
    @Test
    void theLevelDoesNotDependOnHowItIsEstimated() {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.1, 0.3));
        Position sensor = new Position(7, 5, 1.7);
        EnergyReading careful = readInFull(room, SOURCE, sensor, 0.4, 60_000, LOWEST, 21);
        for (EnergyModel model : List.of(
                EnergyModel.DEFAULT,
                EnergyModel.DEFAULT.withAccuracy(0.0),
                EnergyModel.DEFAULT.withRays(1000),
                EnergyModel.DEFAULT.withRays(30_000).withRoulette(0.05))) {
            EnergyReading quick = new EnergyTracer(model, sensor, 0.4, room)
                    .trace(Sites.sound(SOURCE, LOWEST), new SplittableRandom(22), RayRecorder.NONE);
            double both = Math.hypot(careful.standardError(), quick.standardError());
            assertThat(quick.totalLevel()).as("%s", model).isCloseTo(careful.totalLevel(), within(4 * both));
        }
    }

    @Thorough
    @Test
    void sourceAndSensorMayChangePlaces() {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.2, 0.3));
        Position other = new Position(7.5, 6, 2.5);
        EnergyReading there = readInFull(room, SOURCE, other, 0.4, 60_000, LOWEST, 3);
        EnergyReading back = readInFull(room, other, SOURCE, 0.4, 60_000, LOWEST, 4);

        double both = Math.hypot(there.standardError(), back.standardError());
        assertThat(there.totalLevel()).isCloseTo(back.totalLevel(), within(4 * both));
    }

    @Test
    void moreAbsorptionIsNeverLouder() {
        double before = Double.POSITIVE_INFINITY;
        for (double absorption : new double[] {0.05, 0.2, 0.5, 0.9, 1.0}) {
            World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", absorption, 0.2));
            double level = readInFull(room, SOURCE, new Position(7, 5, 1.7), 0.4, 5000, LOWEST, 5)
                    .totalLevel();
            assertThat(level).isLessThan(before);
            before = level;
        }
    }

    /**
     * One ray carries all bands, and chance chooses one branch for them together: each band must come out as if it were
     * alone, where walls absorb, scatter and transmit each band otherwise.
     */
    @Thorough
    @Test
    void eachBandIsAsIfItWereAlone() {
        List<Double> absorption = List.of(0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7);
        List<Double> scattering = List.of(0.9, 0.05, 0.8, 0.1, 0.7, 0.2, 0.6, 0.3);
        List<Double> loss = List.of(10.0, 40.0, 12.0, 30.0, 8.0, 25.0, 6.0, 5.0);
        SurfaceMaterial wall = new SurfaceMaterial(
                "wall", absorption, scattering, loss, Wall.SHEET, OptionalDouble.empty(), "made up for this test");
        // Two rooms, one beside the other: part of what is heard went through the wall between them and back.
        TriangleMesh rooms = World.merge(List.of(Sites.room(10, 8, 4), Sites.box(10.001, 0, 0, 16, 8, 4)));
        World site = Sites.world(rooms, wall);
        Position sensor = new Position(7, 5, 1.7);
        EnergyModel model = EnergyModel.DEFAULT.withRays(10_000).withAccuracy(0.0);
        List<List<Double>> together = new ArrayList<>();
        for (int seed = 0; seed < READINGS; seed++) {
            together.add(Sites.read(model, site, Sites.broadband(SOURCE), sensor, seed)
                    .reverberant());
        }

        // In the build every third, the lowest among them.
        for (int band = 0; band < OctaveBands.COUNT; band += LongForm.count(3, 1)) {
            SoundSource sound = Sites.sound(SOURCE, band);
            double[] joint = new double[READINGS];
            double[] alone = new double[READINGS];
            for (int seed = 0; seed < READINGS; seed++) {
                joint[seed] = together.get(seed).get(band);
                alone[seed] = Sites.read(model, site, sound, sensor, 1000 + seed)
                        .reverberant()
                        .get(band);
            }
            double error = Math.hypot(errorOfMean(joint), errorOfMean(alone));
            assertThat(mean(joint) / mean(alone))
                    .as("%d Hz, seeds from 0 and from 1000", OctaveBands.nominal(band))
                    .isCloseTo(1.0, within(4 * error / mean(alone)));
            assertThat(error / mean(alone)).isLessThan(0.1);
        }
    }

    private static double mean(double... values) {
        return DoubleStream.of(values).average().orElseThrow();
    }

    private static double errorOfMean(double... values) {
        double mean = mean(values);
        double squares = DoubleStream.of(values)
                .map(value -> (value - mean) * (value - mean))
                .sum();
        return Math.sqrt(squares / values.length / (values.length - 1));
    }

    /**
     * The mirror images, each with its own way through the air, are exact: at 8 kHz, where the air takes most of what
     * comes late, and in a corridor of 30 m, along which sound does not become diffuse.
     */
    @ParameterizedTest
    @CsvSource({"10, 8, 4, 0.05, 7", "30, 3, 2.5, 0.2, 3"})
    void lateReflectionsAreImagesWithTheirAir(double x, double y, double z, double absorption, int band) {
        World room = Sites.world(Sites.room(x, y, z), SurfaceMaterial.uniform("wall", absorption, 0));
        Position source = new Position(2, 0.4 * y, 1.5);
        Position sensor = new Position(x - 4, 0.7 * y, 1.2);
        EnergyReading reading = readInFull(room, source, sensor, 0.4, 100_000, band, 7);

        double loss = Atmosphere.STANDARD.attenuation(OctaveBands.midband(band));
        double sum = 0;
        int most = 40;
        for (int i = -most; i <= most; i++) {
            for (int j = -most; j <= most; j++) {
                for (int k = -most; k <= most; k++) {
                    double dx = image(i, x, source.x()) - sensor.x();
                    double dy = image(j, y, source.y()) - sensor.y();
                    double dz = image(k, z, source.z()) - sensor.z();
                    double way = Math.sqrt(dx * dx + dy * dy + dz * dz);
                    int order = Math.abs(i) + Math.abs(j) + Math.abs(k);
                    sum += Math.pow(1 - absorption, order) * Levels.toRatio(-loss * way) / (4 * Math.PI * way * way);
                }
            }
        }
        assertThat(reading.totalLevel())
                .as("standard error %f dB, seed 7", reading.standardError())
                .isCloseTo(LW + Levels.ofRatio(sum), within(4 * reading.standardError() + 0.05));
        assertThat(reading.standardError()).isLessThan(0.04);
    }

    /** Where the n-th image along an axis stands: every other one is mirrored. */
    private static double image(int n, double length, double place) {
        return n * length + (n % 2 == 0 ? place : length - place);
    }

    /**
     * A wide wall between source and sensor lowers the level by its loss, as a sheet and as a solid of two faces alike;
     * without diffraction, nothing is heard through an opaque one.
     */
    @Test
    void aWallTakesItsLossOnce() {
        SurfaceMaterial opaque = SurfaceMaterial.uniform("wall", 0.3, 0.1);
        TriangleMesh oneFace = Sites.square(1000, 5);
        TriangleMesh twoFaces = World.merge(List.of(oneFace, Sites.square(1000, 5.2)));
        double free = straightThrough(Sites.open()).totalLevel();

        EnergyReading sheet = straightThrough(Sites.world(oneFace, opaque.withTransmissionLoss(25, Wall.SHEET)));
        assertThat(sheet.totalLevel()).isCloseTo(free - 25, within(0.01));
        EnergyReading solid = straightThrough(Sites.world(twoFaces, opaque.withTransmissionLoss(25, Wall.SOLID)));
        assertThat(Levels.ofRatio(solid.direct().get(LOWEST))).isCloseTo(free - 25, within(1e-6));
        assertThat(solid.totalLevel()).isCloseTo(free - 25, within(0.01));
        assertThat(straightThrough(Sites.world(oneFace, opaque)).totalLevel()).isEqualTo(Double.NEGATIVE_INFINITY);
    }

    /** From 5 m above to 5 m below where walls stand, with diffraction off. */
    private static EnergyReading straightThrough(World world) {
        EnergyModel model = EnergyModel.DEFAULT.withRays(2000).withAccuracy(0.0).withDiffraction(Diffraction.OFF);
        return new EnergyTracer(model, new Position(0, 0, 0), 0.5, world)
                .trace(Sites.sound(new Position(0, 0, 10), LOWEST), new SplittableRandom(1), RayRecorder.NONE);
    }

    /**
     * Rotors are loudest below and above, and between two high walls all mirror images are level with them. What is
     * computed exactly and what is left to the rays must agree on that: the whole is the same wherever the border
     * between them lies.
     */
    @Test
    void aDirectedSourceIsHeardAlikeByMirrorsAndByRays() {
        TriangleMesh canyon =
                World.merge(List.of(Sites.wall(0, 0, -40, 40, -40, 40), Sites.wall(0, 6, -40, 40, -40, 40)));
        World walls = Sites.world(canyon, SurfaceMaterial.uniform("wall", 0.1, 0));
        SoundSource rotor = Sites.sound(new Position(2, 0, 0), KILOHERTZ, Directivity.ROTOR);
        Position sensor = new Position(4.5, 3, 0);
        EnergyModel model = EnergyModel.DEFAULT.withRays(100_000).withAccuracy(0.0);
        EnergyReading byRays = Sites.read(model.withImageSourceOrder(1), walls, rotor, sensor, 41);
        EnergyReading byMirrors = Sites.read(model.withImageSourceOrder(4), walls, rotor, sensor, 42);

        assertThat(byRays.reverberant().get(KILOHERTZ))
                .isGreaterThan(1.5 * byMirrors.reverberant().get(KILOHERTZ));
        assertThat(byRays.level(KILOHERTZ))
                .as("standard errors %.3f and %.3f dB", byRays.standardError(), byMirrors.standardError())
                .isCloseTo(
                        byMirrors.level(KILOHERTZ),
                        within(4 * (byRays.standardError() + byMirrors.standardError()) + 0.02));
    }

    @Test
    void settingsHaveLimits() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> EnergyModel.DEFAULT.withRays(0))
                .withMessageContaining("rays 0");
        assertThatIllegalArgumentException().isThrownBy(() -> EnergyModel.DEFAULT.withRoulette(1.0));
    }
}
