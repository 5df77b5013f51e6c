package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.wall;

import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Discrimination;
import org.dronewatch.sensor.ProbabilityResolution;
import org.dronewatch.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** An assessment that does not count every pixel comes to the same decision as one that does. */
class CoarseAssessmentTest {
    private static final double HIGH = 0.996;
    private static final CameraSettings CAMERA = CameraSettings.at(new Position(0, 0, 0));

    static Stream<DetectionFunction> functions() {
        TargetTask byChance = TargetTask.DEFAULT.withChance(true);
        return Stream.of(
                PixelThreshold.DEFAULT,
                new PixelThreshold(5000.0),
                TargetTask.DEFAULT,
                TargetTask.DEFAULT.withProbability(0.999),
                byChance,
                byChance.withTask(Discrimination.IDENTIFICATION));
    }

    /** Cubes before, beside and behind the edge of a wall, near and far, some of them partly hidden. */
    @ParameterizedTest
    @MethodSource("functions")
    void probabilityAndCauseAreTheSame(DetectionFunction detection) {
        long seed = 20261127;
        SplittableRandom random = new SplittableRandom(seed);
        World world = behind(wall(15, -9, 0.4), ModelRole.BUILDING);
        CameraSensor coarse = CAMERA.withDetection(detection).create();
        CameraSensor exact = CAMERA.withDetection(detection).create();
        int earlier = 0;
        int hidden = 0;
        for (int i = 0; i < 300; i++) {
            double range = Math.exp(random.nextDouble() * Math.log(600.0)) + 1.2;
            Drone drone = cube(new Position(
                    range * (random.nextDouble() - 0.5), range, (random.nextDouble() - 0.4) * Math.min(range, 10.0)));
            Assessment all = exact.assess(world, drone, Optional.empty(), new SplittableRandom(1));
            Assessment one = coarse.assessCoarsely(
                    world, drone, Optional.empty(), new SplittableRandom(1), ProbabilityResolution.upTo(HIGH));

            String as = "%s at %s, seed %d".formatted(detection, drone.origin(), seed);
            assertThat(one.explanation()).as(as).isEqualTo(all.explanation());
            if (all.probability() < HIGH || all.probability() == 1.0) {
                assertThat(one.probability()).as(as).isEqualTo(all.probability());
            } else {
                assertThat(one.probability()).as(as).isBetween(HIGH, Math.nextDown(1.0));
            }
            if (all.cause() != Cause.DETECTED) {
                assertThat(one).as(as).isEqualTo(all);
                hidden += all.cause() == Cause.HIDDEN_BY_BUILDING ? 1 : 0;
            }
            earlier += one.quantity() < all.quantity() ? 1 : 0;
        }
        assertThat(hidden).as("hidden, seed %d", seed).isGreaterThan(20);
        // The probability of a task is 1 to the last bit with a few hundred pixels, the number of pixels grows.
        if (detection instanceof PixelThreshold) {
            assertThat(earlier).as("not all pixels counted, seed %d", seed).isGreaterThan(10);
        }
    }
}
