package org.dronewatch.sensor.acoustic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.behindBelow;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.random.RandomGenerator;
import java.util.stream.DoubleStream;
import org.dronewatch.Thorough;
import org.dronewatch.Wilson;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.ProbabilityResolution;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Criterion;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a microphone has of a drone, how sure that is, and why it is not enough. */
class AcousticAssessmentTest {
    private static final AcousticSettings MICROPHONE = AcousticSettings.at(new Position(0, 0, 0));

    /** One ray, whose first surface sends one ray on and one to the microphone. */
    private static final AcousticSettings ONE_RAY =
            MICROPHONE.withPropagation(LevelModel.DEFAULT.withRays(1, 2).withLimits(1, 1000));

    private static final AcousticSettings ENERGY =
            MICROPHONE.withPropagation(EnergyModel.DEFAULT.withRays(2000).withAccuracy(0.0));

    private static Drone drone(double north) {
        return cube(new Position(0, north, 0));
    }

    /** How far the drone is heard by the level model, m: what is left over the noise of 0 dB and the threshold. */
    private static double reach() {
        return (drone(1).soundLevel() - 15.0) / 0.05;
    }

    private static Assessment assessed(AcousticSettings settings, World world, Drone drone, long seed) {
        return settings.create()
                .assess(
                        world,
                        drone,
                        Optional.empty(),
                        Look.of(seed, "sensor", 0, 10.0).random("drone", RaySensor.RAYS));
    }

    @Test
    void byTheLevelModelItIsCertainInTheOpenOnEitherSideOfItsRange() {
        Assessment near = assess(MICROPHONE, open(), drone(0.99 * reach()));
        assertThat(near.cause()).isEqualTo(Cause.DETECTED);
        assertThat(near.probability()).isEqualTo(1.0);
        assertThat(near.margin()).isCloseTo(0.01 * reach() * 0.05, within(1e-9));
        assertThat(near.isEstimated()).isFalse();

        Assessment far = assess(MICROPHONE, open(), drone(1.01 * reach()));
        assertThat(far.cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(far.probability()).isZero();
        assertThat(far.margin()).isCloseTo(-0.01 * reach() * 0.05, within(1e-9));
        assertThat(far.isEstimated()).isFalse();
    }

    @ParameterizedTest
    @EnumSource(ModelRole.class)
    void aDroneBehindAWallIsHiddenOnlyWithinTheRangeOfTheOpen(ModelRole role) {
        World world = behind(wall(50, -99, 99), role);

        Assessment hidden = assess(ONE_RAY, world, drone(100));
        assertThat(hidden.cause()).isEqualTo(Cause.hiddenBy(role));
        assertThat(hidden.obstacle().orElseThrow().model().file()).isEqualTo("wall.obj");
        assertThat(hidden.probability()).isZero();
        assertThat(hidden.isEstimated()).as("none of 32 is an estimate").isTrue();
        assertThat(assess(ONE_RAY, world, drone(1.01 * reach())).cause()).isEqualTo(Cause.TOO_WEAK);
    }

    /** Below a ceiling, a drone behind a wall is heard if the one ray goes up and not too far. */
    @Thorough
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theFractionOfTracesIsThatOfLooksAndScattersAsItSays(boolean isCoarse) {
        World world = behindBelow(wall(50, -99, 9), 30);
        AcousticSensor sensor = ONE_RAY.create();
        int looks = 3000;
        int hits = 0;
        for (int i = 0; i < looks; i++) {
            Look look = Look.of(i, "sensor", 0, 10.0);
            hits += sensor.observe(world, List.of(drone(100)), look).get(0).isDetected() ? 1 : 0;
        }
        Assessment[] fields = new Assessment[300];
        for (int i = 0; i < fields.length; i++) {
            Look look = Look.of(50_000 + i, "sensor", 0, 10.0);
            RandomGenerator rays = look.random("drone", RaySensor.RAYS);
            fields[i] = isCoarse
                    ? sensor.assessCoarsely(world, drone(100), Optional.empty(), rays, ProbabilityResolution.upTo(0.99))
                    : sensor.assess(world, drone(100), Optional.empty(), rays);
            assertThat(fields[i].isEstimated()).isTrue();
            assertThat(fields[i].cause() == Cause.DETECTED).isEqualTo(fields[i].probability() >= 0.5);
            assertThat(fields[i].cause()).isIn(Cause.DETECTED, Cause.HIDDEN_BY_BUILDING);
        }
        double[] probabilities = values(fields, Assessment::probability);
        double[] interval = Wilson.interval(hits, looks, 4.0);
        assertThat(mean(probabilities)).isBetween(interval[0], interval[1]).isBetween(0.15, 0.85);
        double stated = mean(values(fields, Assessment::probabilityError));
        // A coarse assessment refines the fraction; its error is that of as many independent rays, at most.
        assertThat(stated).isBetween(isCoarse ? 0.002 : 0.05, isCoarse ? 0.02 : 0.1);
        assertThat(spread(probabilities) / stated).isBetween(isCoarse ? 0.1 : 0.8, 1.25);
    }

    private static double[] values(Assessment[] fields, ToDoubleFunction<Assessment> value) {
        return Arrays.stream(fields).mapToDouble(value).toArray();
    }

    private static double mean(double[] values) {
        return DoubleStream.of(values).average().orElseThrow();
    }

    private static double spread(double[] values) {
        double mean = mean(values);
        double squares =
                DoubleStream.of(values).map(v -> (v - mean) * (v - mean)).sum();
        return Math.sqrt(squares / (values.length - 1));
    }

    @Test
    void byTheLevelModelACertainAssessmentIsTheLook() {
        for (double north : new double[] {10, 300, 0.9 * reach()}) {
            Observation look = look(MICROPHONE, open(), drone(north), 4);
            assertThat(assessed(MICROPHONE, open(), drone(north), 4).quantity()).isEqualTo(look.value());
            assertThat(look.isDetected()).isTrue();
        }
    }

    @ParameterizedTest
    @EnumSource(Criterion.class)
    void byTheEnergyModelAnAssessmentIsTheLookToTheLastBit(Criterion criterion) {
        World world = behindBelow(wall(50, -99, 9), 30);
        AcousticSettings settings =
                MICROPHONE.withPropagation(EnergyModel.DEFAULT.withRays(1500).withCriterion(criterion));
        for (int seed = 0; seed < 5; seed++) {
            Drone drone = drone(60 + 40 * seed);
            Observation look = look(settings, world, drone, seed);
            Assessment one = assessed(settings, world, drone, seed);
            assertThat(one.quantity()).isEqualTo(look.value());
            assertThat(one.threshold()).isEqualTo(look.threshold());
            assertThat(one.probability()).isEqualTo(look.isDetected() ? 1.0 : 0.0);
            assertThat(one.standardError()).isEqualTo(look.figures().get("standard_error_db"));
            assertThat(one.standardError()).isPositive();
        }
    }

    @Test
    void byTheEnergyModelTheLevelScattersAsItsStandardErrorSays() {
        World world = behindBelow(wall(50, -99, 9), 30);
        double[] levels = new double[150];
        double stated = 0.0;
        for (int i = 0; i < levels.length; i++) {
            Assessment one = assessed(ENERGY, world, drone(100), i);
            levels[i] = one.quantity();
            stated += one.standardError() / levels.length;
        }
        assertThat(spread(levels) / stated).isBetween(0.8, 1.25);
    }

    @ParameterizedTest
    @EnumSource(ModelRole.class)
    void byTheEnergyModelADroneIsHiddenOnlyIfItWouldBeHeardInTheOpen(ModelRole role) {
        World world = behind(wall(50, -99, 9), role);
        double inTheOpen = assess(ENERGY, open(), drone(100)).margin();
        double behind = assess(ENERGY, world, drone(100)).margin();
        assertThat(behind).isLessThan(inTheOpen - 5.0);

        assertThat(assess(ENERGY.withThreshold(15 + behind - 1), world, drone(100))
                        .cause())
                .isEqualTo(Cause.DETECTED);
        AcousticSettings between = ENERGY.withThreshold(15 + 0.5 * (behind + inTheOpen));
        assertThat(assess(between, open(), drone(100)).cause()).isEqualTo(Cause.DETECTED);
        assertThat(assess(between, world, drone(100)).cause()).isEqualTo(Cause.hiddenBy(role));
        Assessment weak = assess(ENERGY.withThreshold(15 + inTheOpen + 1), world, drone(100));
        assertThat(weak.cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(weak.margin()).isCloseTo(behind - inTheOpen - 1, within(0.5));
    }
}
