package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Ground;
import org.dronewatch.sensor.acoustic.propagation.GroundPlane;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.BandFractions;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.GroundImpedance;
import org.dronewatch.sound.surface.GroundInterference;
import org.dronewatch.sound.surface.OwnSurface;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterials;
import org.dronewatch.sound.surface.TurbulentCoherence;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Direct sound and what the ground of a site reflects interfere. */
class CoherentGroundTest {
    private static final EnergyModel INCOHERENT =
            EnergyModel.DEFAULT.withRays(1).withTurbulence(0);
    private static final EnergyModel COHERENT = INCOHERENT.withGround(Ground.COHERENT);

    /** Smooth, and everything that its impedance does not reflect is absorbed. */
    private static final SurfaceMaterial GRASS = SurfaceMaterial.uniform("grass_50mm", 0.5, 0);

    private static final SurfaceMaterial RIGID = SurfaceMaterial.uniform("perfect_mirror", 0, 0);
    private static final Position SOURCE = new Position(0, 0, 2);
    private static final Position SENSOR = new Position(100, 0, 1.5);

    /** Over grass, flow resistivity 200 kPa s/m2: what the bands from 63 Hz to 8 kHz gain over the free field, dB. */
    private static final double[] OVER_GRASS = {5.5, 3.7, -2.6, -11.0, -2.0, 3.9, 3.4, 2.4};

    private static double[] gains(EnergyModel model, World world, Position source, Position sensor) {
        EnergyTracer tracer = new EnergyTracer(model, sensor, 0.4, world);
        SoundSource sound = Sites.broadband(source);
        EnergyReading heard = tracer.trace(sound, new SplittableRandom(1), RayRecorder.NONE);
        EnergyReading open = tracer.inTheOpen(sound);
        double[] gains = new double[OctaveBands.COUNT];
        for (int band = 0; band < gains.length; band++) {
            gains[band] = heard.level(band) - open.level(band);
        }
        return gains;
    }

    private static TriangleMesh of(String material, TriangleMesh mesh) {
        int count = mesh.triangleCount();
        float[] vertices = new float[9 * count];
        int[] corners = new int[3 * count];
        for (int corner = 0; corner < corners.length; corner++) {
            corners[corner] = corner;
            for (int axis = 0; axis < 3; axis++) {
                vertices[3 * corner + axis] = mesh.coordinate(corner / 3, corner % 3, axis);
            }
        }
        return new TriangleMesh(vertices, corners, new int[count], new int[count], List.of(material));
    }

    @Test
    void grassGivesThePublishedBands() {
        World meadow = Sites.world(Sites.square(1000, 0), GRASS);
        double[] gains = gains(COHERENT, meadow, SOURCE, SENSOR);
        for (int band = 0; band < gains.length; band++) {
            // The air takes a little more from the reflected path.
            assertThat(gains[band]).as("band %d", band).isCloseTo(OVER_GRASS[band], within(0.06));
        }
        double[] back = gains(COHERENT, meadow, SENSOR, SOURCE);
        assertThat(back).containsExactly(gains, within(1e-6));
    }

    /** Ground of thousands of triangles, and a slope, turned about the vertical: the same as one square. */
    @ParameterizedTest
    @CsvSource({"0, 0, 0", "0, 0.3, 0", "0.05, 1.1, 0.4", "0.3, 2.5, -0.9", "-0.2, 4, 2"})
    void theGroundMayBeDividedTurnedAndSloped(double slope, double turn, double across) {
        double[] level = gains(COHERENT, Sites.world(Sites.square(1000, 0), GRASS), SOURCE, SENSOR);
        // A plane of some slope towards a direction; both points stand on its normals.
        double east = slope * Math.cos(across);
        double north = slope * Math.sin(across);
        World slopeSite = Sites.world(Sites.terrain(160, 4, (x, y) -> east * x + north * y), GRASS);
        Position normal = new Position(-east, -north, 1).unit();
        Position along =
                new Position(Math.cos(turn), Math.sin(turn), east * Math.cos(turn) + north * Math.sin(turn)).unit();
        Position source = along.times(-50).plus(normal.times(2));
        Position sensor = along.times(50).plus(normal.times(1.5));

        assertThat(gains(COHERENT, slopeSite, source, sensor)).containsExactly(level, within(2e-3));
    }

    /** Bumps of centimetres, far below the wavelength over the grazing angle: no more than a few tenths. */
    @Test
    void smallBumpsHardlyMatter() {
        double[] level = gains(COHERENT, Sites.world(Sites.square(1000, 0), GRASS), SOURCE, SENSOR);
        SplittableRandom random = new SplittableRandom(7);
        World bumpy = Sites.world(Sites.terrain(100, 2, (x, y) -> random.nextDouble(-0.02, 0.02)), GRASS);
        double[] over =
                gains(COHERENT, bumpy, SOURCE.plus(new Position(-50, 1, 0)), SENSOR.plus(new Position(-50, 1, 0)));
        for (int band = 0; band < 6; band++) {
            assertThat(over[band]).as("seed 7, band %d", band).isCloseTo(level[band], within(0.5));
        }
    }

    /**
     * A scene's own surface, whatever its name and absorption: the same as the table's of the same flow resistivity.
     */
    @Test
    void aSceneMayStateTheFlowResistivity() {
        OwnSurface own =
                OwnSurface.absorbing(0.3).withScattering(BandFractions.flat(0)).withFlowResistivity(200);
        double[] gains = gains(COHERENT, Sites.world(Sites.square(1000, 0), own.material("meadow")), SOURCE, SENSOR);
        for (int band = 0; band < gains.length; band++) {
            assertThat(gains[band]).as("band %d", band).isCloseTo(OVER_GRASS[band], within(0.06));
        }
        SurfaceMaterial hard = own.withFlowResistivity(1e6).material("grass_50mm");
        assertThat(gains(COHERENT, Sites.world(Sites.square(1000, 0), hard), SOURCE, SENSOR)[3])
                .isGreaterThan(5);
    }

    /** Both ends exchanged, on hilly ground: the same gains. */
    @Thorough
    @Test
    void hearingIsReciprocal() {
        DoubleBinaryOperator height = (x, y) -> 3 * Math.sin(x / 60) * Math.cos(y / 45) + 0.02 * x;
        World hills = Sites.world(Sites.terrain(200, 5, height), GRASS);
        SplittableRandom random = new SplittableRandom(23);
        int differ = 0;
        for (int i = 0; i < 100; i++) {
            Position a = above(height, random, 2, 40);
            Position b = above(height, random, 1, 6);
            double[] there = gains(COHERENT, hills, a, b);
            assertThat(gains(COHERENT, hills, b, a)).as("seed 23, pair %d", i).containsExactly(there, within(1e-3));
            double[] energies = gains(INCOHERENT, hills, a, b);
            differ += Math.abs(there[2] - energies[2]) > 0.5 ? 1 : 0;
        }
        assertThat(differ).as("pairs in which ground interferes").isGreaterThan(70);
    }

    private static Position above(DoubleBinaryOperator height, SplittableRandom random, double low, double high) {
        double x = random.nextDouble(-150, 150);
        double y = random.nextDouble(-150, 150);
        return new Position(x, y, height.applyAsDouble(x, y) + random.nextDouble(low, high));
    }

    /** Facets of terrain have gaps between the mirror images of neighbours; the plane through many of them has none. */
    @Test
    void overTerrainLevelsDoNotJump() {
        DoubleBinaryOperator height = (x, y) -> 3 * Math.sin(x / 60) * Math.cos(y / 45) + 0.02 * x;
        World hills = Sites.world(Sites.terrain(250, 5, height), GRASS);
        Position sensor = new Position(0, 0, height.applyAsDouble(0, 0) + 1.5);
        double[] before = null;
        for (double d = 100; d <= 240; d++) {
            double x = 0.8 * d;
            double y = 0.6 * d;
            double[] gains = gains(COHERENT, hills, new Position(x, y, height.applyAsDouble(x, y) + 20), sensor);
            for (int band = 0; band < 4 && before != null; band++) {
                assertThat(gains[band]).as("%f m, band %d", d, band).isCloseTo(before[band], within(0.15));
            }
            before = gains;
        }
    }

    @Test
    void highAboveHardGroundEnergiesAdd() {
        World plain = Sites.world(Sites.square(3000, 0), RIGID);
        Position source = new Position(0, 0, 400);
        Position sensor = new Position(30, 0, 60);
        double[] energies = gains(INCOHERENT, plain, source, sensor);
        double[] gains = gains(COHERENT, plain, source, sensor);
        for (int band = 3; band < gains.length; band++) {
            assertThat(gains[band]).as("band %d", band).isCloseTo(energies[band], within(0.1));
        }
    }

    /** A microphone that lies on hard ground, or a drone that does: 6 dB in every band, turbulent air or not. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-4})
    void onHardGroundPressureDoubles(double turbulence) {
        World plain = Sites.world(Sites.square(500, 0), RIGID);
        EnergyModel model = COHERENT.withTurbulence(turbulence);
        for (Position drone : List.of(new Position(0, 0, 10), new Position(30, 20, 15), new Position(200, 0, 3))) {
            Position plate = new Position(3, 1, 0);
            for (double gain : gains(model, plain, drone, plate)) {
                assertThat(gain).isCloseTo(20 * Math.log10(2), within(2e-3));
            }
            for (double gain : gains(model, plain, plate, drone)) {
                assertThat(gain).isCloseTo(20 * Math.log10(2), within(2e-3));
            }
        }
    }

    /** A plate of 40 cm, 5 cm above grass, reflects to the microphone on it, and the grass around does not. */
    @Test
    void aPlateIsTheGroundOfTheMicrophoneOnIt() {
        TriangleMesh grass = of("grass_50mm", Sites.square(300, 0));
        TriangleMesh plate = of("perfect_mirror", Sites.wall(2, 0.05, -0.2, 0.2, -0.2, 0.2));
        TriangleMesh both = World.merge(List.of(grass, plate));
        World site = new World(KDTree.of(both), BackgroundNoise.of(20), List.of(GRASS, RIGID), Atmosphere.STANDARD);
        double[] gains = gains(COHERENT, site, new Position(5, 3, 10), new Position(0, 0, 0.05));
        for (double gain : gains) {
            assertThat(gain).isCloseTo(6.02, within(0.01));
        }
    }

    /** Rotors are fainter in their plane: each path has its own elevation. */
    @Test
    void eachPathHasItsOwnDirection() {
        World plain = Sites.world(Sites.square(500, 0), RIGID);
        Position source = new Position(0, 0, 20);
        Position sensor = new Position(20, 0, 20);
        int band = OctaveBands.ONE_KILOHERTZ;
        EnergyReading heard = Sites.read(COHERENT, plain, Sites.sound(source, band, Directivity.ROTOR), sensor, 1);
        EnergyReading even = Sites.read(COHERENT, Sites.open(), Sites.sound(source, band), sensor, 1);
        double direct = Levels.toRatio(Directivity.ROTOR.index(band, 0));
        double length = Math.hypot(20, 40);
        double air = 10 * Math.log10(even.direct().get(band)) + Levels.sphericalSpreading(20) - Sites.LW;
        double reflected = Levels.toRatio(Directivity.ROTOR.index(band, Math.atan2(40, 20)))
                * Math.pow(20 / length, 2)
                * Levels.toRatio(air * (length - 20) / 20);
        double expected = new GroundInterference(
                        GroundImpedance.RIGID, 343.2, 20, length, 20, 20, 0, new TurbulentCoherence(0, 1))
                .inBand(band, direct, reflected);
        assertThat(heard.level(band) - even.level(band)).isCloseTo(Levels.ofRatio(expected), within(1e-3));
    }

    /**
     * In a room other reflections outweigh; on a street between two walls, too. Their levels are those without phases.
     */
    @Test
    void whereWallsDominateEnergiesAdd() {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("concrete_smooth", 0.05, 0));
        Position source = new Position(2, 3, 1.5);
        Position sensor = new Position(8, 6, 1.2);
        assertThat(gains(COHERENT, room, source, sensor))
                .containsExactly(gains(INCOHERENT, room, source, sensor), within(1e-9));

        TriangleMesh street = World.merge(
                List.of(Sites.square(300, 0), Sites.wall(1, -6, 0, 20, -300, 300), Sites.wall(1, 6, 0, 20, -300, 300)));
        World canyon = Sites.world(street, SurfaceMaterial.uniform("concrete_smooth", 0.05, 0));
        assertThat(gains(COHERENT, canyon, new Position(0, 0, 3), new Position(50, 0, 1.5)))
                .containsExactly(
                        gains(INCOHERENT, canyon, new Position(0, 0, 3), new Position(50, 0, 1.5)), within(1e-9));
        // Beside one wall, ground and direct sound are still the strongest.
        World facade =
                Sites.world(World.merge(List.of(Sites.square(300, 0), Sites.wall(1, 30, 0, 20, -300, 300))), RIGID);
        assertThat(gains(COHERENT, facade, new Position(0, 0, 3), new Position(50, 0, 1.5))[0])
                .isGreaterThan(gains(INCOHERENT, facade, new Position(0, 0, 3), new Position(50, 0, 1.5))[0] + 1.5);
    }

    /** Where the drone is hidden, or flies over water that is not in the model, nothing changes. */
    @Test
    void withoutDirectSoundOrGroundEnergiesAdd() {
        World wall = Sites.world(World.merge(List.of(Sites.square(300, 0), Sites.wall(0, 50, -100, 100, 0, 6))), RIGID);
        assertThat(gains(COHERENT, wall, SOURCE, SENSOR)).containsExactly(gains(INCOHERENT, wall, SOURCE, SENSOR));
        World nothing = Sites.open();
        assertThat(gains(COHERENT, nothing, SOURCE, SENSOR)).containsExactly(new double[8], within(1e-9));
    }

    /**
     * A DJI Matrice 300 in flight 10 m above a microphone on a ground plate. Straight below it the octave bands have
     * these levels at 1 m, together 84.8 dB(A) (Ramos-Romero and others, Aerospace Science and Technology 140, 108537,
     * 2023): 20 dB less for the distance and 6 dB more on the plate are 70.8 dB(A).
     */
    @Test
    void aFlightOverAPlateIsPredictedToADecibel() {
        double[] atOneMetre = {69.3, 75.6, 77.5, 77.5, 78.7, 79.6, 77.6, 68.2};
        List<Double> power = Arrays.stream(atOneMetre)
                .mapToObj(level -> level + Levels.sphericalSpreading(1))
                .toList();
        World field = Sites.world(Sites.square(300, 0), SurfaceMaterials.get("asphalt"));
        SoundSource drone = new SoundSource(new Position(0, 0, 10), power, Directivity.OMNIDIRECTIONAL);
        Position plate = new Position(0, 0, 0);
        assertThat(Sites.read(COHERENT.withRays(5000), field, drone, plate, 1).aWeightedLevel())
                .isCloseTo(70.8, within(1.0));
        assertThat(Sites.read(INCOHERENT.withRays(5000), field, drone, plate, 1).aWeightedLevel())
                .as("energies alone")
                .isLessThan(69);
    }

    /** Rough ground scatters what comes from above, and mirrors what grazes it. */
    @Test
    void whatIsScatteredDoesNotInterfere() {
        SurfaceMaterial rough = SurfaceMaterial.uniform("perfect_mirror", 0, 0.5);
        EnergyModel few = COHERENT.withRays(1);
        World plain = Sites.world(Sites.square(1000, 0), rough);
        double direct = Sites.read(few, plain, Sites.sound(new Position(0, 0, 10), 0), new Position(0, 0, 0), 1)
                .direct()
                .get(0);
        double open = Sites.read(few, Sites.open(), Sites.sound(new Position(0, 0, 10), 0), new Position(0, 0, 0), 1)
                .direct()
                .get(0);
        assertThat(direct / open).isCloseTo(Math.pow(1 + Math.sqrt(0.5), 2), within(1e-3));
        double grazing = Sites.read(few, plain, Sites.sound(SOURCE, 0), SENSOR, 1)
                .direct()
                .get(0);
        double smooth = Sites.read(few, Sites.world(Sites.square(1000, 0), RIGID), Sites.sound(SOURCE, 0), SENSOR, 1)
                .direct()
                .get(0);
        assertThat(grazing / smooth).isCloseTo(1.0, within(2e-3));
    }

    /**
     * On a round hill of 150 m radius, a microphone at 4 m hears a drone 40 m over it, from one slope or the other: the
     * plane that touches the hill reflects along the shortest path over it, found here by brute force.
     */
    @ParameterizedTest
    @CsvSource({"10, 40", "60, 45", "-120, 60", "200, 60", "-400, 90"})
    void aHillReflectsWhereThePathIsShortest(double x, double height) {
        double radius = 150;
        DoubleBinaryOperator hill = (u, v) -> Math.sqrt(radius * radius - Math.min(u * u, 140 * 140)) - radius;
        GroundPlane plane = new GroundPlane(Sites.world(Sites.terrain(140, 2, hill), GRASS));
        Position drone = new Position(x, 3, height);
        Position microphone = new Position(1, 3, 4);

        assertThat(plane.find(drone, microphone, 0.686, 0)).isTrue();
        double shortest = Double.POSITIVE_INFINITY;
        for (double u = -130; u <= 130; u += 0.01) {
            Position at = new Position(u, 3, hill.applyAsDouble(u, 0));
            shortest = Math.min(shortest, drone.distance(at) + at.distance(microphone));
        }
        // The facets of 2 m lie up to 3 mm under the hill.
        assertThat(plane.length()).isCloseTo(shortest, within(0.02));
        assertThat(plane.unevenness()).isLessThan(0.02);
    }

    /** A step of 3 m in the Fresnel zone leaves the sum of energies. */
    @Test
    void brokenGroundReflectsOutOfStep() {
        World terrace = Sites.world(
                Sites.terrain(80, 1, (x, y) -> x < 22 ? 0 : 3), SurfaceMaterial.uniform("perfect_mirror", 0, 0));
        Position source = new Position(-10, 0, 14);
        Position sensor = new Position(54, 0, 17);
        double[] gains = gains(COHERENT, terrace, source, sensor);
        for (int band = 3; band < gains.length; band++) {
            assertThat(gains[band]).as("band %d", band).isBetween(2.0, 3.1);
        }
    }
}
