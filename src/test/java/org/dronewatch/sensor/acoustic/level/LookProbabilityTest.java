package org.dronewatch.sensor.acoustic.level;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** The probability of a look, from single rays, against whole looks in a room with walls that transmit sound. */
class LookProbabilityTest {
    private static final double RADIUS = 0.4;
    private static final int LOOKS = 1000;

    private static long newSeed() {
        long seed = LongForm.seed(System.nanoTime());
        System.out.println("LookProbabilityTest: seed " + seed);
        return seed;
    }

    private static Position drone(SplittableRandom random) {
        return new Position(8 * random.nextDouble() - 4, 2.5 + 3 * random.nextDouble(), -3);
    }

    /** A level of which up to 2.2 dB are left at the sensor on the straight way. */
    private static double level(LevelModel model, Position drone, SplittableRandom random) {
        return 0.2 + model.attenuation() * drone.distance(DecisiveRaysTest.SENSOR) + 2 * random.nextDouble();
    }

    /** The differences are less than 4.5 standard deviations, and so is their sum over all places. */
    @Test
    void wholeLooksDetectAsOftenAsSingleRaysSay() {
        long seed = newSeed();
        SplittableRandom random = new SplittableRandom(seed);
        World room = DecisiveRaysTest.room();
        double sum = 0.0;
        double variances = 0.0;
        int undecided = 0;
        int wanted = LongForm.count(4, 100);
        for (int i = 0; i < 40 * wanted && undecided < wanted; i++) {
            LevelModel model = LevelModel.DEFAULT
                    .withRays(1 + random.nextInt(3), 1 + random.nextInt(6))
                    .withTransmittedRays(1 + random.nextInt(3))
                    .withAttenuation(0.05 + 0.4 * random.nextDouble())
                    .withLimits(1 + random.nextInt(2), 200_000);
            Position drone = drone(random);
            double level = level(model, drone, random);
            LevelTracer tracer = new LevelTracer(model, DecisiveRaysTest.SENSOR, RADIUS, 0.0, room);
            int hits = 0;
            for (int look = 0; look < LOOKS; look++) {
                hits += tracer.trace(drone, level, random, TracedRays.UNTIL_DETECTED, RayRecorder.NONE)
                                .detected()
                        ? 1
                        : 0;
            }
            LookProbability.Estimate estimate =
                    new LookProbability(model, DecisiveRaysTest.SENSOR, RADIUS, 0.0, room).of(drone, level, random);
            double value = estimate.value();
            double difference = (double) hits / LOOKS - value;
            double variance =
                    value * (1.0 - value) / LOOKS + estimate.error() * estimate.error() + 1.0 / (LOOKS * LOOKS);
            assertThat(difference * difference)
                    .as("seed %d, case %d: %s of %d, but %s", seed, i, hits, LOOKS, estimate)
                    .isLessThan(4.5 * 4.5 * variance);
            sum += difference;
            variances += variance;
            undecided += value > 0.05 && value < 0.95 ? 1 : 0;
        }
        assertThat(sum * sum).as("seed %d", seed).isLessThan(4.5 * 4.5 * variances);
        assertThat(undecided).as("seed %d", seed).isEqualTo(wanted);
    }

    /**
     * Where the accurate estimate is far from a boundary, the other one is on the same side. If it is as near as six
     * standard errors, less accurate estimates show the side: few of them, three standard errors away, are wrong.
     */
    @Test
    void theSideIsThatOfTheAccurateEstimate() {
        long seed = newSeed();
        SplittableRandom random = new SplittableRandom(seed);
        World room = DecisiveRaysTest.room();
        int uncertain = 0;
        int wrong = 0;
        int cases = LongForm.count(60, 4000);
        for (int i = 0; i < cases; i++) {
            LevelModel model = LevelModel.DEFAULT
                    .withRays(1 + random.nextInt(20), 1 + random.nextInt(6))
                    .withAttenuation(0.05 + 0.4 * random.nextDouble())
                    .withLimits(1 + random.nextInt(2), 200_000);
            Position drone = drone(random);
            double level = level(model, drone, random);
            LookProbability probability = new LookProbability(model, DecisiveRaysTest.SENSOR, RADIUS, 0.0, room);
            LookProbability.Estimate accurate = probability.of(drone, level, random);
            double away = (random.nextBoolean() ? 6.0 : -6.0) * accurate.error();
            boolean isNear = i % 2 == 0;
            double boundary = isNear ? accurate.value() + away : random.nextDouble();
            boundary = Math.max(0.01, Math.min(0.99, boundary));
            LookProbability.Estimate side = probability.sideOf(boundary, drone, level, random);
            String as = "seed %d, case %d: %s, %s, boundary %s".formatted(seed, i, accurate, side, boundary);
            uncertain += accurate.value() > 0.05 && accurate.value() < 0.95 ? 1 : 0;
            boolean isSame = side.value() >= boundary == accurate.value() >= boundary;
            double distance = Math.abs(accurate.value() - boundary);
            if (isNear) {
                wrong += distance > 5.0 * accurate.error() && !isSame ? 1 : 0;
            } else if (distance > 0.2) {
                assertThat(isSame).as(as).isTrue();
            }
        }
        assertThat(uncertain).as("seed %d", seed).isGreaterThan(cases / 10);
        assertThat(wrong).as("seed %d", seed).isLessThanOrEqualTo(1 + cases / 200);
    }

    /** Estimates with other random numbers scatter by no more than their errors, which also decide when rays end. */
    @Test
    void estimatesScatterByNoMoreThanTheirErrors() {
        World room = DecisiveRaysTest.room();
        LevelModel model =
                LevelModel.DEFAULT.withRays(3, 4).withAttenuation(0.2).withLimits(2, 200_000);
        Position drone = new Position(1.0, 4.0, -3.0);
        double level = 0.2 + model.attenuation() * drone.distance(DecisiveRaysTest.SENSOR) + 1.0;
        LookProbability probability = new LookProbability(model, DecisiveRaysTest.SENSOR, RADIUS, 0.0, room);
        int trials = LongForm.count(40, 400);
        double sum = 0.0;
        double squares = 0.0;
        double stated = 0.0;
        for (int seed = 0; seed < trials; seed++) {
            LookProbability.Estimate estimate = probability.of(drone, level, new SplittableRandom(seed));
            sum += estimate.value();
            squares += estimate.value() * estimate.value();
            stated += estimate.error() * estimate.error();
        }
        double mean = sum / trials;
        double scatter = Math.sqrt((squares - trials * mean * mean) / (trials - 1));
        assertThat(mean).isBetween(0.05, 0.95);
        assertThat(scatter / Math.sqrt(stated / trials)).isBetween(0.2, 1.1);
    }

    /** Of a square, the part that 4,096 pairs find differs from its area by a few pairs, not by a few dozen. */
    @Test
    void evenPairsFindAnAreaMoreAccuratelyThanIndependentOnes() {
        SplittableRandom random = new SplittableRandom(3);
        double squares = 0.0;
        for (int i = 0; i < 100; i++) {
            EvenPairs pairs = new EvenPairs(random);
            int inside = 0;
            for (int pair = 0; pair < 4096; pair++) {
                double first = pairs.nextDouble() - 0.5;
                double second = pairs.nextDouble() - 0.5;
                inside += first * first + second * second < 0.04 ? 1 : 0;
            }
            double error = inside - 4096 * Math.PI * 0.04;
            squares += error * error;
        }
        double independent = Math.sqrt(4096 * Math.PI * 0.04 * (1.0 - Math.PI * 0.04));
        assertThat(independent).isBetween(21.0, 22.0);
        assertThat(Math.sqrt(squares / 100)).isLessThan(independent / 4.0);
    }
}
