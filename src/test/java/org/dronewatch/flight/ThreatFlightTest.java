package org.dronewatch.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.assertj.core.data.Offset;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.Ground;
import org.dronewatch.world.GroundPoint;
import org.dronewatch.world.World;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Flights of those who mean harm: low over the ground, out of the sky, up from behind cover. */
class ThreatFlightTest {
    private static final Offset<Double> EXACT = within(1e-9);
    private static final double SPEED = 12.0;
    private static final double ACCELERATION = 3.0;
    private static World hill;

    @BeforeAll
    static void loadTheHill() {
        hill = World.of(new ModelLoader(Path.of("."))
                .load(ModelSettings.packaged("hill.obj"))
                .mesh());
    }

    private static FlightPath fly(FlightPathSettings flight, Ground ground) {
        return flight.create(SPEED, ACCELERATION, ground);
    }

    private static Ground flat(double z) {
        return (x, y) -> OptionalDouble.of(z);
    }

    private static TerrainFollowing north(double length, double height, String steepest) {
        return new TerrainFollowing(
                List.of(new GroundPoint(0, 0), new GroundPoint(0, length)), height, Quantity.ANGLE.parse(steepest));
    }

    /** When a path that ends stays where it ends, s. */
    private static double duration(FlightPath path, double most) {
        double flying = 0.0;
        double there = most;
        for (int i = 0; i < 60; i++) {
            double middle = 0.5 * (flying + there);
            if (path.at(middle).velocity().length() > 0.0) {
                flying = middle;
            } else {
                there = middle;
            }
        }
        return there;
    }

    @ParameterizedTest
    @ValueSource(strings = {"10 deg", "25 deg", "45 deg", "80 deg"})
    void overTheHillItIsNeverLowerThanItsHeightNorSteeperThanItMayNorSlower(String steepest) {
        long seed = 20_260_701;
        SplittableRandom random = new SplittableRandom(seed);
        double height = 7.0;
        TerrainFollowing flight = new TerrainFollowing(
                List.of(
                        new GroundPoint(-700, -650),
                        new GroundPoint(300, 500),
                        new GroundPoint(-200, 480),
                        new GroundPoint(40, -700)),
                height,
                Quantity.ANGLE.parse(steepest));
        FlightPath path = fly(flight, hill.newGround());
        Ground ground = hill.newGround();
        double end = duration(path, 1000.0);
        double steepestSine = Math.sin(flight.maxFlightPathAngle());
        for (int i = 0; i < 10_000; i++) {
            double time = end * random.nextDouble();
            FlightState state = path.at(time);
            Position at = state.position();
            double below = ground.height(at.x(), at.y()).orElseThrow();
            // Where the land has several ridges within half a metre, a few millimetres may be missing.
            assertThat(at.z() - below).as("at %s, seed %d", at, seed).isGreaterThan(height - 0.006);
            assertThat(Math.abs(state.velocity().z()) / SPEED).isLessThan(steepestSine + 1e-9);
            assertThat(state.velocity().length()).isCloseTo(SPEED, EXACT);
            assertThat(Math.sin(state.heading()) * state.velocity().y())
                    .isCloseTo(Math.cos(state.heading()) * state.velocity().x(), within(1e-6));
        }
    }

    /** What it says of its velocity is what its places do. */
    @Test
    void overTheHillItsSpeedThroughSpaceIsConstant() {
        FlightPath path = fly(LowApproach.from(new GroundPoint(0, 0), 700, 5), hill.newGround());
        double end = duration(path, 1000.0);
        for (double time = 0.0; time < end - 0.01; time += 0.0173) {
            double step = path.at(time + 0.01).position().distance(path.at(time).position());
            // Where it bends between two cuts the straight way is a little shorter.
            assertThat(step / 0.01).isBetween(0.9 * SPEED, SPEED + 1e-6);
        }
        double length = 0.0;
        for (double time = 0.0; time < end; time += 1e-3) {
            length += path.at(time + 1e-3).position().distance(path.at(time).position());
        }
        assertThat(length / end).isCloseTo(SPEED, within(0.01 * SPEED));
    }

    @Test
    void overFlatGroundItFliesLevelAndStaysAtTheEnd() {
        FlightPath path = fly(north(100.25, 12, "45 deg"), flat(-3));

        for (double time = 0.0; time < 8.0; time += 0.37) {
            assertThat(path.at(time).position().distance(new Position(0, SPEED * time, 9)))
                    .isCloseTo(0.0, EXACT);
            assertThat(path.at(time).velocity().distance(new Position(0, SPEED, 0)))
                    .isCloseTo(0.0, EXACT);
        }
        FlightState last = path.at(100.0);
        assertThat(last.position()).isEqualTo(new Position(0, 100.25, 9));
        assertThat(last.velocity().length()).isZero();
        assertThat(last.heading()).isZero();
    }

    /** A block of 20 m from 100 m to 120 m north: it climbs and descends along straight lines at the largest angle. */
    @ParameterizedTest
    @ValueSource(strings = {"30 deg", "45 deg", "85 deg"})
    void beforeAndBehindAWallTheProfileIsTheEnvelope(String steepest) {
        double slope = Math.tan(Quantity.ANGLE.parse(steepest));
        Ground block = (x, y) -> OptionalDouble.of(y >= 100 && y <= 120 ? 20 : 0);
        FlightPath path = fly(north(300, 5, steepest), block);
        double end = duration(path, 1000.0);
        for (double time = 0.0; time < end; time += 0.05) {
            Position at = path.at(time).position();
            double away = Math.max(0.0, Math.max(100 - at.y(), at.y() - 120));
            double envelope = 5 + Math.max(0.0, 20 - slope * away);
            // The wall counts from the cut before it on, and the way bends at cuts only: half a metre each.
            double widened = 5 + Math.max(0.0, 20 - slope * Math.max(0.0, away - 2 * GroundTrack.STEP));
            assertThat(at.z()).isBetween(envelope - 1e-9, widened + 1e-9);
        }
        // Level, up at the angle, level, down, level: 300 m on the plan, of which the ramps take 20 m / slope each.
        double ramp = 20 / slope;
        double length = 300 - 2 * ramp + 2 * Math.hypot(20, ramp);
        assertThat(end).isCloseTo(length / SPEED, within(2 * GroundTrack.STEP / SPEED));
    }

    /** A gable whose ridge lies in the middle between two cuts, where no height is asked for. */
    @Test
    void aRidgeBetweenTwoCutsCounts() {
        Ground gable = (x, y) -> OptionalDouble.of(Math.max(0.0, 10 - 0.6 * Math.abs(y - 50.25)));
        FlightPath path = fly(north(100, 5, "45 deg"), gable);
        for (double time = 0.0; time < 9.0; time += 0.003) {
            Position at = path.at(time).position();
            double over = at.z() - gable.height(at.x(), at.y()).orElseThrow();
            // Land may count as up to a cut before and behind: 0.6 times a cut or two.
            assertThat(over).isBetween(5 - 1e-9, 5 + 0.6 * 2 * GroundTrack.STEP + 1e-9);
        }
    }

    @Test
    void whereNothingIsBelowTheNearestKnownHeightCounts() {
        Ground island = (x, y) -> y < 40
                ? OptionalDouble.empty()
                : y <= 60 ? OptionalDouble.of(2) : y < 80 ? OptionalDouble.empty() : OptionalDouble.of(4);
        FlightPath path = fly(north(200, 10, "45 deg"), island);

        assertThat(path.at(0.0).position().z()).isCloseTo(12, EXACT);
        assertThat(path.at(65 / SPEED).position().z()).isCloseTo(12, EXACT);
        assertThat(path.at(78 / SPEED).position().z()).isCloseTo(14, EXACT);

        assertThatIllegalArgumentException()
                .isThrownBy(() -> fly(north(200, 10, "45 deg"), Ground.NONE))
                .withMessage("there is no ground anywhere below the path of 200.0 m for the drone to follow");
    }

    @Test
    void aLowApproachComesFromItsBearingAndStopsBeforeItsTarget() {
        LowApproach flight = new LowApproach(new GroundPoint(10, 20), Math.PI / 2, 300, 8, 50);
        FlightPath path = fly(flight, flat(1));

        assertThat(path.at(0.0).position().distance(new Position(310, 20, 9))).isCloseTo(0.0, EXACT);
        assertThat(path.at(0.0).heading()).isCloseTo(-Math.PI / 2, EXACT);
        assertThat(path.at(100 / SPEED).position().distance(new Position(210, 20, 9)))
                .isCloseTo(0.0, within(1e-6));
        assertThat(path.at(999).position().distance(new Position(60, 20, 9))).isCloseTo(0.0, within(1e-9));
    }

    /** 100 m high at 30 degrees: 100 sqrt(3) m level and 200 m through the air. */
    @Test
    void aDiveCruisesLevelAndThenGoesStraightIntoItsTarget() {
        Position target = new Position(5, -5, 2);
        FlightPath path = fly(new Dive(target, Math.PI, 400, 100, Math.toRadians(30)), Ground.NONE);
        double begins = (400 - 100 * Math.sqrt(3)) / SPEED;
        double ends = begins + 200 / SPEED;

        assertThat(path.at(0.0).position().distance(new Position(5, -405, 102))).isCloseTo(0.0, EXACT);
        assertThat(path.at(begins - 1e-6).velocity().distance(new Position(0, SPEED, 0)))
                .isCloseTo(0.0, EXACT);
        Position velocity = path.at(begins + 1e-6).velocity();
        assertThat(velocity.length()).isCloseTo(SPEED, EXACT);
        assertThat(Math.toDegrees(Math.asin(-velocity.z() / SPEED))).isCloseTo(30, EXACT);
        assertThat(path.at(ends - 1.0).position().distance(target)).isCloseTo(SPEED, within(1e-6));
        assertThat(path.at(ends + 1e-6).position()).isEqualTo(target);
        assertThat(path.at(ends + 1e-6).velocity().length()).isZero();
        assertThat(path.at(ends + 99).heading()).isCloseTo(0.0, EXACT);
    }

    @Test
    void aDiveMayGoStraightDown() {
        Position target = new Position(0, 0, 0);
        Dive flight = new Dive(target, Math.PI / 2, 60, 30, Quantity.ANGLE.parse("90 deg"));
        FlightPath path = fly(flight, Ground.NONE);

        assertThat(path.at(5.0).position().distance(new Position(0, 0, 30))).isCloseTo(0.0, EXACT);
        assertThat(path.at(6.0).position().distance(new Position(0, 0, 18))).isCloseTo(0.0, EXACT);
        assertThat(path.at(6.0).heading()).isCloseTo(-Math.PI / 2, EXACT);
    }

    /** 10 m at 3 m/s2: the middle is reached at sqrt(10) m/s * sqrt(3), after sqrt(10 / 3) s. */
    @Test
    void aPopUpHidesAndThenRises() {
        Position place = new Position(1, 2, 3);
        FlightPath path = fly(new PopUp(place, 20, 10), Ground.NONE);
        double half = Math.sqrt(10 / ACCELERATION);

        assertThat(path.at(0.0).position()).isEqualTo(place);
        assertThat(path.at(20.0).position()).isEqualTo(place);
        assertThat(path.at(20.0).velocity().length()).isZero();
        assertThat(path.at(20 + half).position().z()).isCloseTo(8, EXACT);
        assertThat(path.at(20 + half).velocity().z()).isCloseTo(Math.sqrt(10 * ACCELERATION), EXACT);
        assertThat(path.at(20 + 2 * half).position().z()).isCloseTo(13, EXACT);
        assertThat(path.at(999.0).position()).isEqualTo(new Position(1, 2, 13));
        assertThat(path.at(999.0).velocity().length()).isZero();
    }

    @Test
    void whatIsOutOfItsLimitsIsRefused() {
        GroundPoint here = new GroundPoint(0, 0);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> north(60_000, 10, "45 deg"))
                .withMessage("points: distance to point 1 60000 m must be 0.001 to 50000");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> TerrainFollowing.over(List.of(here, new GroundPoint(30_000, 0), here), 10))
                .withMessage("points: path of 60000.0 m must be at most 50000.0 m long");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> TerrainFollowing.over(List.of(here), 10))
                .withMessage("points has 1 point but needs 2 or more");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> TerrainFollowing.over(List.of(here, here), 10))
                .withMessageContaining("points: distance to point 1 0 m must be");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> north(100, 10, "86 deg"))
                .withMessageContaining("maxFlightPathAngle");
        assertThat(north(100, 10, "5 deg").maxFlightPathAngle()).isPositive();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new LowApproach(here, 0, 100, 5, 100))
                .withMessage("standoff 100.0 m must be less than distance 100.0 m by 0.001 m or more");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Dive(new Position(0, 0, 0), 0, 90, 100, Math.PI / 4))
                .withMessage(
                        "distance 90.0 m must be above 100.0 m, the distance at which the dive from height 100.0 m begins");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Dive(new Position(0, 0, 0), 0, 9000, 100, 0.1))
                .withMessageContaining("angle 5.729578 deg (0.1 rad) must be 10 to 90 deg");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new PopUp(new Position(0, 0, 0), -1, 10))
                .withMessage("hoverTime -1 s must be 0 to 1e6");
    }
}
