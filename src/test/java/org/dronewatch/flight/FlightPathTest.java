package org.dronewatch.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.assertj.core.data.Offset;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightPathSettings.Waypoints;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Ground;
import org.junit.jupiter.api.Test;

class FlightPathTest {
    private static final Offset<Double> EXACT = within(1e-9);
    private static final double SPEED = 5.0;
    private static final double ACCELERATION = 2.0;

    @Test
    void aHoveringDroneStaysWhereItIs() {
        Position place = new Position(1, 2, 3);
        FlightState state =
                new Hover(place, 0.7).create(SPEED, ACCELERATION, Ground.NONE).at(1234.5);

        assertThat(state).isEqualTo(new FlightState(place, new Position(0, 0, 0), 0.7));
    }

    @Test
    void anApproachFliesAtCruiseSpeedFromTheFirstMomentAndEndsAtItsEnd() {
        FlightPath path =
                new Approach(new Position(100, 0, 20), new Position(0, 0, 20)).create(SPEED, ACCELERATION, Ground.NONE);

        assertThat(path.at(4.0).position()).isEqualTo(new Position(80, 0, 20));
        assertThat(path.at(4.0).velocity()).isEqualTo(new Position(-5, 0, 0));
        assertThat(path.at(4.0).heading()).isCloseTo(-Math.PI / 2, EXACT);
        assertThat(path.at(20.0).position()).isEqualTo(new Position(0, 0, 20));
        assertThat(path.at(99.0).velocity().length()).isZero();
    }

    /** A straight of 100 m at 5 m/s and 2 m/s2: 2.5 s and 6.25 m to speed up, 17.5 s of cruise, 2.5 s to slow down. */
    @Test
    void aStraightIsFlownFromRestToRest() {
        FlightPath path = waypoints(new Position(0, 0, 0), new Position(0, 100, 0));

        assertThat(path.at(0.0).velocity().length()).isZero();
        assertThat(path.at(1.0).position().y()).isCloseTo(1.0, EXACT);
        assertThat(path.at(2.5).position().y()).isCloseTo(6.25, EXACT);
        assertThat(path.at(12.5).position().y()).isCloseTo(56.25, EXACT);
        assertThat(path.at(20.0).position().y()).isCloseTo(93.75, EXACT);
        assertThat(path.at(22.5).position().y()).isCloseTo(100.0, EXACT);
        assertThat(path.at(22.5).velocity().length()).isCloseTo(0.0, EXACT);
    }

    /** 4 m at 2 m/s2: the top speed is sqrt(2 * 4) m/s in the middle, after sqrt(2) s. */
    @Test
    void aShortStraightNeverReachesCruiseSpeed() {
        FlightPath path = waypoints(new Position(0, 0, 0), new Position(4, 0, 0));

        assertThat(path.at(Math.sqrt(2.0)).position().x()).isCloseTo(2.0, EXACT);
        assertThat(path.at(Math.sqrt(2.0)).velocity().x()).isCloseTo(Math.sqrt(8.0), EXACT);
        assertThat(path.at(2.0 * Math.sqrt(2.0)).position().x()).isCloseTo(4.0, EXACT);
    }

    @Test
    void aWaypointInTheMiddleOfAStraightIsFlownThrough() {
        FlightPath direct = waypoints(new Position(0, 0, 0), new Position(0, 0, 100));
        FlightPath through = waypoints(new Position(0, 0, 0), new Position(0, 0, 40), new Position(0, 0, 100));

        for (double time = 0.0; time < 30.0; time += 0.37) {
            assertThat(through.at(time).position().distance(direct.at(time).position()))
                    .isCloseTo(0.0, EXACT);
        }
    }

    /** Differences of what the path says, against the limits: no jump in place or speed, at corners least of all. */
    @Test
    void speedAndAccelerationStayWithinTheirLimits() {
        FlightPath path = waypoints(
                new Position(0, 0, 10),
                new Position(50, 0, 10),
                new Position(50, 1, 10),
                new Position(0, 30, 60),
                new Position(0, 30, 10));
        double dt = 1e-3;
        for (double time = 0.0; time < 60.0; time += dt) {
            FlightState now = path.at(time);
            FlightState next = path.at(time + dt);
            assertThat(now.velocity().length()).isLessThanOrEqualTo(SPEED + 1e-9);
            assertThat(next.velocity().distance(now.velocity())).isLessThanOrEqualTo(ACCELERATION * dt + 1e-9);
            assertThat(next.position().distance(now.position())).isLessThanOrEqualTo(SPEED * dt + 1e-9);
            Position mean = now.velocity().plus(next.velocity()).times(0.5 * dt);
            assertThat(next.position().minus(now.position()).distance(mean)).isLessThan(1e-5);
        }
        assertThat(path.at(60.0).position()).isEqualTo(new Position(0, 30, 10));
    }

    @Test
    void pathsThatLeadNowhereAreRefused() {
        Position here = new Position(1, 1, 1);
        assertThatIllegalArgumentException().isThrownBy(() -> new Approach(here, here));
        assertThatIllegalArgumentException().isThrownBy(() -> new Waypoints(List.of(here)));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Waypoints(List.of(new Position(0, 0, 0), here, here)))
                .withMessageContaining("waypoint 2");
        assertThatIllegalArgumentException().isThrownBy(() -> new Hover(here, Double.NaN));
    }

    private static FlightPath waypoints(Position... points) {
        return new Waypoints(List.of(points)).create(SPEED, ACCELERATION, Ground.NONE);
    }

    @Test
    void aGliderClimbsUnderPowerAndGlidesWithout() {
        Position from = new Position(0, 900, 10);
        Position release = new Position(0, 600, 410);
        Position to = new Position(0, -400, 310);
        FlightPath path = new FlightPathSettings.Glide(from, release, to).create(20.0, 3.0, Ground.NONE);

        assertThat(path.at(0).position()).isEqualTo(from);
        assertThat(path.at(24.9).isPowered()).isTrue();
        assertThat(path.at(25.1).isPowered()).isFalse();
        assertThat(path.at(25.0).position().distance(release)).isLessThan(1e-9);
        // 10 to 1: 5.71 degrees down.
        Position velocity = path.at(40.0).velocity();
        assertThat(velocity.length()).isCloseTo(20.0, within(1e-12));
        assertThat(Math.toDegrees(Math.atan2(-velocity.z(), -velocity.y()))).isCloseTo(5.71, within(0.005));
        assertThat(path.at(1000).position()).isEqualTo(to);
        assertThat(path.at(1000).isPowered()).isFalse();

        assertThatIllegalArgumentException()
                .isThrownBy(() -> new FlightPathSettings.Glide(from, release, new Position(0, -400, 500)))
                .withMessageContaining("height of 'release' above 'to'");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new FlightPathSettings.Glide(from, release, new Position(0, -4000, 400)))
                .withMessageContaining("glide ratio 460.0");
    }

    @Test
    void anOrbitIsAClockwiseCircleAtCruiseSpeed() {
        Position centre = new Position(10, 20, 50);
        FlightPath path = FlightPathSettings.Orbit.about(centre, 40.0).create(8.0, 3.0, Ground.NONE);
        double round = 2 * Math.PI * 40 / 8;

        assertThat(path.at(0).position().distance(new Position(10, 60, 50))).isLessThan(1e-9);
        assertThat(path.at(round / 4).position().distance(new Position(50, 20, 50)))
                .isLessThan(1e-9);
        assertThat(path.at(round).position().distance(path.at(0).position())).isLessThan(1e-9);
        for (double time = 0.0; time < round; time += 1.7) {
            FlightState now = path.at(time);
            Position step =
                    path.at(time + 1e-4).position().minus(path.at(time - 1e-4).position());
            assertThat(now.position().distance(centre)).isCloseTo(40.0, within(1e-9));
            assertThat(step.times(1 / 2e-4).distance(now.velocity())).isLessThan(1e-3);
            assertThat(Math.sin(now.heading())).isCloseTo(now.velocity().x() / 8, within(1e-9));
            assertThat(Math.cos(now.heading())).isCloseTo(now.velocity().y() / 8, within(1e-9));
        }
    }
}
