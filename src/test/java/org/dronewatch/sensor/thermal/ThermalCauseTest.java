package org.dronewatch.sensor.thermal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Discrimination;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.ProbabilityResolution;
import org.dronewatch.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Drones at the upper edge of a wall: why a thermal camera misses them, and how few rays it needs to know. */
class ThermalCauseTest {
    private static final Position REST = new Position(0, 0, 0);
    private static final double NORTH = 15.0;
    private static final double TOP = 0.05;
    private static final double HIGH = 0.996;

    /** The area is summed in another order where rays are traced until it is enough. */
    private static final double ROUNDING = 1e-12;

    private static final World OPEN = open();
    private static final World WALL = behind(wall(NORTH, -9, TOP), ModelRole.BUILDING);
    private static final ThermalSettings CAMERA = ThermalSettings.at(REST);
    private static final Drone CUBE = cube(REST);

    static Stream<ThermalSettings> cameras() {
        return Stream.of(
                CAMERA,
                CAMERA.withChance(true),
                CAMERA.withTask(Discrimination.RECOGNITION),
                CAMERA.withPointTargets(PointTargets.DEFAULT),
                CAMERA.withPointTargets(PointTargets.DEFAULT).withChance(true));
    }

    /** The range at which a cube, seen straight on and whole, is just detected. */
    private static double reach(ThermalSettings camera) {
        ThermalSensor sensor = camera.create();
        double low = 50.0;
        double high = 20_000.0;
        while (high - low > 1.0) {
            double middle = 0.5 * (low + high);
            Assessment one = assess(sensor, OPEN, cube(new Position(0, middle, 0)));
            boolean isDetected = one.cause() == Cause.DETECTED;
            low = isDetected ? middle : low;
            high = isDetected ? high : middle;
        }
        return low;
    }

    private static Assessment assess(ThermalSensor sensor, World world, Drone drone) {
        return sensor.assess(world, drone, Optional.empty(), new SplittableRandom(1));
    }

    private static Assessment coarsely(ThermalSensor sensor, World world, Drone drone, double high) {
        return sensor.assessCoarsely(
                world, drone, Optional.empty(), new SplittableRandom(1), ProbabilityResolution.upTo(high));
    }

    /** Bounds a drone until the masks of its direction are made, so that they serve the next assessment. */
    private static void lookUp(ThermalSensor sensor, FlightState state) {
        for (int time = 0; time < 4; time++) {
            sensor.bound(WALL, CUBE, state, Optional.empty(), p -> (int) (250 * p));
        }
    }

    /** A level cube whose middle is about as high as the line of sight over the edge of the wall. */
    private static FlightState atTheEdge(SplittableRandom random, double range, double most) {
        double up = TOP * range / NORTH + most * (2.0 * random.nextDouble() - 1.0);
        Position at = new Position(0.2 * range * (random.nextDouble() - 0.5), range, up);
        return new FlightState(at, REST, 6.0 * random.nextDouble());
    }

    /** A cube that is missed is hidden if none of it is visible, or if the same cube is detected without the wall. */
    @ParameterizedTest
    @MethodSource("cameras")
    void aDroneIsHiddenIfItWouldBeDetectedWithoutTheWallOrNothingOfItIsSeen(ThermalSettings camera) {
        long seed = 20261201;
        SplittableRandom random = new SplittableRandom(seed);
        double reach = reach(camera);
        ThermalSensor exact = camera.create();
        ThermalSensor coarse = camera.create();
        ThermalSensor masked = camera.create();
        ThermalSensor inTheOpen = camera.create();
        Map<Cause, Integer> partly = new EnumMap<>(Cause.class);
        for (int i = 0; i < 250; i++) {
            FlightState state = atTheEdge(random, reach * (0.7 + 0.8 * random.nextDouble()), 0.9);
            Drone drone = CUBE.at(state);
            Assessment all = assess(exact, WALL, drone);
            boolean isNothing = exact.observe(WALL, List.of(drone), Look.of(1, "heat", 100, 4.0))
                            .get(0)
                            .figures()
                            .get("pixels")
                    == 0.0;
            boolean isDetectedInTheOpen = assess(inTheOpen, OPEN, drone).cause() == Cause.DETECTED;
            Cause missed = isNothing || isDetectedInTheOpen ? Cause.HIDDEN_BY_BUILDING : Cause.TOO_WEAK;
            String as = "seed %d, %s".formatted(seed, state);
            if (all.quantity() < all.threshold()) {
                assertThat(all.cause()).as(as).isEqualTo(missed);
                partly.merge(missed, isNothing ? 0 : 1, Integer::sum);
            } else {
                assertThat(all.cause()).as(as).isEqualTo(Cause.DETECTED);
            }
            lookUp(masked, state);
            assertThat(coarsely(coarse, WALL, drone, HIGH).cause()).as(as).isEqualTo(all.cause());
            assertThat(coarsely(masked, WALL, drone, HIGH).cause())
                    .as("with masks, " + as)
                    .isEqualTo(all.cause());
        }
        assertThat(partly.get(Cause.HIDDEN_BY_BUILDING)).as("seed %d", seed).isGreaterThan(20);
        assertThat(partly.get(Cause.TOO_WEAK)).as("seed %d", seed).isGreaterThan(20);
    }

    /**
     * Near and far, a few rays find the same cause and the same probability to the resolution: 1 only where it is 1.
     * For large drones, they stop before they have found all of the area.
     */
    @ParameterizedTest
    @MethodSource("cameras")
    void fewerRaysChangeNothingThatIsResolved(ThermalSettings camera) {
        long seed = 20261202;
        SplittableRandom random = new SplittableRandom(seed);
        double reach = reach(camera);
        ThermalSensor exact = camera.create();
        ThermalSensor coarse = camera.create();
        ThermalSensor masked = camera.create();
        int certain = 0;
        int earlier = 0;
        for (int i = 0; i < 200; i++) {
            double range = 1.3 * reach * Math.pow(20.0 / reach, random.nextDouble());
            FlightState state = atTheEdge(random, range, 0.9);
            Drone drone = CUBE.at(state);
            Assessment all = assess(exact, WALL, drone);
            lookUp(masked, state);
            for (Assessment one : List.of(coarsely(coarse, WALL, drone, HIGH), coarsely(masked, WALL, drone, HIGH))) {
                String as = "seed %d, %s".formatted(seed, state);
                assertThat(one.explanation()).as(as).isEqualTo(all.explanation());
                if (all.probability() < HIGH || all.probability() == 1.0) {
                    assertThat(one.probability()).as(as).isEqualTo(all.probability());
                } else {
                    assertThat(one.probability()).as(as).isBetween(HIGH, Math.nextDown(1.0));
                }
                assertThat(one.quantity()).as(as).isLessThan(all.quantity() + ROUNDING);
                certain += all.probability() == 1.0 ? 1 : 0;
                earlier += one.quantity() < all.quantity() - ROUNDING ? 1 : 0;
            }
        }
        assertThat(certain).as("seed %d", seed).isGreaterThan(20);
        // A spot by chance is a matter of all or nothing: what suffices is certain.
        if (camera.pointTargets().isEmpty() || !camera.byChance()) {
            assertThat(earlier).as("seed %d", seed).isGreaterThan(20);
        }
    }
}
