package org.dronewatch.sensor.acoustic.level;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** Looks without the rays that cannot be detected against looks with all rays. */
class DecisiveRaysTest {
    static final Position SENSOR = new Position(0, 0, 0);
    private static final int LOOKS = 400;

    /** A room of four materials, of which one transmits sound, with a wall that hides half of it from the sensor. */
    static World room() {
        return World.of(World.merge(List.of(
                wall("concrete_rough", 0, -6, 6),
                wall("metal_sheet", 0, 6, 6),
                wall("concrete_rough", 1, -6, 6),
                wall("grass_turf", 1, 6, 6),
                wall("perfect_mirror", 2, -6, 6),
                wall("wooden_door", 1, 2, 4))));
    }

    private static TriangleMesh wall(String material, int axis, double at, double half) {
        float[] vertices = new float[12];
        double[][] corners = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
        for (int i = 0; i < 4; i++) {
            vertices[3 * i + axis] = (float) at;
            vertices[3 * i + (axis + 1) % 3] = (float) corners[i][0];
            vertices[3 * i + (axis + 2) % 3] = (float) corners[i][1];
        }
        return new TriangleMesh(vertices, new int[] {0, 1, 2, 0, 2, 3}, new int[2], new int[2], List.of(material));
    }

    /** A ray 20 m from the sensor, to which the air takes 1 dB; it passes the sensor at a distance. */
    @Test
    void aRayCountsIfItOrItsReflectionsCanBeLoudEnough() {
        World mirror = World.of(wall("perfect_mirror", 2, -6, 6));
        World absorber = World.of(wall("grass_turf", 2, -6, 6));
        double loss = new SurfaceLevels(absorber).leastLoss();
        assertThat(loss)
                .isEqualTo(new SurfaceLevels(absorber).reflectionLoss(0, 1.0))
                .isPositive();
        double away = 2.0;
        double past = 0.401;
        double near = 0.399;
        assertThat(includes(mirror, 1.0, 0, away)).isTrue();
        assertThat(includes(mirror, 1.0, 3, away))
                .as("ends at the next surface")
                .isFalse();
        assertThat(includes(mirror, 1.0, 3, past)).isFalse();
        assertThat(includes(mirror, 1.0, 3, near)).isTrue();
        assertThat(includes(mirror, 0.999, 0, near)).as("too quiet").isFalse();
        assertThat(includes(absorber, 1.0 + loss, 2, away)).isTrue();
        assertThat(includes(absorber, 0.999 + loss, 2, away)).isFalse();
        assertThat(includes(absorber, 0.999 + loss, 2, near)).isTrue();
    }

    private static boolean includes(World world, double level, int order, double beside) {
        LevelModel model = LevelModel.DEFAULT.withAttenuation(0.05).withLimits(3, 1000);
        AcousticRay ray = new AcousticRay();
        ray.originX = 20.0;
        ray.level = level;
        ray.order = order;
        ray.directionX = -Math.sqrt(1.0 - beside * beside / (20.0 * 20.0));
        ray.directionY = beside / 20.0;
        return new DecisiveRays(model, SENSOR, 0.4, 0.0, new SurfaceLevels(world)).include(ray);
    }

    /** With transmission, in several orders, and with budgets that end rays in some looks, but not in all. */
    @Test
    void aLookIsDecidedByItsOwnRandomNumbers() {
        long seed = System.nanoTime();
        System.out.println("DecisiveRaysTest: seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        World room = room();
        int[] detected = new int[2];
        int cut = 0;
        long all = 0;
        long decisive = 0;
        for (int i = 0; i < 60; i++) {
            LevelModel model = LevelModel.DEFAULT
                    .withRays(3, 8)
                    .withTransmittedRays(1 + random.nextInt(3))
                    .withAttenuation(0.05 + 0.4 * random.nextDouble())
                    .withLimits(random.nextInt(5), i % 3 == 0 ? 1 + random.nextInt(60) : 200_000);
            Position drone = new Position(8 * random.nextDouble() - 4, 2.5 + 3 * random.nextDouble(), -3);
            double level = 0.2 + model.attenuation() * drone.distance(SENSOR) + 3 * random.nextDouble();
            LevelTracer tracer = new LevelTracer(model, SENSOR, 0.4, 0.0, room);
            for (int look = 0; look < 20; look++) {
                long own = random.nextLong();
                LevelReading one = tracer.trace(
                        drone, level, new SplittableRandom(own), TracedRays.UNTIL_DETECTED, RayRecorder.NONE);
                LevelReading other = tracer.trace(
                        drone, level, new SplittableRandom(own), TracedRays.DECISIVE_OF_LOOK, RayRecorder.NONE);
                assertThat(other.detected()).as("seed %d, case %d", seed, i).isEqualTo(one.detected());
                assertThat(other.cutByBudget()).as("seed %d, case %d", seed, i).isEqualTo(one.cutByBudget());
                if (one.detected()) {
                    assertThat(other.bestLevel()).isEqualTo(one.bestLevel());
                }
                detected[one.detected() ? 1 : 0]++;
                cut += one.cutByBudget() > 0 ? 1 : 0;
                all += one.traced();
                decisive += other.traced();
            }
        }
        assertThat(Math.min(detected[0], detected[1])).as("seed %d", seed).isGreaterThan(50);
        assertThat(cut).as("seed %d", seed).isPositive();
        assertThat(decisive).as("rays, seed %d", seed).isLessThan(9 * all / 10);
    }

    @Test
    void skippingNumbersLeadsToTheSameOnesAsDrawingThem() {
        SplittableRandom drawn = new SplittableRandom(-7);
        SkippableRandom skipped = new SkippableRandom(-7);
        for (int i = 0; i < 1000; i++) {
            assertThat(skipped.nextLong()).isEqualTo(drawn.nextLong());
            assertThat(skipped.nextDouble()).isEqualTo(drawn.nextDouble());
            SkippableRandom.skip(skipped, i);
            SkippableRandom.skip(drawn, i);
        }
    }

    /** The numbers of detections differ by less than 4.5 standard deviations, and so does their sum over all places. */
    @Test
    void withoutRaysThatCannotBeDetectedLooksDetectAsOften() {
        long seed = System.nanoTime();
        System.out.println("DecisiveRaysTest: seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        World room = room();
        int undecided = 0;
        double sum = 0.0;
        double variances = 0.0;
        long all = 0;
        long decisive = 0;
        for (int i = 0; i < 40; i++) {
            LevelModel model = LevelModel.DEFAULT
                    .withRays(3, 8)
                    .withAttenuation(0.05 + 0.4 * random.nextDouble())
                    .withLimits(1 + random.nextInt(4), 200_000);
            Position drone = new Position(8 * random.nextDouble() - 4, 2.5 + 3 * random.nextDouble(), -3);
            // In every other case it is just loud enough for the path by floor and eastern wall.
            double length = drone.distance(i % 2 == 0 ? SENSOR : new Position(12, 0, -12));
            double level = 0.2 + model.attenuation() * length + (i % 2 == 0 ? 6 : 1) * random.nextDouble();
            LevelTracer tracer = new LevelTracer(model, SENSOR, 0.4, 0.0, room);
            int[] hits = new int[2];
            for (int look = 0; look < LOOKS; look++) {
                LevelReading one = tracer.trace(drone, level, random, TracedRays.UNTIL_DETECTED, RayRecorder.NONE);
                LevelReading other = tracer.trace(drone, level, random, TracedRays.DECISIVE, RayRecorder.NONE);
                hits[0] += one.detected() ? 1 : 0;
                hits[1] += other.detected() ? 1 : 0;
                all += one.traced();
                decisive += other.traced();
            }
            double p = (hits[0] + hits[1]) / (2.0 * LOOKS);
            double variance = 2.0 * LOOKS * p * (1.0 - p);
            assertThat(Math.abs(hits[0] - hits[1]))
                    .as("seed %d, case %d: %d and %d of %d", seed, i, hits[0], hits[1], LOOKS)
                    .isLessThanOrEqualTo((int) Math.ceil(4.5 * Math.sqrt(variance)));
            undecided += p > 0.02 && p < 0.98 ? 1 : 0;
            sum += hits[0] - hits[1];
            variances += variance;
        }
        assertThat(undecided).as("seed %d", seed).isGreaterThan(10);
        assertThat(Math.abs(sum)).as("seed %d", seed).isLessThan(4.5 * Math.sqrt(variances));
        // The fraction is 0.43, with a standard deviation of 0.035 between seeds.
        assertThat(decisive).as("rays, seed %d", seed).isLessThan(2 * all / 3);
    }
}
