package org.dronewatch.sensor.thermal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.ProbabilityResolution;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * A thermal camera answers for the world and the pointing of each question, whatever it was asked before, and its
 * bounds hold at all headings.
 */
class ThermalStateTest {
    private static final Position REST = new Position(0, 0, 0);
    private static final ThermalSettings CAMERA = ThermalSettings.at(REST).withChance(true);
    private static final List<World> WORLDS = List.of(open(), behind(wall(15, -9, 9), ModelRole.BUILDING));
    private static final List<Optional<Pointing>> POINTINGS = List.of(Optional.empty(), to(40.0, 24.0), to(0.0, 6.0));

    private static Optional<Pointing> to(double azimuth, double fov) {
        Direction direction = new Direction(Math.toRadians(azimuth), 0.0);
        return Optional.of(Pointing.still(direction, Math.toRadians(fov), OptionalInt.empty()));
    }

    /** A question about a drone. */
    enum Question {
        OBSERVATION {
            @Override
            Object ask(ThermalSensor sensor, World world, Optional<Pointing> where, Drone drone) {
                Look look = Look.of(1, "heat", 9, 0.36).withPointing(where);
                return sensor.observe(world, List.of(drone), look).get(0).figures();
            }
        },
        SIGNAL {
            @Override
            Object ask(ThermalSensor sensor, World world, Optional<Pointing> where, Drone drone) {
                return sensor.signal(world, drone, where, new SplittableRandom(1));
            }
        },
        MISS {
            @Override
            Object ask(ThermalSensor sensor, World world, Optional<Pointing> where, Drone drone) {
                return sensor.explainMiss(world, drone, where);
            }
        },
        COARSE_ASSESSMENT {
            @Override
            Object ask(ThermalSensor sensor, World world, Optional<Pointing> where, Drone drone) {
                return sensor.assessCoarsely(
                        world, drone, where, new SplittableRandom(1), ProbabilityResolution.upTo(0.996));
            }
        },
        BOUNDS_AT_ALL_HEADINGS {
            @Override
            Object ask(ThermalSensor sensor, World world, Optional<Pointing> where, Drone drone) {
                return sensor.boundAtAllHeadings(world, drone, drone.origin(), where);
            }
        },
        GREATEST_MARGIN {
            @Override
            Object ask(ThermalSensor sensor, World world, Optional<Pointing> where, Drone drone) {
                return sensor.greatestMarginDb(world, drone, new FlightState(drone.origin(), REST, 0.3), where);
            }
        },
        SAME_AT_ALL_HEADINGS {
            @Override
            Object ask(ThermalSensor sensor, World world, Optional<Pointing> where, Drone drone) {
                return sensor.isSameAtAllHeadings(world, drone, where);
            }
        };

        abstract Object ask(ThermalSensor sensor, World world, Optional<Pointing> where, Drone drone);
    }

    /** The same camera, in one world and the other and turned in between, against a new one for each question. */
    @ParameterizedTest
    @EnumSource
    void anAnswerDoesNotDependOnEarlierQuestions(Question question) {
        Drone drone = cube(new Position(5, 900, 3));
        ThermalSensor one = CAMERA.create();
        Set<Object> answers = new HashSet<>();
        for (int i = 0; i < 12; i++) {
            // Either the world changes or the pointing, never both.
            World world = WORLDS.get((i + 1) / 2 % 2);
            Optional<Pointing> where = POINTINGS.get(i / 2 % 3);
            Object answer = question.ask(one, world, where, drone);
            assertThat(answer).isEqualTo(question.ask(CAMERA.create(), world, where, drone));
            answers.add(answer);
        }
        assertThat(answers).as("different answers").hasSizeGreaterThan(1);
        assertThat(question.ask(one.sibling(), WORLDS.get(0), to(0.0, 6.0), drone))
                .as("a sibling is equivalent")
                .isEqualTo(question.ask(one, WORLDS.get(0), to(0.0, 6.0), drone));
    }

    /** For use by another thread, it is another object. */
    @Test
    void aSiblingIsAnotherCamera() {
        ThermalSensor sensor = CAMERA.create();

        assertThat(sensor.sibling()).isNotNull().isNotSameAs(sensor);
        assertThat(sensor.sibling().settings()).isEqualTo(CAMERA);
    }

    /**
     * The bound is never below the margin of the drone, wherever it is. A cube of 1 m fits into a square of sqrt(3) m
     * that faces the camera: where even that is less than a pixel and a half across, the bound says so.
     */
    @Test
    void theGreatestMarginBoundsEachMarginAndIsNegativeFarAway() {
        long seed = 20261203;
        SplittableRandom random = new SplittableRandom(seed);
        ThermalSensor exact = CAMERA.create();
        ThermalSensor quick = CAMERA.create();
        int above = 0;
        for (int i = 0; i < 150; i++) {
            double range = 20.0 * Math.pow(200.0, random.nextDouble());
            Position at = new Position(
                    0.5 * range * (random.nextDouble() - 0.5), range, 0.4 * range * (random.nextDouble() - 0.5));
            FlightState state = new FlightState(at, REST, 6.0 * random.nextDouble());
            Drone drone = cube(REST);
            World world = WORLDS.get(i % 2);
            Assessment one = exact.assess(world, drone.at(state), Optional.empty(), random);
            double greatest = quick.greatestMarginDb(world, drone, state, Optional.empty());

            assertThat(greatest).as("seed %d, %s", seed, state).isGreaterThanOrEqualTo(one.marginDb());
            above += one.marginDb() > 0.0 ? 1 : 0;
        }
        assertThat(above).as("seed %d", seed).isGreaterThan(10);
        FlightState far =
                new FlightState(new Position(0, 1.2 * Math.sqrt(3.0) * CAMERA.focalLength() / 1.5, 0), REST, 0);
        assertThat(quick.greatestMarginDb(open(), cube(REST), far, Optional.empty()))
                .isNegative();
    }

    /** Where a drone is outside the picture whatever its heading, all headings and speeds have the same assessment. */
    @Test
    void allHeadingsAgreeWhereTheyAreSaidTo() {
        long seed = 20261204;
        SplittableRandom random = new SplittableRandom(seed);
        ThermalSensor sensor = CAMERA.create();
        int same = 0;
        int different = 0;
        for (int i = 0; i < 150; i++) {
            double angle = Math.toRadians(12.0 + 8.0 * (random.nextDouble() - 0.5));
            double range = 5.0 + 40.0 * random.nextDouble();
            Position at = new Position(range * Math.sin(angle), range * Math.cos(angle), 0.3);
            List<Assessment> headings = Stream.of(0.0, 0.4, 0.8, 1.2)
                    .map(heading -> new FlightState(at, new Position(10.0 * heading, 0, 0), heading))
                    .map(state -> sensor.assess(open(), cube(REST).at(state), Optional.empty(), random))
                    .toList();
            String as = "seed %d, %s".formatted(seed, at);
            if (sensor.isSameAtAllHeadings(open(), cube(at), Optional.empty())) {
                assertThat(new HashSet<>(headings)).as(as).hasSize(1);
                assertThat(headings.get(0).cause()).as(as).isEqualTo(Cause.OUT_OF_VIEW);
                same++;
            } else {
                different += new HashSet<>(headings).size() > 1 ? 1 : 0;
            }
        }
        assertThat(same).as("seed %d", seed).isGreaterThan(10);
        assertThat(different).as("seed %d", seed).isGreaterThan(10);
        assertThat(sensor.isSameAtAllHeadings(open(), cube(new Position(0, -200, 0)), Optional.empty()))
                .as("behind the camera")
                .isTrue();
    }
}
