package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;
import static org.dronewatch.sensor.acoustic.energy.Sites.LOWEST;
import static org.dronewatch.sensor.acoustic.energy.Sites.LW;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterials;
import org.dronewatch.world.Clearance;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Microphones and drones that lie on a surface hear and are heard as just before it. */
class SurfaceContactTest {
    private static final SurfaceMaterial RIGID = SurfaceMaterial.uniform("rigid", 0, 0);
    private static final SurfaceMaterial ROUGH = SurfaceMaterial.uniform("rough", 0.2, 0.6);
    private static final EnergyModel MODEL = EnergyModel.DEFAULT.withRays(4000).withAccuracy(0.0);
    private static final Position GROUND = new Position(3, 5, 0);
    private static final Position ABOVE = new Position(30, 0, 20);
    private static final long SEED = 20261126;
    private static final double TWICE = 10 * Math.log10(2);

    private static double level(World world, Position source, Position sensor) {
        return read(world, source, sensor).totalLevel();
    }

    private static EnergyReading read(World world, Position source, Position sensor) {
        return Sites.read(MODEL, world, Sites.sound(source, LOWEST), sensor, 250);
    }

    /** On rigid ground the mirror image is where the source is: twice the energy, either way round. */
    @Test
    void onRigidGroundThereIsTwiceTheEnergy() {
        World ground = Sites.world(Sites.square(500, 0), RIGID);
        double alone = level(Sites.open(), ABOVE, GROUND);
        assertThat(level(ground, ABOVE, GROUND)).as("the microphone lies there").isCloseTo(alone + TWICE, within(1e-3));
        assertThat(level(ground, GROUND, ABOVE)).as("the drone stands there").isCloseTo(alone + TWICE, within(1e-3));
    }

    /** Three rigid walls: eight sources in one place. */
    @Test
    void inACornerThereIsEightTimesTheEnergy() {
        World corner = Sites.world(
                World.merge(List.of(
                        Sites.wall(0, 0, 0, 500, 0, 500),
                        Sites.wall(1, 0, 0, 500, 0, 500),
                        Sites.wall(2, 0, 0, 500, 0, 500))),
                RIGID);
        Position source = new Position(20, 31, 12);
        Position sensor = new Position(0, 0, 0);
        assertThat(level(corner, source, sensor))
                .isCloseTo(level(Sites.open(), source, sensor) + 3 * TWICE, within(1e-3));
    }

    @Test
    void onGroundThatScattersItIsAsJustAbove() {
        World ground = Sites.world(Sites.square(500, 0), ROUGH);
        Position above = new Position(GROUND.x(), GROUND.y(), 0.001);
        assertThat(level(ground, ABOVE, GROUND)).as("microphone").isCloseTo(level(ground, ABOVE, above), within(0.05));
        assertThat(level(ground, GROUND, ABOVE)).as("drone").isCloseTo(level(ground, above, ABOVE), within(0.05));
    }

    /**
     * Half of the power of a drone on a floor meets the floor where it stands. From there a part goes to the image,
     * which is where the drone is, and a part by Lambert's law: {@code 1 + r (1 - s) + 2 r s cos t} times the direct
     * energy, t from the normal. The same for a microphone on the floor.
     */
    @ParameterizedTest
    @CsvSource({"solid", "limestone", "full"})
    void onAFloorThatScattersTheEnergyIsThatOfTheContact(String name) {
        SurfaceMaterial floor =
                name.equals("full") ? SurfaceMaterial.uniform(name, 0.1, 1) : SurfaceMaterials.get(name);
        World ground = Sites.world(Sites.square(500, 0), floor);
        double reflected = floor.reflected(LOWEST);
        double scattered = floor.scattering().get(LOWEST);
        double cosine = ABOVE.z() / ABOVE.distance(GROUND);
        double gain = 10 * Math.log10(1 + reflected * (1 - scattered) + 2 * reflected * scattered * cosine);
        double alone = level(Sites.open(), ABOVE, GROUND);
        for (EnergyReading reading : List.of(read(ground, ABOVE, GROUND), read(ground, GROUND, ABOVE))) {
            assertThat(reading.standardError()).isLessThan(0.05);
            assertThat(reading.totalLevel() - alone)
                    .as("standard error %.3f dB", reading.standardError())
                    .isCloseTo(gain, within(4 * reading.standardError() + 1e-3));
        }
    }

    /** Surfaces of two materials in one plane, as gravel that is flush with its roof: one counts, both ways. */
    @Test
    void ofTwoSurfacesUponEachOtherOneReflectsEitherWay() {
        SurfaceMaterial slab = SurfaceMaterial.uniform("slab", 0.1, 0);
        SurfaceMaterial gravel = SurfaceMaterial.uniform("gravel", 0.6, 0);
        World roof = Sites.world(
                List.of(Sites.square(50, 141.6), Sites.wall(2, 141.6, -11, 13, -9, 17)), List.of(slab, gravel));
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < 60; i++) {
            Position one = above(random);
            Position other = above(random);
            assertThat(read(roof, other, one).mirrored().get(LOWEST))
                    .as("pair %d of seed %d", i, SEED)
                    .isCloseTo(read(roof, one, other).mirrored().get(LOWEST), withinPercentage(1e-6));
        }
    }

    private static Position above(SplittableRandom random) {
        return new Position(random.nextDouble(-9, 9), random.nextDouble(-7, 7), 141.6 + random.nextDouble(1, 20));
    }

    @Test
    void aDroneAtTheMicrophoneIsNoLouderThanAtItsOwnRadius() {
        double near = level(Sites.open(), ABOVE, new Position(30, 0.1, 20));
        assertThat(near).isCloseTo(LW - 10 * Math.log10(4 * Math.PI * 0.01), within(0.01));
        assertThat(level(Sites.open(), ABOVE, ABOVE)).isCloseTo(near, within(0.01));
    }

    @Test
    void placesOffSurfacesStayWhereTheyAre() {
        Clearance clearance = new Clearance(Sites.world(Sites.square(500, 0), RIGID));
        for (double z : new double[] {1.0, 1e-3, Clearance.GAP, -Clearance.GAP, -1.0}) {
            Position place = new Position(3, 5, z);
            assertThat(clearance.of(place)).isSameAs(place);
        }
        assertThat(clearance.of(GROUND)).isEqualTo(new Position(3, 5, Clearance.GAP));
        assertThat(clearance.of(new Position(3, 5, -1e-5)).z()).isCloseTo(Clearance.GAP, within(1e-12));
    }

    @Test
    void placesNearSurfacesAreKeptApartOnTheSameSide() {
        World corner = Sites.world(
                World.merge(List.of(Sites.square(500, 0), Sites.wall(0, -2, -9, 9, 0, 9), Sites.square(1, 0.04))),
                RIGID);
        Clearance clearance = new Clearance(corner);
        assertThat(clearance.apart(new Position(3, 5, 0.002), 0.05)).isEqualTo(new Position(3, 5, 0.05));
        assertThat(clearance.apart(new Position(3, 5, -0.002), 0.05)).isEqualTo(new Position(3, 5, -0.05));
        assertThat(clearance.apart(new Position(-2.01, 5, 0.03), 0.05)).isEqualTo(new Position(-2.05, 5, 0.05));
        Position far = new Position(3, 5, 0.05);
        assertThat(clearance.apart(far, 0.05)).isSameAs(far);
        Position underPlate = new Position(0.5, 0.5, 0.01);
        assertThat(clearance.apart(underPlate, 0.05))
                .as("a plate 4 cm above the ground")
                .isSameAs(underPlate);
    }

    /**
     * A box of outward triangles: what lies on its walls, edges and corners is put just outside, and hears nothing of a
     * drone inside, though every wall is within rounding of it.
     */
    @ParameterizedTest
    @CsvSource({"3, 3, 0", "10, 8, 4", "0, 4, 2", "0, 4, 0", "0, 0, 0", "10, 0, 0", "5e-5, 5e-5, 5e-5"})
    void aSealedBoxDoesNotLeakIntoItsOwnSurface(double x, double y, double z) {
        World box = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.1, 0.3));
        Position on = new Position(x, y, z);
        Position inside = new Position(7, 5, 2);
        assertThat(broadbandLevel(box, inside, on)).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(broadbandLevel(box, on, inside)).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(broadbandLevel(box, inside, new Position(1e-3, 1e-3, 1e-3)))
                .as("inside")
                .isGreaterThan(90.0);
    }

    /**
     * A house without openings on the ground, and a drone where one or more of its walls mirror the microphone: then
     * paths are reflected exactly in edges and corners of the house, which other walls close.
     */
    @ParameterizedTest
    @CsvSource({
        "5, 4, 1.5",
        "7, 4, 2",
        "9, 4, 1.5",
        "9.99, 4, 1.5",
        "7, 5, 2",
        "8, 6, 3",
        "9.5, 7.5, 3.5",
        "9.9, 7.9, 0.1"
    })
    void aSealedHouseDoesNotLeakToWhereItsWallsMirror(double x, double y, double z) {
        World house = Sites.world(
                List.of(Sites.square(100, 0), Sites.box(0, 0, 0, 10, 8, 4)),
                List.of(RIGID, SurfaceMaterial.uniform("wall", 0.1, 0.3)));
        Position inside = new Position(x, y, z);
        for (int mirrors = 1; mirrors < 8; mirrors++) {
            Position outside = new Position(
                    (mirrors & 1) == 0 ? x : 20 - x, (mirrors & 2) == 0 ? y : 16 - y, (mirrors & 4) == 0 ? z : 8 - z);
            assertThat(exactLevel(house, inside, outside)).as("to %s", outside).isEqualTo(Double.NEGATIVE_INFINITY);
            assertThat(exactLevel(house, outside, inside))
                    .as("from %s", outside)
                    .isEqualTo(Double.NEGATIVE_INFINITY);
        }
        assertThat(exactLevel(house, inside, new Position(5, 4, 2)))
                .as("inside")
                .isGreaterThan(80.0);
    }

    private static double exactLevel(World world, Position drone, Position microphone) {
        return new EnergyTracer(EnergyModel.DEFAULT, microphone, 0.5, world)
                .onExactPaths(Sites.broadband(drone))
                .totalLevel();
    }

    private static double broadbandLevel(World world, Position drone, Position microphone) {
        return new EnergyTracer(EnergyModel.DEFAULT, microphone, 0.5, world)
                .trace(Sites.broadband(drone), new SplittableRandom(1), RayRecorder.NONE)
                .totalLevel();
    }

    /** Walls that reach into the ground, far from the origin and in any attitude, where coordinates are rounded. */
    @Test
    void inNoAttitudeDoesSoundLeakOutOfASealedHouse() {
        TriangleMesh house = World.merge(List.of(
                Sites.square(100, 0),
                Sites.wall(0, 0, 0, 5, -0.5, 3),
                Sites.wall(0, 6, 0, 5, -0.5, 3),
                Sites.wall(1, 0, -0.5, 3, 0, 6),
                Sites.wall(1, 5, -0.5, 3, 0, 6),
                Sites.wall(2, 3, 0, 6, 0, 5)));
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < LongForm.count(12, 100); i++) {
            UnaryOperator<Position> turned = Sites.attitude(random);
            Position away = new Position(random.nextDouble(-100, 100), random.nextDouble(-100, 100), 20);
            UnaryOperator<Position> by = place -> turned.apply(place).plus(away);
            World site = Sites.world(Sites.turned(house, by), SurfaceMaterial.uniform("wall", 0.1, 0.2));
            Position inside = by.apply(new Position(3, 2, 1));
            for (double off : new double[] {2e-4, 1e-3, 1e-2}) {
                for (double height : new double[] {0, 1e-3, 1}) {
                    Position outside = by.apply(new Position(3, -off, height));
                    assertThat(broadbandLevel(site, inside, outside))
                            .as("%s m off the wall and %s m high, attitude %d of seed %d", off, height, i, SEED)
                            .isEqualTo(Double.NEGATIVE_INFINITY);
                    assertThat(broadbandLevel(site, outside, inside))
                            .as("%s m off the wall and %s m high, attitude %d of seed %d", off, height, i, SEED)
                            .isEqualTo(Double.NEGATIVE_INFINITY);
                }
            }
        }
    }
}
