package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.acoustic.energy.Sites.LOWEST;
import static org.dronewatch.sensor.acoustic.energy.Sites.LW;

import java.util.Collections;
import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.sensor.acoustic.edge.EdgePath;
import org.dronewatch.sensor.acoustic.propagation.Diffraction;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.Barrier;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Paths that are computed and not drawn by chance: mirrors, edges, directions. */
class ExactPathsTest {
    private static final EnergyModel FEW = EnergyModel.DEFAULT.withRays(1);
    private static final SurfaceMaterial RIGID = SurfaceMaterial.uniform("rigid", 0, 0);

    /**
     * Three rigid planes that meet at a right corner: seven images besides the source, the last by three reflections.
     */
    @Test
    void aCornerOfThreeMirrorsIsEightSources() {
        double far = 500;
        TriangleMesh corner = World.merge(List.of(
                Sites.wall(0, 0, 0, far, 0, far), Sites.wall(1, 0, 0, far, 0, far), Sites.wall(2, 0, 0, far, 0, far)));
        Position source = new Position(20, 31, 12);
        Position sensor = new Position(3, 2, 1.5);
        double expected = 0.0;
        double m = Atmosphere.STANDARD.attenuations()[LOWEST] * Math.log(10) / 10;
        for (int image = 0; image < 8; image++) {
            Position at = new Position(
                    (image & 1) == 0 ? source.x() : -source.x(),
                    (image & 2) == 0 ? source.y() : -source.y(),
                    (image & 4) == 0 ? source.z() : -source.z());
            double r = at.distance(sensor);
            expected += Levels.toRatio(LW) * Math.exp(-m * r) / (4 * Math.PI * r * r);
        }
        EnergyReading reading = Sites.read(FEW, Sites.world(corner, RIGID), Sites.sound(source, LOWEST), sensor, 1);

        assertThat(reading.totalLevel()).isCloseTo(Levels.ofRatio(expected), within(1e-6));
        EnergyReading twoOnly = Sites.read(
                FEW.withImageSourceOrder(2).withRays(20_000).withAccuracy(0),
                Sites.world(corner, RIGID),
                Sites.sound(source, LOWEST),
                sensor,
                2);
        assertThat(twoOnly.mirrored().get(LOWEST))
                .as("the last image is left to the rays")
                .isLessThan(reading.mirrored().get(LOWEST));
    }

    /**
     * Test case TC01 of ISO/TR 17534-4: source 1 m and receiver 4 m above hard ground, 194.16 m apart on it, 10 degrees
     * and 70 %, 93 dB in each band; results as in the tests of NoiseModelling (AttenuationComputeOutputCnossosTest).
     * CNOSSOS-EU rounds 10.99 and 3.01 dB to 11 and 3, and the results are rounded: 0.023 dB in all.
     */
    @Test
    void overTheHardGroundOfTestCase1() {
        double[] expected = {39.21, 39.16, 39.03, 38.86, 38.53, 37.36, 32.87, 16.54};
        World ground = new World(
                KDTree.of(Sites.square(2000, 0)),
                BackgroundNoise.of(20),
                List.of(RIGID),
                new Atmosphere(283.15, 0.7, 101_325));
        SoundSource source = new SoundSource(
                new Position(0, 0, 1), Collections.nCopies(OctaveBands.COUNT, 93.0), Directivity.OMNIDIRECTIONAL);
        EnergyReading reading = Sites.read(FEW, ground, source, new Position(194.16, 0, 4), 1);
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            assertThat(reading.level(band)).as("band %d", band).isCloseTo(expected[band], within(0.023));
        }
    }

    /**
     * Sums of the exact image sources of a room of 10 x 8 x 4 m with absorption 0.2, over the direct sound, order by
     * order. The second sensor is level with the source: paths over the edge of two walls count once.
     */
    @ParameterizedTest
    @CsvSource({
        "7, 5, 1.7, 2.019293, 2.441645, 2.355880, 2.004522",
        "4, 3, 1.5, 0.572483, 0.439296, 0.354363, 0.281051",
        "9, 7, 3.4, 3.267319, 5.126167, 5.450798, 4.778855"
    })
    void aRoomHasAllImagesOfEachOrder(
            double x, double y, double z, double first, double second, double third, double fourth) {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.2, 0));
        Position sensor = new Position(x, y, z);
        SoundSource source = Sites.sound(new Position(2, 3, 1.5), LOWEST);
        double[] orders = {first, second, third, fourth};
        double before = 0.0;
        for (int order = 1; order <= orders.length; order++) {
            EnergyReading reading = Sites.read(FEW.withImageSourceOrder(order), room, source, sensor, 1);
            double mirrored = reading.mirrored().get(LOWEST) / reading.direct().get(LOWEST);
            // The file's sums are without air, which takes up to 0.05 % on these ways at 63 Hz.
            assertThat(mirrored - before)
                    .as("order %d", order)
                    .isCloseTo(orders[order - 1], within(5e-4 * orders[order - 1]));
            before = mirrored;
        }
    }

    /** A thin wall: the way over its edge gives the path difference, and Maekawa's curve the level. */
    @ParameterizedTest
    @CsvSource({"4, MAEKAWA", "4, ISO9613", "1, MAEKAWA", "7, ISO9613"})
    void behindAWallIsWhatComesOverItsEdge(int band, Diffraction diffraction) {
        World wall = Sites.world(Sites.wall(1, 0, -3000, 10, -3000, 3000), SurfaceMaterial.uniform("wall", 1, 0));
        Position source = new Position(0, -50, 5);
        Position sensor = new Position(0, 40, 2);
        Position edge = new Position(0, 0, 10);
        double straight = source.distance(sensor);
        double over = source.distance(edge) + edge.distance(sensor);
        double wavelength = Atmosphere.STANDARD.speedOfSound() / OctaveBands.midband(band);
        double loss = diffraction == Diffraction.MAEKAWA
                ? Barrier.maekawa(over - straight, wavelength)
                : Barrier.iso9613(over - straight, 0.0, wavelength);
        double expected = LW
                - Levels.sphericalSpreading(straight)
                - loss
                - over * Atmosphere.STANDARD.attenuations()[band];

        EnergyModel model = FEW.withDiffraction(diffraction);
        EnergyReading there = Sites.read(model, wall, Sites.sound(source, band), sensor, 1);
        assertThat(there.totalLevel()).isCloseTo(expected, within(0.01));
        EnergyReading back = Sites.read(model, wall, Sites.sound(sensor, band), source, 1);
        assertThat(back.totalLevel()).as("changed places").isCloseTo(there.totalLevel(), within(1e-6));
        EnergyReading dark =
                Sites.read(model.withDiffraction(Diffraction.OFF), wall, Sites.sound(source, band), sensor, 1);
        assertThat(dark.totalLevel()).isEqualTo(Double.NEGATIVE_INFINITY);
    }

    /** The wall is lower at its side than at its top: sound comes round the side. */
    @Test
    void theNearestEdgeCounts() {
        World wall = Sites.world(Sites.wall(1, 0, -3000, 30, -3000, 2), SurfaceMaterial.uniform("wall", 1, 0));
        Position source = new Position(0, -50, 5);
        Position sensor = new Position(0, 40, 5);
        Position edge = new Position(2, 0, 5);
        double difference = source.distance(edge) + edge.distance(sensor) - source.distance(sensor);
        EdgePath path = new EdgePath(wall);

        assertThat(path.find(source, sensor)).isTrue();
        assertThat(path.pathDifference()).isCloseTo(difference, within(1e-4));
    }

    /** Over a block, the path goes from edge to edge. */
    @Test
    void overABlockThePathFollowsItsRoof() {
        World block = Sites.world(Sites.box(-3000, -5, -3000, 3000, 5, 10), SurfaceMaterial.uniform("wall", 1, 0));
        EdgePath path = new EdgePath(block);

        assertThat(path.find(new Position(0, -45, 0), new Position(0, 45, 0))).isTrue();
        // Both edges are 40 m away and 10 m up.
        assertThat(path.pathDifference()).isCloseTo(2 * Math.hypot(40, 10) + 10 - 90, within(1e-6));
        assertThat(path.sinElevation()).isCloseTo(0.25 / Math.hypot(1, 0.25), within(1e-6));
    }

    @Test
    void outOfAClosedRoomNoEdgeLeads() {
        World box = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 1, 0));
        assertThat(new EdgePath(box).find(new Position(5, 4, 2), new Position(30, 4, 2)))
                .isFalse();
    }

    /** A drone straight above is louder than one at the side by the published gains, on every kind of path. */
    @Test
    void directivityFollowsTheElevationOfEachPath() {
        Position sensor = new Position(0, 0, 0);
        int band = OctaveBands.ONE_KILOHERTZ;
        for (double degrees : new double[] {0, 20, 45, 90}) {
            double t = Math.toRadians(degrees);
            Position place = new Position(0, 50 * Math.cos(t), 50 * Math.sin(t));
            double even = Sites.read(FEW, Sites.open(), Sites.sound(place, band), sensor, 1)
                    .totalLevel();
            double rotor = Sites.read(FEW, Sites.open(), Sites.sound(place, band, Directivity.ROTOR), sensor, 1)
                    .totalLevel();
            assertThat(rotor - even)
                    .as("%f degrees", degrees)
                    .isCloseTo(Directivity.ROTOR.index(band, t), within(0.005));
        }
        // Over a rigid floor: straight at 0 degrees, by the mirror image at -45.
        World floor = Sites.world(Sites.square(500, -10), RIGID);
        Position level = new Position(0, 20, 0);
        EnergyReading even = Sites.read(FEW, floor, Sites.sound(level, band), sensor, 1);
        EnergyReading rotor = Sites.read(FEW, floor, Sites.sound(level, band, Directivity.ROTOR), sensor, 1);
        assertThat(Levels.ofRatio(rotor.mirrored().get(band) / even.mirrored().get(band)))
                .isCloseTo(Directivity.ROTOR.index(band, Math.PI / 4), within(0.005));
    }
}
