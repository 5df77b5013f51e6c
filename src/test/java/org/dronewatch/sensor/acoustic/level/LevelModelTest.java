package org.dronewatch.sensor.acoustic.level;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.buildings.land.LandClass;
import org.dronewatch.buildings.land.LandRaster;
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
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.acoustic.AcousticSensor;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.world.SurfaceSettings;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;

class LevelModelTest {
    private static final double QUIET = 20.0;
    private static final LevelModel TEN = LevelModel.DEFAULT;

    /** A square in a plane of constant x, y or z. */
    private static TriangleMesh wall(int axis, double at, double half) {
        float[] vertices = new float[12];
        double[][] corners = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
        for (int i = 0; i < 4; i++) {
            vertices[3 * i + axis] = (float) at;
            vertices[3 * i + (axis + 1) % 3] = (float) corners[i][0];
            vertices[3 * i + (axis + 2) % 3] = (float) corners[i][1];
        }
        return TriangleMesh.of(vertices, new int[] {0, 1, 2, 0, 2, 3});
    }

    private static World world(TriangleMesh... meshes) {
        return new World(
                KDTree.of(World.merge(List.of(meshes))),
                BackgroundNoise.of(QUIET),
                SurfaceSettings.DEFAULT,
                Atmosphere.STANDARD);
    }

    private static World farGround() {
        return world(wall(2, -5000, 1));
    }

    private static World room() {
        return world(wall(0, -6, 6), wall(0, 6, 6), wall(1, -6, 6), wall(1, 6, 6), wall(2, -6, 6), wall(2, 6, 6));
    }

    private static Drone drone(double level, Position place) {
        DroneSettings settings = DroneSettings.of(ModelSettings.of("none.obj"), new Hover(place, 0.0))
                .withSoundLevel(level);
        TriangleMesh any = TriangleMesh.of(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
        Vector3d move = place.toVector3d();
        return new Drone("drone", settings, KDTree.of(any)).move(move);
    }

    private static AcousticSensor sensor(LevelModel model) {
        return AcousticSettings.at(new Position(0, 0, 0)).withPropagation(model).create();
    }

    private static LevelReading fully(World world, Drone drone, LevelModel model) {
        return sensor(model).listenFully(world, drone, new SplittableRandom(1), RayRecorder.NONE);
    }

    @Test
    void inTheOpenTheLevelFallsByTheAirOnlyAtTheWayToTheCentre() {
        for (double range : new double[] {1, 10, 123.4, 400}) {
            LevelReading heard = fully(farGround(), drone(55, new Position(0, range, 0)), TEN);
            assertThat(heard.bestLevel()).isCloseTo(55 - 0.05 * range, within(1e-9));
            assertThat(heard.received()).isPositive();
        }
    }

    /** Sources about the threshold, so that some looks detect and some do not. */
    @Test
    void fastAndThoroughLooksDetectTheSameAndOnlyThoroughOnesGiveTheEnergy() {
        World room = room();
        AcousticSensor fast = sensor(TEN);
        AcousticSensor thorough = sensor(TEN.withListening(Listening.THOROUGH));
        int detections = 0;
        int looks = 0;
        for (long seed = 0; seed < 40; seed++) {
            for (double level : new double[] {QUIET + 14.9, QUIET + 15.1, QUIET + 20}) {
                List<Drone> drones = List.of(drone(level, new Position(3, 1, -2)));
                Look look = Look.of(seed, "ear", 0, 10.0);
                Observation quick = fast.observe(room, drones, look).get(0);
                Observation whole = thorough.observe(room, drones, look).get(0);
                assertThat(whole.isDetected()).as("seed %d", seed).isEqualTo(quick.isDetected());
                assertThat(whole.value()).isGreaterThanOrEqualTo(quick.value());
                assertThat(whole.figures().get("rays_traced"))
                        .isGreaterThanOrEqualTo(quick.figures().get("rays_traced"));
                assertThat(quick.figures()).doesNotContainKey("cumulated_energy");
                LevelReading same = thorough.listenFully(
                        room, drones.get(0), look.random("drone", RaySensor.RAYS), RayRecorder.NONE);
                assertThat(whole.figures()).containsEntry("cumulated_energy", same.energy());
                detections += quick.isDetected() ? 1 : 0;
                looks++;
            }
        }
        assertThat(detections).isBetween(1, looks - 1);
    }

    @Test
    void theRangeIsTheMarginOverTheLossInTheAir() {
        World open = farGround();
        double range = (55 - QUIET - 15) / 0.05;
        assertThat(fully(open, drone(55, new Position(range - 0.01, 0, 0)), TEN).detected())
                .isTrue();
        assertThat(fully(open, drone(55, new Position(range + 0.01, 0, 0)), TEN).detected())
                .isFalse();
    }

    /** Ground that is covered reflects like ground that is made of what covers it. */
    @Test
    void aWoodOnTheGroundTakesItsSound() {
        TriangleMesh floor = wall(2, -2, 100);
        World rock = World.of(named("perfect_mirror", floor));
        World covered = rock.withLandCover(
                new LandRaster(100.0, 1, new byte[] {(byte) LandClass.WOOD.code()}), SurfaceSettings.DEFAULT);
        Drone drone = drone(80, new Position(0, 30, 1));
        LevelModel model = TEN.withRays(2000, 4);
        double overWood =
                fully(World.of(named("forest_floor", floor)), drone, model).energy();
        assertThat(fully(covered, drone, model).energy()).isEqualTo(overWood);
        assertThat(fully(rock, drone, model).energy()).isGreaterThan(1.05 * overWood);
    }

    private static TriangleMesh named(String material, TriangleMesh mesh) {
        return new TriangleMesh(mesh.vertices(), mesh.corners(), new int[2], new int[2], List.of(material));
    }

    @Test
    void listenAndListenFullyAgreeOnDetection() {
        World room = room();
        SplittableRandom places = new SplittableRandom(3);
        int heard = 0;
        for (int i = 0; i < 200; i++) {
            Position place = new Position(
                    10 * places.nextDouble() - 5, 10 * places.nextDouble() - 5, 10 * places.nextDouble() - 5);
            Drone drone = drone(33 + 4 * places.nextDouble(), place);
            AcousticSensor sensor = sensor(TEN);
            boolean quick = sensor.listen(room, drone, new SplittableRandom(i)).detected();
            boolean full = sensor.listenFully(room, drone, new SplittableRandom(i), RayRecorder.NONE)
                    .detected();
            assertThat(quick).as("seed %d", i).isEqualTo(full);
            heard += quick ? 1 : 0;
        }
        assertThat(heard).isBetween(20, 180);
    }

    /** Behind a wall, over a second one: the forced ray must find the way that the mirror image gives. */
    @Test
    void aWallHidesAndAReflectionReveals() {
        World hidden = world(wall(1, 10, 3));
        Drone behind = drone(55, new Position(0, 20, 0));
        assertThat(fully(hidden, behind, TEN).received()).isZero();

        World revealed = world(wall(1, 10, 3), wall(0, 15, 40));
        LevelReading heard = fully(revealed, behind, TEN.withRays(300, 10));
        double mirrored = Math.hypot(30, 20);
        double loss = -10 * Math.log10(1 - alpha(revealed));
        assertThat(heard.bestLevel()).isLessThanOrEqualTo(55 - loss - 0.05 * mirrored + 1e-9);
        assertThat(heard.bestLevel()).isGreaterThan(55 - loss - 0.05 * (mirrored + 10));
    }

    private static double alpha(World world) {
        return 1.0 - Math.pow(10.0, -0.1 * new SurfaceLevels(world).reflectionLoss(0, 1.0));
    }

    /**
     * With k rays a hit and n initial ones, order o of a closed room holds n k^o pieces, forced and dropped ones apart.
     */
    @Test
    void whatIsCutIsCountedByOrder() {
        Drone drone = drone(90, new Position(3, 2, 1));
        LevelReading all =
                fully(room(), drone, LevelModel.DEFAULT.withRays(5, 4).withLimits(2, 1_000_000));
        LevelReading cut =
                fully(room(), drone, LevelModel.DEFAULT.withRays(5, 4).withLimits(2, 30));

        assertThat(all.cutByBudget()).isZero();
        assertThat(all.cutByOrder()).isPositive();
        assertThat(all.traced()).isLessThanOrEqualTo(6 + 6 * 4 + 6 * 16);
        assertThat(cut.traced()).isEqualTo(30);
        assertThat(cut.cutByBudget()).isPositive();
        assertThat(cut.cutOrder()).hasValue(2);
    }

    @Test
    void moreAbsorptionDistanceOrNoiseNeverMakesItLouder() {
        World room = room();
        double before = Double.POSITIVE_INFINITY;
        for (double attenuation : new double[] {0, 0.01, 0.1, 1}) {
            double level = fully(room, drone(60, new Position(4, 3, 2)), TEN.withAttenuation(attenuation))
                    .bestLevel();
            assertThat(level).isLessThan(before);
            before = level;
        }
    }

    @Test
    void everyPieceThatIsTracedIsRecorded() {
        List<double[]> pieces = new ArrayList<>();
        LevelReading heard = sensor(TEN)
                .listenFully(
                        room(),
                        drone(50, new Position(4, 3, 2)),
                        new SplittableRandom(5),
                        (x, y, z, u, v, w, level, order, received) ->
                                pieces.add(new double[] {x, y, z, u, v, w, level, order, received ? 1 : 0}));

        assertThat(pieces).hasSize((int) heard.traced());
        assertThat(pieces.stream().filter(piece -> piece[8] > 0)).hasSize((int) heard.received());
        for (double[] piece : pieces) {
            for (int k = 0; k < 6; k++) {
                assertThat(Math.abs(piece[k])).as("inside the room").isLessThan(6.0 + 1e-6);
            }
            assertThat(piece[7]).isBetween(0.0, (double) TEN.maxOrder());
        }
    }

    @Test
    void theSameRandomNumbersGiveTheSame() {
        Drone drone = drone(50, new Position(4, 3, 2));
        assertThat(fully(room(), drone, TEN)).isEqualTo(fully(room(), drone, TEN));
    }

    /** With enough rays for many chunks, with and without an early end, and with the budget used up on the way. */
    @Test
    void theSameForAnyNumberOfThreads() {
        World room = room();
        Drone drone = drone(50, new Position(4, 3, 2));
        AcousticSensor sensor = AcousticSettings.at(new Position(0, 0, 0))
                .withPropagation(LevelModel.DEFAULT.withRays(40, 20).withLimits(3, 7_000))
                .create();
        LevelReading alone = sensor.listenFully(room, drone, new SplittableRandom(9), RayRecorder.NONE);
        LevelReading soon = sensor.listen(room, drone, new SplittableRandom(9));
        for (int threads = 1; threads <= 3; threads++) {
            try (Workers workers = new Workers(threads)) {
                assertThat(workers.call(
                                () -> sensor.listenFully(room, drone, new SplittableRandom(9), RayRecorder.NONE)))
                        .as("%d threads", threads)
                        .isEqualTo(alone);
                assertThat(workers.call(() -> sensor.listen(room, drone, new SplittableRandom(9))))
                        .as("%d threads", threads)
                        .isEqualTo(soon);
            }
        }
        assertThat(alone.traced()).isEqualTo(7_000);
        assertThat(alone.cutByBudget()).isPositive();
    }

    @Test
    void settingsHaveLimits() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> TEN.withRays(0, 10))
                .withMessageContaining("initialRays 0");
        assertThatIllegalArgumentException().isThrownBy(() -> TEN.withAttenuation(-0.1));
        assertThatIllegalArgumentException().isThrownBy(() -> TEN.withLimits(3, 0));
        AcousticSettings settings = AcousticSettings.at(new Position(0, 0, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> settings.withRadius(0.0));
        assertThatIllegalArgumentException().isThrownBy(() -> settings.withArrayGain(-1.0));
    }
}
