package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.EnumSet;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleToIntFunction;
import java.util.stream.Stream;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.AssessmentBounds;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Discrimination;
import org.dronewatch.world.Light;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Bounds that would be right but useless: where little is open, they decide. Where all pixels can be traced, they are
 * exact; where the drone has far more pixels than required, or far fewer, a drone of any size is decided.
 */
class CameraBoundsReachedTest {
    private static final World OPEN = open();
    private static final CameraSettings CAMERA =
            CameraSettings.at(new Position(0, 0, 0)).withResolution(960, 540);
    private static final double FOCAL = CAMERA.focalLength();
    private static final CameraSettings LONG_LENS = CAMERA.withVerticalFov(0.03);
    private static final double NORTH = 40.0;
    private static final double TOP = 0.4;
    private static final World WALL = behind(wall(NORTH, -99, TOP), ModelRole.BUILDING);

    /** So many triangles that single pixels are traced where there are fewer than 341 around it. */
    private static final Drone BALL = Shapes.drone("drone", Shapes.sphere(0.5, 4), new Position(0, 0, 0));

    private static final Drone CUBE = cube(new Position(0, 0, 0));

    /** Probabilities that differ by a billionth count as different. */
    private static final DoubleToIntFunction FINE = p -> (int) Math.rint(1e9 * p);

    private static Assessment exact(CameraSettings camera, World world, Drone drone, FlightState state) {
        return exact(camera.create(), world, drone, state);
    }

    private static Assessment exact(CameraSensor camera, World world, Drone drone, FlightState state) {
        return camera.assess(world, drone.at(state), Optional.empty(), new SplittableRandom(1));
    }

    private static void check(String as, AssessmentBounds bounds, Assessment exact) {
        assertThat(bounds.cause()).as(as).isEqualTo(exact.cause());
        assertThat(exact.probability()).as(as).isBetween(bounds.least(), bounds.greatest());
        assertThat(exact.marginDb()).as(as).isBetween(bounds.leastMarginDb(), bounds.greatestMarginDb());
        assertThat(FINE.applyAsInt(bounds.least())).as(as).isEqualTo(FINE.applyAsInt(bounds.greatest()));
    }

    static Stream<DetectionFunction> functions() {
        TargetTask byChance = TargetTask.DEFAULT.withChance(true);
        return Stream.of(
                new PixelThreshold(12),
                new PixelThreshold(1),
                new PixelThreshold(60),
                TargetTask.DEFAULT.withTask(Discrimination.RECOGNITION),
                byChance.withTask(Discrimination.RECOGNITION),
                byChance.withTask(Discrimination.IDENTIFICATION),
                new Steady(60),
                new Steady(95));
    }

    /** The only case that is left open: the line of sight to its origin is free, and what is hidden would decide. */
    private static boolean isPartlyHidden(Position at, Assessment exact) {
        boolean isOriginFree = at.y() < NORTH || at.z() * NORTH / at.y() > TOP;
        return isOriginFree && exact.cause() == Cause.HIDDEN_BY_BUILDING;
    }

    static Stream<Arguments> functionsInWorlds() {
        return functions().flatMap(one -> Stream.of(Arguments.of(one, WALL), Arguments.of(one, OPEN)));
    }

    /** First on all headings, where there is no mask of its silhouette yet, then on one, where there is. */
    @ParameterizedTest
    @MethodSource("functionsInWorlds")
    void aSmallDroneOfManyTrianglesIsAlwaysDecided(DetectionFunction detection, World world) {
        SplittableRandom random = new SplittableRandom(17);
        CameraSettings camera = CAMERA.withDetection(detection);
        CameraSensor bounding = camera.create();
        CameraSensor drawing = camera.create();
        Set<Cause> causes = EnumSet.noneOf(Cause.class);
        for (int i = 0; i < 160; i++) {
            double range = 44.0 * Math.exp(random.nextDouble(3.0));
            double aside = 0.7 * range * random.nextDouble(-1, 1);
            double above = random.nextInt(3) == 0 ? 0.4 * range * random.nextDouble(-1, 1) : random.nextDouble(-2, 2);
            double edge = random.nextInt(2) * TOP * range / NORTH;
            Position at = new Position(aside, range, above + edge);
            double speed = random.nextInt(3) * random.nextDouble(5);
            double heading = i < 80 ? random.nextDouble(6.2) : 1.3;
            FlightState state = new FlightState(at, new Position(speed, 0, 0), heading);
            Assessment one = exact(drawing, world, BALL, state);
            String as = "number %d, %s".formatted(i, state);
            Optional<AssessmentBounds> bounds = bounding.bound(world, BALL, state, Optional.empty(), FINE);

            bounds.ifPresent(there -> check(as, there, one));
            boolean isOpen = world == WALL && isPartlyHidden(at, one);
            assertThat(bounds.isPresent() || isOpen).as(as).isTrue();
            bounding.boundAtAllHeadings(world, BALL, at, Optional.empty()).ifPresent(all -> {
                check(as, all, one);
                assertThat(all.leastMarginDb()).as(as).isEqualTo(all.greatestMarginDb());
            });
            causes.add(one.cause());
        }
        assertThat(causes).contains(Cause.DETECTED);
    }

    /**
     * A cube before the camera: a square of {@code side} pixels. The masks of its silhouette are made for directions
     * within a degree or two, so they need not know its edges, but its middle.
     */
    @ParameterizedTest
    @CsvSource({
        "30, 0.5, DETECTED", "30, 2, TOO_WEAK", "30, 9, TOO_WEAK", "100, 0.02, DETECTED", "100, 0.5, DETECTED",
        "100, 2, TOO_WEAK", "100, 9, TOO_WEAK", "200, 0.5, DETECTED", "200, 2, TOO_WEAK", "200, 9, TOO_WEAK"
    })
    void aDroneFarFromTheThresholdIsDecided(double side, double factor, Cause cause) {
        CameraSettings camera = LONG_LENS.withThreshold(Math.rint(factor * side * side));
        FlightState state = before(side);
        Drone drone = cube(state.position());
        requestMask(drone, state);
        AssessmentBounds bounds = camera.create()
                .bound(OPEN, drone, state, Optional.empty(), FINE)
                .orElseThrow();

        assertThat(bounds.cause()).isEqualTo(cause);
        check("cube", bounds, exact(camera, OPEN, drone, state));
    }

    /** A cube that turns a face to a camera with a long lens, which covers a number of columns and of rows. */
    private static FlightState before(double side) {
        double range = LONG_LENS.focalLength() / side + 0.5;
        return new FlightState(new Position(0.01 * range, range, 0.01 * range), new Position(0, 0, 0), 0.0);
    }

    /** A mask is made only after several requests. */
    private static void requestMask(Drone drone, FlightState state) {
        Direction to = Direction.of(state.position());
        for (int i = 0; i < 20; i++) {
            drone.silhouettes().mask(to.azimuth() - state.heading(), to.elevation(), 100);
        }
    }

    /** Its bounding sphere alone covers too few pixels: nobody needs to know its silhouette, or to draw it. */
    @Test
    void aDroneWhoseSphereIsTooSmallIsTooWeak() {
        FlightState state = new FlightState(new Position(0, 500, 1), new Position(0, 0, 0), 0.4);

        AssessmentBounds bounds =
                CAMERA.create().bound(OPEN, CUBE, state, Optional.empty(), FINE).orElseThrow();
        assertThat(bounds.cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(bounds.least()).isZero();
        assertThat(bounds.greatest()).isZero();
    }

    /** Even if more pixels are required than it has, since nothing of it is visible. */
    @ParameterizedTest
    @CsvSource({"60, 5", "60, 1e6", "400, 5", "400, 1e6", "100, 900"})
    void aDroneBehindAWallIsHiddenOnEveryHeading(double range, double threshold) {
        CameraSettings camera = CAMERA.withVerticalFov(0.1).withThreshold(threshold);
        FlightState state = new FlightState(new Position(1, range, -3), new Position(0, 0, 0), 0.4);

        AssessmentBounds bounds =
                camera.create().bound(WALL, CUBE, state, Optional.empty(), FINE).orElseThrow();
        AssessmentBounds all = camera.create()
                .boundAtAllHeadings(WALL, CUBE, state.position(), Optional.empty())
                .orElseThrow();
        assertThat(bounds.cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(all).isEqualTo(bounds);
        assertThat(all.greatest()).isZero();
        assertThat(all.greatestMarginDb()).isEqualTo(Double.NEGATIVE_INFINITY);
    }

    /** By chance, a large drone in thick haze is found by some: the bounds need the number of its pixels. */
    @Test
    void theProbabilityOfALargeDroneInHazeIsKnownToAStep() {
        Light haze = Light.DAY.withVisibility(172);
        CameraSettings camera = LONG_LENS.withDetection(
                TargetTask.DEFAULT.withTask(Discrimination.IDENTIFICATION).withChance(true));
        DoubleToIntFunction coarse = p -> p <= 0.0 ? 0 : p < 0.5 ? 1 : 2;
        FlightState state = before(100);
        World world = OPEN.withLight(haze);
        Drone drone = cube(state.position());
        requestMask(drone, state);
        Assessment one = exact(camera, world, drone, state);

        assertThat(one.probability()).isBetween(0.05, 0.45);
        AssessmentBounds bounds = camera.create()
                .bound(world, drone, state, Optional.empty(), coarse)
                .orElseThrow();
        assertThat(bounds.cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(one.probability()).isBetween(bounds.least(), bounds.greatest());
        assertThat(coarse.applyAsInt(bounds.least())).isEqualTo(coarse.applyAsInt(bounds.greatest()));
    }

    /** Its origin is beyond the edge of the image, but not all of it: out of view, unless what is left is enough. */
    @Test
    void aDroneAtTheEdgeOfTheImageIsOutOfViewByItsOrigin() {
        double edge = 480 / FOCAL * 60;
        FlightState state = new FlightState(new Position(edge + 0.1, 60, 0), new Position(0, 0, 0), 0.4);
        CameraSensor sensor = CAMERA.withThreshold(9000).create();

        assertThat(sensor.pixels(OPEN, CUBE.at(state))).isPositive();
        assertThat(sensor.boundAtAllHeadings(OPEN, CUBE, state.position(), Optional.empty()))
                .isEmpty();
        assertThat(sensor.bound(OPEN, CUBE, state, Optional.empty(), FINE)
                        .orElseThrow()
                        .cause())
                .isEqualTo(Cause.OUT_OF_VIEW);
    }

    /** A fixed camera ahead, and one that is pointed: what is behind it is out of view on every heading. */
    @Test
    void whatIsBehindTheCameraIsOutOfViewOnEveryHeading() {
        Optional<Pointing> south =
                Optional.of(Pointing.still(new Direction(Math.PI, 0), CAMERA.fov(), OptionalInt.empty()));
        Position north = new Position(0, 100, 0);
        FlightState state = new FlightState(north, new Position(0, 0, 0), 0.0);

        for (DetectionFunction detection : functions().toList()) {
            CameraSensor sensor = CAMERA.withDetection(detection).create();
            AssessmentBounds bounds =
                    sensor.boundAtAllHeadings(OPEN, CUBE, north, south).orElseThrow();
            Assessment one = sensor.assess(OPEN, CUBE.at(state), south, new SplittableRandom(1));
            check(detection.toString(), bounds, one);
            assertThat(sensor.boundAtAllHeadings(OPEN, CUBE, north, Optional.empty()))
                    .isEmpty();
        }
    }

    /**
     * The threshold is the number of pixels of the drone, so that its rim is traced ray by ray. What is known of fewer
     * and of more pixels is not asked again: searches by halves take few evaluations, however many rays there are.
     */
    @ParameterizedTest
    @CsvSource({"4, 90", "5, 90", "5, 55"})
    void theDetectionFunctionIsNotEvaluatedForEveryRay(int cuts, double side) {
        Drone ball = Shapes.drone("drone", Shapes.sphere(0.5, cuts), new Position(0, 0, 0));
        FlightState state = before(side);
        requestMask(ball, state);
        int pixels = LONG_LENS.create().pixels(OPEN, ball.at(state));
        AtomicInteger evaluations = new AtomicInteger();
        CameraSensor sensor =
                LONG_LENS.withDetection(new Counted(pixels, evaluations)).create();
        AssessmentBounds bounds =
                sensor.bound(OPEN, ball, state, Optional.empty(), FINE).orElseThrow();

        assertThat(bounds.cause()).isEqualTo(Cause.DETECTED);
        double halves = Math.log(pixels) / Math.log(2.0);
        assertThat(evaluations.get()).isLessThan((int) (2.5 * halves));
    }

    /** A function that counts pixels, and how often it is asked. */
    private record Counted(double threshold, AtomicInteger evaluations) implements DetectionFunction {
        @Override
        public double value(DroneView view) {
            evaluations.incrementAndGet();
            return view.pixels();
        }

        @Override
        public boolean growsWithPixels() {
            return true;
        }

        @Override
        public String unit() {
            return "px";
        }
    }
}
