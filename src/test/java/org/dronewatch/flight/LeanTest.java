package org.dronewatch.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.flight.FlightPathSettings.Orbit;
import org.dronewatch.flight.FlightPathSettings.Waypoints;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.world.Ground;
import org.junit.jupiter.api.Test;

/** How drones lean, against the closed forms of steady acceleration and of the coordinated turn. */
class LeanTest {
    private static final double G = 9.80665;
    private static final Position RIGHT = new Position(1, 0, 0);
    private static final Position NOSE = new Position(0, 1, 0);
    private static final Position UP = new Position(0, 0, 1);

    private static DroneSettings leaning(FlightPathSettings flight, Airframe airframe) {
        return DroneSettings.of(ModelSettings.of("none.obj"), flight)
                .withAirframe(airframe)
                .withLean(true);
    }

    /** Constant acceleration from a velocity, with the nose to a heading. */
    private static FlightPath steady(Position velocity, Position acceleration, double heading) {
        return time -> new FlightState(
                velocity.times(time).plus(acceleration.times(0.5 * time * time)),
                velocity.plus(acceleration.times(time)),
                heading);
    }

    private static Position random(Random random, double scale) {
        return new Position(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).times(scale);
    }

    @Test
    void aMultirotorTiltsByTheAngleWhoseTangentIsAccelerationOverGravity() {
        FlightPath forward = Airframe.MULTIROTOR.leaning(steady(new Position(0, 0, 0), new Position(0, 3, 0), 0.0));
        Attitude tilted = forward.at(2.0).attitude();
        assertThat(Math.tan(-tilted.pitch())).as("nose down").isCloseTo(3 / G, within(1e-12));
        assertThat(tilted.roll()).isCloseTo(0.0, within(1e-12));

        FlightPath aside = Airframe.MULTIROTOR.leaning(steady(new Position(0, 0, 0), new Position(3, 0, 0), 0.0));
        assertThat(Math.tan(aside.at(2.0).attitude().roll()))
                .as("right side down")
                .isCloseTo(3 / G, within(1e-12));
    }

    @Test
    void theThrustOfAMultirotorIsItsAccelerationMinusGravity() {
        long seed = 4711;
        System.out.println("seed of the accelerations: " + seed);
        Random random = new Random(seed);
        for (int i = 0; i < 1000; i++) {
            Position acceleration = random(random, 8);
            double heading = random.nextDouble(-Math.PI, Math.PI);
            FlightState state = Airframe.MULTIROTOR
                    .leaning(steady(random(random, 20), acceleration, heading))
                    .at(random.nextDouble(100));
            Position thrust = acceleration.plus(new Position(0, 0, G)).unit();
            assertThat(state.attitude().toWorld(UP).distance(thrust)).isLessThan(1e-9);
            assertThat(state.heading()).isEqualTo(heading);
        }
    }

    @Test
    void aWingFeelsNoForceToTheSideAndItsNoseFollowsThePath() {
        long seed = 4712;
        System.out.println("seed of the turns: " + seed);
        Random random = new Random(seed);
        for (int i = 0; i < 1000; i++) {
            Position velocity = random(random, 20);
            Position acceleration = random(random, 4);
            double time = random.nextDouble(5);
            Position now = velocity.plus(acceleration.times(time));
            double heading = Math.atan2(now.x(), now.y());
            Attitude attitude = Airframe.FIXED_WING
                    .leaning(steady(velocity, acceleration, heading))
                    .at(time)
                    .attitude();
            Position force = acceleration.plus(new Position(0, 0, G));
            assertThat(force.dot(attitude.toWorld(RIGHT))).isCloseTo(0.0, within(1e-8));
            assertThat(force.dot(attitude.toWorld(UP))).isPositive();
            assertThat(attitude.toWorld(NOSE).distance(now.unit())).isLessThan(1e-9);
        }
    }

    /**
     * An orbit is clockwise, so the right wing is the lower one; the mean over half a second shortens the acceleration.
     */
    @Test
    void aWingBanksIntoACircleAsInACoordinatedTurn() {
        double speed = 15;
        double radius = 40;
        double omega = speed / radius;
        FlightPath path = leaning(Orbit.about(new Position(0, 0, 50), radius), Airframe.FIXED_WING)
                .withSpeed(speed)
                .createFlight(Ground.NONE);
        double mean = Math.sin(0.25 * omega) / (0.25 * omega);
        for (double time = 0.25; time < 20; time += 0.37) {
            Attitude attitude = path.at(time).attitude();
            assertThat(Math.tan(attitude.roll())).isCloseTo(mean * speed * omega / G, within(1e-9));
            assertThat(Math.tan(attitude.roll())).isCloseTo(speed * omega / G, within(0.002 * speed * omega / G));
            assertThat(attitude.pitch()).isCloseTo(0.0, within(1e-9));
        }
        Attitude rotors = Airframe.MULTIROTOR.leaning(path).at(3.0).attitude();
        assertThat(rotors)
                .as("a flight that is not level keeps its attitude")
                .isEqualTo(path.at(3.0).attitude());
    }

    @Test
    void aMultirotorNosesDownToStartAndUpToStopAndIsLevelBetween() {
        Waypoints legs = new Waypoints(List.of(new Position(0, 0, 10), new Position(0, 100, 10)));
        FlightPath path = leaning(legs, Airframe.MULTIROTOR).createFlight(Ground.NONE);
        // 5 m/s at 2.5 m/s2: two seconds of ramp, 18 s of cruise, two seconds of ramp.
        assertThat(path.at(1.0).attitude().pitch()).isCloseTo(-Math.atan(2.5 / G), within(1e-12));
        assertThat(path.at(0.0).attitude().pitch()).isCloseTo(-Math.atan(2.5 / G), within(1e-12));
        assertThat(path.at(10.0).attitude().isLevel()).isTrue();
        assertThat(path.at(21.0).attitude().pitch()).isCloseTo(Math.atan(2.5 / G), within(1e-12));
        assertThat(path.at(30.0).attitude().isLevel()).isTrue();
    }

    /** A path that stops dead: the mean over half a second is finite, and gone a quarter of a second later. */
    @Test
    void aJumpOfVelocityIsABriefFiniteLean() {
        FlightPath path = leaning(new Approach(new Position(0, 0, 10), new Position(0, 10, 10)), Airframe.MULTIROTOR)
                .createFlight(Ground.NONE);
        assertThat(path.at(1.74).attitude().isLevel()).isTrue();
        assertThat(Math.tan(path.at(2.0).attitude().pitch())).isCloseTo(5 / 0.5 / G, within(1e-12));
        assertThat(path.at(2.26).attitude().isLevel()).isTrue();
    }

    @Test
    void aHybridFliesAsAWingAndHoversAsAMultirotor() {
        Position aside = new Position(2, 0, 0);
        FlightPath fast = steady(new Position(0, 20, 0), aside, 0.0);
        FlightPath rising = steady(new Position(0, 0, 20), aside, 0.0);
        Position ahead = new Position(0, 2, 0);
        FlightPath speedingUp = steady(new Position(0, 20, 0), ahead, 0.0);
        assertThat(at(Airframe.HYBRID, fast)).isEqualTo(at(Airframe.FIXED_WING, fast));
        assertThat(at(Airframe.HYBRID, rising)).isEqualTo(at(Airframe.MULTIROTOR, rising));
        assertThat(at(Airframe.HYBRID, speedingUp).isLevel()).isTrue();
        assertThat(at(Airframe.MULTIROTOR, speedingUp).pitch()).isCloseTo(-Math.atan(2 / G), within(1e-12));
    }

    private static Attitude at(Airframe airframe, FlightPath path) {
        return airframe.leaning(path).at(0.5).attitude();
    }

    @Test
    void aWingThatDivesStraightDownDoesNotRollAndNothingFallsOver() {
        FlightPath down = steady(new Position(0, 0, -20), new Position(0, 0, 0), 1.0);
        Attitude attitude = at(Airframe.FIXED_WING, down);
        assertThat(attitude.pitch()).isCloseTo(-Math.PI / 2, within(1e-12));
        assertThat(attitude.roll()).isEqualTo(0.0);
        FlightPath falling = steady(new Position(0, 0, 0), new Position(0, 0, -G), 1.0);
        assertThat(at(Airframe.MULTIROTOR, falling)).isEqualTo(Attitude.level(1.0));
    }

    @Test
    void withoutLeanADroneIsLevelAndASwarmLeansAsItsLeaderDoes() {
        Orbit orbit = Orbit.about(new Position(0, 0, 50), 40);
        DroneSettings drone = leaning(orbit, Airframe.FIXED_WING).withSpeed(15);
        assertThat(drone.withLean(false)
                        .createFlight(Ground.NONE)
                        .at(3)
                        .attitude()
                        .isLevel())
                .isTrue();
        Attitude leader = drone.createFlight(Ground.NONE).at(3).attitude();
        assertThat(leader.isLevel()).isFalse();
        for (DroneSettings follower : drone.withSwarm(Swarm.of(3)).members()) {
            assertThat(follower.createFlight(Ground.NONE).at(3).attitude()).isEqualTo(leader);
        }
    }
}
