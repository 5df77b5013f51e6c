package org.dronewatch.sensor.thermal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.HeatSignature;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.AssessmentBounds;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Discrimination;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.ProbabilityResolution;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.VisibleArea;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ThermalSensorTest {
    private static final Position CAMERA = new Position(0, 0, 50);
    private static final Position REST = new Position(0, 0, 0);

    /** A plate that faces south, of a width and height in metres. */
    private static TriangleMesh plate(double width, double height, double north) {
        float w = (float) (0.5 * width);
        float h = (float) (0.5 * height);
        float y = (float) north;
        return new TriangleMesh(
                new float[] {-w, y, -h, w, y, -h, w, y, h, -w, y, h},
                new int[] {0, 1, 2, 0, 2, 3},
                new int[2],
                new int[] {0, 1},
                List.of("plate"));
    }

    private static World empty() {
        return World.of(new TriangleMesh(
                new float[] {-9, -9, -9, 9, -9, -9, 9, 9, -9},
                new int[] {0, 1, 2},
                new int[1],
                new int[1],
                List.of("floor")));
    }

    private static Drone plateDrone(double width, double height, double kelvins, FlightState state) {
        DroneSettings settings = DroneSettings.of(ModelSettings.of("plate.obj"), Hover.at(REST))
                .withHeat(HeatSignature.DEFAULT.withExcess(kelvins));
        return new Drone("drone", settings, KDTree.of(plate(width, height, 0))).at(state);
    }

    private static Drone at(double width, double height, double kelvins, double range) {
        return plateDrone(width, height, kelvins, new FlightState(new Position(0, range, 50), REST, 0.0));
    }

    private static Observation look(ThermalSettings settings, World world, Drone drone) {
        return settings.create()
                .observe(world, List.of(drone), Look.of(1, "heat", 0, 0.0))
                .get(0);
    }

    /** 640 pixels and 0.35 m at 1 km: 7.13 pixels across at 1.8 degrees, 0.53 at 24. */
    @ParameterizedTest
    @CsvSource({"1.8, 7.13", "24, 0.53"})
    void aDroneCoversAsManyPixelsAsGeometrySays(double fov, double across) {
        ThermalSettings settings = ThermalSettings.at(CAMERA).withHorizontalFov(Math.toRadians(fov));
        Observation seen = look(settings, empty(), at(0.35, 0.35, 5, 1000));

        assertThat(Math.sqrt(seen.figures().get("pixels"))).isCloseTo(across, within(0.01 * across));
        assertThat(0.35 / 1000 * settings.focalLength()).isCloseTo(across, within(0.005));
    }

    /**
     * One and a half pixels across the side of a square of 0.35 m are an even chance where heat is no limit: 4753 m at
     * 1.8 degrees, 351 m at 24, where two pixels by Johnson's one-dimensional line pair would be 3565 and 263 m.
     */
    @ParameterizedTest
    @CsvSource({"1.8, 4753", "24, 351.3"})
    void withHeatToSpareAPixelAndAHalfAcrossIsAnEvenChance(double fov, double range) {
        ThermalSettings settings = ThermalSettings.at(CAMERA)
                .withHorizontalFov(Math.toRadians(fov))
                .withNetd(1e-6)
                .withTransmission(1.0);
        assertThat(0.35 / 1.5 * settings.focalLength()).isCloseTo(range, within(0.5));

        assertThat(look(settings, empty(), at(0.35, 0.35, 5, 0.97 * range)).isDetected())
                .isTrue();
        assertThat(look(settings, empty(), at(0.35, 0.35, 5, 1.03 * range)).isDetected())
                .isFalse();
    }

    /** 5 K, 85 % a kilometre, 1 km, 50 mK, a resolved drone: 85. */
    @Test
    void theSignalIsWhatTheAirLeavesOverTheNoise() {
        ThermalSensor sensor = ThermalSettings.at(CAMERA).create();

        assertThat(sensor.signalToNoise(5, 1000, 40)).isCloseTo(85.0, within(1e-9));
        assertThat(sensor.signalToNoise(-5, 1000, 40)).isCloseTo(85.0, within(1e-9));
        // A quarter of a pixel gives a quarter of the signal.
        assertThat(sensor.signalToNoise(5, 1000, 0.25)).isCloseTo(21.25, within(1e-9));
    }

    @Test
    void lessHeatShortensTheRange() {
        ThermalSettings settings = ThermalSettings.at(CAMERA);
        double warm = look(settings, empty(), at(0.35, 0.35, 5, 250)).value();
        double cool = look(settings, empty(), at(0.35, 0.35, 0.5, 250)).value();
        // N = 1/2 sqrt(area) (1 - 2/SNR) against 0.75, SNR = dT 0.85^0.25 / 0.05.
        double sqrt = 0.35 / 250 * settings.focalLength();
        double air = Math.pow(0.85, 0.25) / 0.05;

        double x = 0.5 * sqrt / 0.75;
        assertThat(warm).isCloseTo(Discrimination.transfer(x * (1 - 2 / (5 * air))), within(0.02));
        assertThat(cool).isCloseTo(Discrimination.transfer(x * (1 - 2 / (0.5 * air))), within(0.02));
        assertThat(look(settings, empty(), at(0.35, 0.35, 0.1, 250)).value()).isZero();
    }

    /** 10 m/s across at 250 m, 0.01 s: 0.0004 rad are 0.602 pixels of 1505 to the radian, in one of two directions. */
    @Test
    void motionBlursAcrossButNotAlongTheLineOfSight() {
        ThermalSettings settings = ThermalSettings.at(CAMERA);
        Position there = new Position(0, 250, 50);
        Drone crossing = plateDrone(0.35, 0.35, 5, new FlightState(there, new Position(10, 0, 0), 0.0));
        Drone coming = plateDrone(0.35, 0.35, 5, new FlightState(there, new Position(0, -10, 0), 0.0));
        double still = look(settings, empty(), at(0.35, 0.35, 5, 250)).value();

        assertThat(look(settings, empty(), coming).value()).isCloseTo(still, within(1e-12));
        double sharp = 0.5 * 0.35 / 250 * settings.focalLength() * (1 - 2 / (5 * Math.pow(0.85, 0.25) / 0.05)) / 0.75;
        double blurred = sharp / Math.pow(1 + 0.6021 * 0.6021, 0.25);
        assertThat(still).isCloseTo(Discrimination.transfer(sharp), within(0.02));
        assertThat(look(settings, empty(), crossing).value())
                .isCloseTo(Discrimination.transfer(blurred), within(0.02))
                .isLessThan(still - 0.05);
        assertThat(look(settings.withExposure(0), empty(), crossing).value()).isEqualTo(still);
    }

    @Test
    void aDroneThatGlidesCools() {
        FlightState gliding =
                new FlightState(new Position(0, 500, 50), REST, 0.0, OptionalDouble.of(120 * Math.log(2)));
        Drone cooled = plateDrone(1, 1, 8, gliding);

        assertThat(cooled.heat()).isCloseTo(4.0, within(1e-12));
        assertThat(plateDrone(1, 1, 8, new FlightState(REST, REST, 0.0)).heat()).isEqualTo(8.0);
    }

    @Test
    void aWallHidesWhatIsBehindIt() {
        World wall = World.of(plate(20, 200, 100));
        ThermalSettings settings = ThermalSettings.at(CAMERA);

        assertThat(look(settings, wall, at(2, 2, 5, 200)).figures()).containsEntry("pixels", 0.0);
        assertThat(look(settings, wall, at(2, 2, 5, 90)).isDetected()).isTrue();
        // Half of a plate that looks out beside the wall's edge.
        Drone half = plateDrone(4, 4, 5, new FlightState(new Position(20, 200, 50), REST, 0.0));
        double whole = look(settings, empty(), half).figures().get("pixels");
        assertThat(look(settings, wall, half).figures().get("pixels")).isCloseTo(0.5 * whole, within(0.05 * whole));
    }

    /**
     * Anywhere in the picture, against a square's area times the square of the focal length: 1/cos^3 for what faces the
     * camera.
     */
    @Test
    void theAreaIsRightOffTheAxisAndNoneIsCountedOutsideThePicture() {
        ThermalSettings settings = ThermalSettings.at(CAMERA).withHorizontalFov(Math.toRadians(60));
        CameraObject camera = new CameraObject(settings);
        VisibleArea area = new VisibleArea(camera, empty());
        double focal = settings.focalLength();
        for (double aside : new double[] {0, 30, 55}) {
            // The plate's plane is across the camera's axis: pixels are as many wherever it stands.
            Drone drone = plateDrone(1, 1, 5, new FlightState(new Position(aside, 100, 50), REST, 0.0));
            assertThat(area.of(drone)).isCloseTo(focal * focal / 1e4, within(0.04 * focal * focal / 1e4));
        }
        double edge = 100 * Math.tan(Math.toRadians(30));
        Drone cut = plateDrone(1, 1, 5, new FlightState(new Position(edge, 100, 50), REST, 0.0));
        assertThat(area.of(cut)).isCloseTo(0.5 * focal * focal / 1e4, within(0.04 * focal * focal / 1e4));
        Drone behind = plateDrone(1, 1, 5, new FlightState(new Position(0, -100, 50), REST, 0.0));
        assertThat(area.of(behind)).isZero();
        Drone onTheBack = plateDrone(1, 1, 5, new FlightState(new Position(0, -0.4, 50), REST, 0.0));
        assertThat(area.of(onTheBack)).isZero();
    }

    /** The same drone in a camera of many pixels, counted one by one. */
    @Test
    void theAreaAgreesWithCountedPixels() {
        Drone quadrotor = DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), Hover.at(new Position(3, 60, 52)))
                .create("drone", java.nio.file.Path.of(""));
        CameraSettings fine =
                CameraSettings.at(CAMERA).withLookAt(new Position(0, 60, 50)).withResolution(8000, 6000);
        int counted = fine.create().pixels(empty(), quadrotor);
        double area = new VisibleArea(new CameraObject(fine), empty()).of(quadrotor);

        assertThat(counted).isGreaterThan(300);
        assertThat(area).isCloseTo(counted, within(0.06 * counted));
    }

    @Test
    void impossibleCamerasAreRefused() {
        assertThatThrownBy(() -> ThermalSettings.at(CAMERA).withNetd(0)).hasMessage("netd 0 K must be 1e-6 to 100");
    }

    /** Bounds for all headings, and assessments that trace fewer rays, against those that trace all of them. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void boundsHold(boolean byChance) {
        long seed = System.nanoTime();
        System.out.println("ThermalSensorTest: by chance " + byChance + ", seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        ThermalSettings settings =
                ThermalSettings.at(REST).withHorizontalFov(0.3).withChance(byChance);
        World wall = World.of(plate(12, 9, 100));
        ThermalSensor exact = settings.create();
        ThermalSensor quick = settings.create();
        Map<Cause, Integer> bounded = new EnumMap<>(Cause.class);
        Drone plate = plateDrone(0.5, 0.3, 5, new FlightState(REST, REST, 0.0));
        int[] decided = new int[2];
        for (int i = 0; i < 400; i++) {
            double range = 20.0 * Math.exp(random.nextDouble() * 5.0);
            Position at = new Position(
                    0.35 * range * (random.nextDouble() - 0.5), range, 0.28 * range * (random.nextDouble() - 0.5));
            Position velocity = new Position(10.0 * random.nextDouble(), 0.0, 0.0);
            FlightState state = new FlightState(at, velocity, 6.0 * random.nextDouble());
            Drone drone = plate.at(state);
            Assessment all = exact.assess(wall, drone, Optional.empty(), random);
            Optional<AssessmentBounds> inState =
                    quick.bound(wall, plate, state, Optional.empty(), p -> (int) (250 * p));
            // The silhouette that was looked up serves this, too.
            Assessment some =
                    quick.assessCoarsely(wall, drone, Optional.empty(), random, ProbabilityResolution.upTo(1.0));
            String as = "seed %d, %s".formatted(seed, at);
            assertThat(some.cause()).as(as).isEqualTo(all.cause());
            assertThat(some.probability()).as(as).isEqualTo(all.probability());
            inState.ifPresent(bounds -> {
                decided[bounds.cause() == Cause.DETECTED ? 1 : 0]++;
                assertThat(all.cause()).as(as).isEqualTo(bounds.cause());
                assertThat(all.probability()).as(as).isBetween(bounds.least(), bounds.greatest());
                assertThat(all.marginDb()).as(as).isBetween(bounds.leastMarginDb(), bounds.greatestMarginDb());
            });
            quick.boundAtAllHeadings(wall, drone, at, Optional.empty()).ifPresent(bounds -> {
                bounded.merge(bounds.cause(), 1, Integer::sum);
                assertThat(all.cause()).as(as).isEqualTo(bounds.cause());
                assertThat(all.probability()).as(as).isBetween(bounds.least(), bounds.greatest());
                assertThat(all.marginDb()).as(as).isBetween(bounds.leastMarginDb(), bounds.greatestMarginDb());
            });
        }
        assertThat(bounded)
                .as("seed %d", seed)
                .containsKeys(Cause.OUT_OF_VIEW, Cause.HIDDEN_BY_BUILDING, Cause.TOO_WEAK);
        assertThat(Math.min(decided[0], decided[1])).as("seed %d", seed).isPositive();
    }

    /** Nothing hides the drone, so that rays need only be traced until they decide. */
    @Test
    void boundsDecideWhereverNothingHidesTheDrone() {
        long seed = System.nanoTime();
        System.out.println("ThermalSensorTest: nothing hidden, seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        ThermalSettings settings =
                ThermalSettings.at(REST).withHorizontalFov(0.3).withChance(true);
        ThermalSensor exact = settings.create();
        ThermalSensor quick = settings.create();
        Drone quadrotor = DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), Hover.at(REST))
                .create("drone", java.nio.file.Path.of(""));
        int uncertain = 0;
        for (int i = 0; i < 400; i++) {
            Position at = new Position(0.0, 100.0 + 600.0 * random.nextDouble(), 10.0);
            FlightState state = new FlightState(at, REST, 6.0 * random.nextDouble());
            // The masks of a direction are made once it has been asked for a few times.
            for (int time = 0; time < 4; time++) {
                quick.bound(empty(), quadrotor, state, Optional.empty(), p -> (int) (250 * p));
            }
            Optional<AssessmentBounds> bounds =
                    quick.bound(empty(), quadrotor, state, Optional.empty(), p -> (int) (250 * p));
            double p = exact.assess(empty(), quadrotor.at(state), Optional.empty(), random)
                    .probability();
            String as = "seed %d, %s".formatted(seed, state);
            assertThat(bounds).as(as).isPresent();
            assertThat(p).as(as).isBetween(bounds.get().least(), bounds.get().greatest());
            assertThat((int) (250 * bounds.get().least())).as(as).isEqualTo((int) (250 * p));
            uncertain += p > 0.1 && p < 0.9 ? 1 : 0;
        }
        assertThat(uncertain).as("seed %d", seed).isPositive();
    }
}
