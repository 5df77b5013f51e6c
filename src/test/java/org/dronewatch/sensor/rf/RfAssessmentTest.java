package org.dronewatch.sensor.rf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.block;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.SplittableRandom;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.radio.LinearPolarisation;
import org.dronewatch.sensor.radio.RadioPath;
import org.dronewatch.sensor.radio.ReflectingGround;
import org.dronewatch.sensor.radio.TwoRays;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What a radio receiver has of a drone, and why that is not enough. */
class RfAssessmentTest {
    private static final Position ANTENNA = new Position(0, 0, 0);
    private static final RfSettings RECEIVER = RfSettings.at(ANTENNA);

    private static Drone emitting(Position place, RadioLink link) {
        DroneSettings settings =
                DroneSettings.of(ModelSettings.of("cube.obj"), Hover.at(place)).withRadio(link);
        return cube(settings, place, new Position(0, 0, 0));
    }

    private static Drone emitting(Position place) {
        return emitting(place, RadioLink.DEFAULT);
    }

    private static Drone emitting(double north) {
        return emitting(new Position(0, north, 0), RadioLink.DEFAULT);
    }

    /** How far the default link is heard in free space, m. */
    private static double reach() {
        double room = 20.0 - RECEIVER.noise() - RECEIVER.threshold();
        return Math.pow(10.0, (room - RadioPath.freeSpaceLoss(1.0, 2.4e9)) / 20.0);
    }

    @Test
    void inTheOpenItIsHeardUpToTheRangeOfTheLinkBudget() {
        assertThat(assess(RECEIVER, open(), emitting(0.99 * reach())).cause()).isEqualTo(Cause.DETECTED);
        Assessment weak = assess(RECEIVER, open(), emitting(1.1 * reach()));
        assertThat(weak.cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(weak.margin()).isCloseTo(-20.0 * Math.log10(1.1), within(1e-9));
        assertThat(weak.probability()).isZero();
    }

    @ParameterizedTest
    @EnumSource(
            value = RadioLink.Control.class,
            mode = EnumSource.Mode.EXCLUDE,
            names = {"RADIO"})
    void aDroneThatEmitsNothingIsSilentEvenBehindAWall(RadioLink.Control control) {
        Drone drone = emitting(new Position(0, 100, 0), RadioLink.DEFAULT.withControl(control));

        assertThat(assess(RECEIVER, open(), drone).cause()).isEqualTo(Cause.SILENT);
        assertThat(assess(RECEIVER.withFrequencies(5e9, 6e9), open(), drone).limit())
                .as("on no frequency would it be received")
                .isEmpty();
        assertThat(assess(RECEIVER, behind(wall(50, -9, 9), ModelRole.TERRAIN), drone)
                        .cause())
                .isEqualTo(Cause.SILENT);
    }

    @Test
    void aCarrierThatItDoesNotReceiveIsSilence() {
        Drone drone = emitting(new Position(0, 100, 0), RadioLink.DEFAULT.withFrequency(433e6));

        assertThat(assess(RECEIVER, open(), drone).cause()).isEqualTo(Cause.DETECTED);
        Assessment above = assess(RECEIVER.withFrequencies(2e9, 6e9), open(), drone);
        assertThat(above.cause()).isEqualTo(Cause.SILENT);
        assertThat(above.limit()).hasValue(2e9);
        assertThat(assess(RECEIVER.withFrequencies(1e8, 4e8), open(), drone).limit())
                .hasValue(4e8);
    }

    @ParameterizedTest
    @EnumSource(ModelRole.class)
    void aDroneIsHiddenOnlyWhereTheEdgeTakesWhatIsMissing(ModelRole role) {
        World world = behind(block(500, 0.1), role);

        assertThat(assess(RECEIVER, world, emitting(0.2 * reach())).cause()).isEqualTo(Cause.DETECTED);
        Assessment hidden = assess(RECEIVER, world, emitting(0.9 * reach()));
        assertThat(hidden.cause()).isEqualTo(Cause.hiddenBy(role));
        assertThat(hidden.obstacle().orElseThrow().model().file()).isEqualTo("wall.obj");
        assertThat(hidden.quantity()).isFinite();
        assertThat(assess(RECEIVER, world, emitting(1.1 * reach())).cause()).isEqualTo(Cause.TOO_WEAK);
    }

    /** An edge just below the line takes 6 dB without touching it. */
    @Test
    void anEdgeBelowTheLineHidesToo() {
        World world = behind(block(500, -0.01), ModelRole.VEGETATION);

        Assessment hidden = assess(RECEIVER, world, emitting(0.9 * reach()));

        assertThat(hidden.cause()).isEqualTo(Cause.HIDDEN_BY_VEGETATION);
        assertThat(hidden.obstacle().orElseThrow().model().file()).isEqualTo("wall.obj");
    }

    /** The pilot is nearer and stronger: what hides the pilot counts. */
    @Test
    void theStrongerOfDroneAndPilotSaysWhatHides() {
        World world = behind(block(500, 99), ModelRole.BUILDING);
        Drone drone = emitting(
                new Position(0, -3 * reach(), 0), RadioLink.DEFAULT.withPilot(new Position(0, 0.9 * reach(), 0)));

        assertThat(assess(RECEIVER, world, drone).cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(assess(RECEIVER, open(), drone).cause()).isEqualTo(Cause.DETECTED);
    }

    @Test
    void aLookAndAnAssessmentAgreeToTheLastBit() {
        SplittableRandom random = new SplittableRandom(3);
        World world = behind(block(300, 5), ModelRole.TERRAIN);
        for (int i = 0; i < 50; i++) {
            Position place = new Position(
                    random.nextDouble(-500, 500), random.nextDouble(0, 2 * reach()), random.nextDouble(0, 200));
            Drone drone = emitting(place, RadioLink.DEFAULT);
            Observation look = look(RECEIVER, world, drone, i);
            Assessment one = assess(RECEIVER, world, drone);
            assertThat(one.quantity()).isEqualTo(look.value());
            assertThat(one.threshold()).isEqualTo(look.threshold());
            assertThat(one.probability()).isEqualTo(look.isDetected() ? 1.0 : 0.0);
            assertThat(one.cause() == Cause.DETECTED).isEqualTo(look.isDetected());
        }
    }

    /**
     * A knife edge on the line takes 6.03 dB (ITU-R P.526, v = 0), and what is far in its shadow 34 dB: an allowance of
     * 12 dB that includes edges covers the first, and not the second.
     */
    @Test
    void ofAnAllowanceThatIncludesEdgesTheGreaterLossCounts() {
        RfSettings added = RECEIVER.withClutter(12.0);
        RfSettings included = added.withClutterIncludingEdges(true);
        Drone drone = emitting(0.2 * reach());
        double free = look(RECEIVER, open(), drone, 1).value();
        World grazed = behind(wall(300, -999.0, 0.0), ModelRole.BUILDING);
        World shadow = behind(block(300, 40.0), ModelRole.BUILDING);
        double low = free - look(RECEIVER, grazed, drone, 1).value();
        double high = free - look(RECEIVER, shadow, drone, 1).value();

        assertThat(low).isCloseTo(6.03, within(0.05));
        assertThat(high).isGreaterThan(25.0);
        assertThat(look(added, grazed, drone, 1).value()).isCloseTo(free - low - 12.0, within(1e-9));
        assertThat(look(included, grazed, drone, 1).value()).isCloseTo(free - 12.0, within(1e-9));
        assertThat(look(included, shadow, drone, 1).value()).isCloseTo(free - high, within(1e-9));
        assertThat(look(included, open(), drone, 1).value()).isCloseTo(free - 12.0, within(1e-9));
    }

    /** As an edge rises into the line, the loss rises without a step where it passes the allowance. */
    @Test
    void anAllowanceThatIncludesEdgesHasNoStep() {
        RfSettings included = RECEIVER.withClutter(12.0).withClutterIncludingEdges(true);
        Drone drone = emitting(0.2 * reach());
        double before = Double.NaN;
        double least = Double.POSITIVE_INFINITY;
        for (double height = -10.0; height <= 10.0; height += 0.05) {
            double value = look(included, behind(block(300, height), ModelRole.BUILDING), drone, 1)
                    .value();
            if (!Double.isNaN(before)) {
                assertThat(Math.abs(value - before)).as("height %s", height).isLessThan(0.3);
            }
            least = Math.min(least, value);
            before = value;
        }
        assertThat(least).isLessThan(look(included, open(), drone, 1).value() - 5.0);
    }

    /** Without the edges it would be received: it is hidden, although the clutter alone would not have hidden it. */
    @Test
    void whatGoesBeyondAnAllowanceHides() {
        RfSettings included = RECEIVER.withClutter(12.0).withClutterIncludingEdges(true);
        Assessment hidden = assess(included, behind(block(300, 40.0), ModelRole.BUILDING), emitting(0.2 * reach()));

        assertThat(hidden.cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(assess(included, behind(wall(300, -999.0, 0.0), ModelRole.BUILDING), emitting(0.2 * reach()))
                        .cause())
                .isEqualTo(Cause.DETECTED);
    }

    /** Over flat ground the signal is that of the direct wave times the interference of both. */
    @Test
    void theGroundsReflectionInterferes() {
        World flat = World.of(TriangleMesh.of(
                new float[] {-9000, -9000, -10, 9000, -9000, -10, 9000, 9000, -10, -9000, 9000, -10},
                new int[] {0, 1, 2, 0, 2, 3}));
        ReflectingGround ground = new ReflectingGround(15, 0, 0);
        RfSettings receiver = RECEIVER.withGroundReflection(ground, LinearPolarisation.HORIZONTAL);
        TwoRays rays = new TwoRays(flat, ground);
        for (double north = 1000; north < 1100; north += 10) {
            Drone drone = emitting(new Position(0, north, 40));
            double more = look(receiver, flat, drone, 1).value()
                    - look(RECEIVER, flat, drone, 1).value();
            assertThat(more)
                    .isCloseTo(rays.factor(ANTENNA, drone.origin(), 2.4e9, false, way -> true), within(1e-9))
                    .isNotZero();
            assertThat(assess(receiver, flat, drone).quantity())
                    .isEqualTo(look(receiver, flat, drone, 1).value());
        }
    }
}
