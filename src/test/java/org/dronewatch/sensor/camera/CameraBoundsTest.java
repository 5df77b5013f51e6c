package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.wall;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.DoubleToIntFunction;
import java.util.stream.Stream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.positioner.Direction;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.AssessmentBounds;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Discrimination;
import org.dronewatch.sensor.optics.Projection;
import org.dronewatch.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Bounds against exact assessments, which draw the drone: at random places before, beside and behind the edge of a
 * wall, at the rims of the image, at the planes of its projection, and around the camera itself.
 */
class CameraBoundsTest {
    private static final int PLACES = 250;
    private static final double NORTH = 40.0;
    private static final DoubleToIntFunction STEPS =
            p -> p <= 0.0 || p >= 1.0 ? (int) (250 * p) : Math.max(1, Math.min(249, (int) Math.rint(250 * p)));
    private static final CameraSettings CAMERA =
            CameraSettings.at(new Position(0, 0, 0)).withResolution(960, 540);

    private static final CameraSettings LONG_LENS = CAMERA.withVerticalFov(0.03);
    private static final World WORLD = behind(wall(NORTH, -9, 0.4), ModelRole.BUILDING);
    private static final Drone CUBE = cube(new Position(0, 0, 0));
    private static final Drone CROSS = Shapes.drone("drone", cross(), new Position(0, 0, 0));

    static Stream<Arguments> cameras() {
        TargetTask byChance = TargetTask.DEFAULT.withChance(true);
        TargetTask recognition = TargetTask.DEFAULT.withTask(Discrimination.RECOGNITION);
        CameraSettings shifted = CAMERA.withProjection(new Projection(0.1, -0.2, 6.0, 70.0));
        return Stream.of(
                Arguments.of("pixels", CAMERA, CROSS),
                Arguments.of("many pixels", CAMERA.withDetection(new PixelThreshold(300.0)), CROSS),
                Arguments.of("one pixel of a cube", CAMERA.withDetection(new PixelThreshold(1.0)), CUBE),
                Arguments.of("between planes", shifted, CROSS),
                Arguments.of("long lens", LONG_LENS, CROSS),
                Arguments.of("long lens, many pixels", LONG_LENS.withDetection(new PixelThreshold(9000.0)), CROSS),
                Arguments.of("long lens, recognition", LONG_LENS.withDetection(recognition), CROSS),
                Arguments.of(
                        "longer lens, more pixels than are examined",
                        LONG_LENS
                                .withResolution(LongForm.count(1680, 2400), LongForm.count(945, 1350))
                                .withDetection(new PixelThreshold(LongForm.count(9_800, 20_000))),
                        CROSS),
                Arguments.of("rolled", CAMERA.withRoll(0.7), CROSS),
                Arguments.of("task", CAMERA.withDetection(TargetTask.DEFAULT), CROSS),
                Arguments.of("recognition by chance", CAMERA.withDetection(byChance), CUBE),
                Arguments.of(
                        "identification by chance",
                        CAMERA.withDetection(byChance.withTask(Discrimination.IDENTIFICATION)),
                        CROSS));
    }

    /** Two thin crossing beams and a small round body of many triangles, so that single pixels are traced, too. */
    private static TriangleMesh cross() {
        return World.merge(List.of(
                Shapes.box(new Position(-0.5, -0.03, 0.1), new Position(0.5, 0.03, 0.14)),
                Shapes.box(new Position(-0.03, -0.3, 0.1), new Position(0.03, 0.5, 0.14)),
                Shapes.sphere(0.15, 4)));
    }

    @Thorough
    @ParameterizedTest
    @MethodSource("cameras")
    void boundsHold(String name, CameraSettings settings, Drone drone) {
        long seed = System.nanoTime();
        System.out.println("CameraBoundsTest: " + name + ", seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        CameraSensor bounding = settings.create();
        CameraSensor exact = settings.create();
        int decided = 0;
        int alike = 0;
        int hidden = 0;
        for (int i = 0; i < PLACES; i++) {
            FlightState state = state(random, settings.fov() / CAMERA.fov());
            requestMask(drone, state);
            String as = "%s, seed %d, %s".formatted(name, seed, state);
            Assessment drawn = exact.assess(WORLD, drone.at(state), Optional.empty(), new SplittableRandom(1));
            Optional<AssessmentBounds> all =
                    bounding.boundAtAllHeadings(WORLD, drone, state.position(), Optional.empty());
            all.ifPresent(bounds -> check(as, bounds, drawn));
            Optional<AssessmentBounds> one = bounding.bound(WORLD, drone, state, Optional.empty(), STEPS);
            one.ifPresent(bounds -> check(as, bounds, drawn));
            decided += one.isPresent() || all.isPresent() ? 1 : 0;
            alike += all.isPresent() ? 1 : 0;
            hidden += (one.isPresent() || all.isPresent()) && drawn.cause() == Cause.HIDDEN_BY_BUILDING ? 1 : 0;
        }
        assertThat(decided).as("decided, seed %d", seed).isGreaterThan(PLACES / 12);
        assertThat(alike).as("alike on all headings, seed %d", seed).isGreaterThan(PLACES / 20);
        assertThat(hidden).as("hidden, seed %d", seed).isPositive();
    }

    private static void check(String as, AssessmentBounds bounds, Assessment drawn) {
        assertThat(bounds.cause()).as(as).isEqualTo(drawn.cause());
        assertThat(drawn.probability()).as(as).isBetween(bounds.least(), bounds.greatest());
        assertThat(drawn.marginDb()).as(as).isBetween(bounds.leastMarginDb(), bounds.greatestMarginDb());
        assertThat(STEPS.applyAsInt(bounds.least())).as(as).isEqualTo(STEPS.applyAsInt(bounds.greatest()));
    }

    /** A mask is made only after several requests. */
    private static void requestMask(Drone drone, FlightState state) {
        Direction to = Direction.of(state.position());
        for (int i = 0; i < 20; i++) {
            drone.silhouettes().mask(to.azimuth() - state.heading(), to.elevation(), 100);
        }
    }

    /**
     * From inside the camera's own sphere to beyond the farthest plane, also outside the image and behind it; often at
     * the upper edge of the wall, on both sides of it, or partly through it.
     */
    private static FlightState state(SplittableRandom random, double scale) {
        double range = 0.05 * Math.exp(random.nextDouble() * Math.log(8000.0));
        double above = scale * range * (random.nextDouble() - 0.5);
        int kind = random.nextInt(4);
        if (kind == 0) {
            range = NORTH + random.nextDouble() - 0.5;
            above = 0.4 + 2.0 * (random.nextDouble() - 0.75);
        } else if (kind == 1 && range > NORTH) {
            above = 0.4 * range / NORTH + 1.5 * (random.nextDouble() - 0.5);
        }
        Position at = new Position(
                scale * range * 1.4 * (random.nextDouble() - 0.5), random.nextInt(10) == 0 ? -range : range, above);
        // Few headings need few masks.
        double heading = 1.3 * random.nextInt(4) - 2.0 + 0.02 * random.nextDouble();
        Position velocity = new Position(10 * random.nextDouble(), 10 * random.nextDouble(), 0);
        return new FlightState(at, velocity, heading);
    }
}
