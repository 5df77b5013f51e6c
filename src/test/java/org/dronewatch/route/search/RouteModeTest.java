package org.dronewatch.route.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.drone.FlightLimits;
import org.dronewatch.flight.Airframe;
import org.junit.jupiter.api.Test;

class RouteModeTest {
    private static final double SPEED = 15.0;

    private static RouteMode powered(Airframe airframe) {
        return RouteMode.powered(FlightLimits.typical(airframe, SPEED), SPEED);
    }

    /** At 10 m/s along the path, of which 5 m/s are up: asin(1/2) is 30 degrees. */
    @Test
    void aDroneThatCannotHoverClimbsNoMoreSteeplyThanAtItsLeastSpeed() {
        RouteMode wing = powered(Airframe.FIXED_WING);
        double steepest = 20.0 / Math.tan(Math.toRadians(30.0));

        assertThat(wing.slowest()).isCloseTo(10.0, within(1e-12));
        assertThat(wing.leastLength(20.0)).isCloseTo(steepest, within(1e-9));
        assertThat(wing.leastLength(-20.0)).isCloseTo(steepest, within(1e-9));
        assertThat(wing.time(steepest * 1.001, 20.0)).isCloseTo(4.0, within(1e-9));
        assertThat(wing.time(steepest * 0.999, 20.0)).isInfinite();
        assertThat(wing.time(steepest * 0.999, -20.0)).isInfinite();
        assertThat(wing.time(0.0, 20.0)).isInfinite();
        assertThat(wing.time(300.0, 0.0)).isEqualTo(20.0);
        assertThat(wing.time(0.0, 0.0)).isZero();
    }

    @Test
    void oneThatCanHoverClimbsVertically() {
        RouteMode rotor = powered(Airframe.MULTIROTOR);

        assertThat(rotor.slowest()).isZero();
        assertThat(rotor.leastLength(20.0)).isZero();
        assertThat(rotor.time(0.0, 30.0)).isEqualTo(10.0);
    }

    @Test
    void theLeastSpeedIsAtMostTheSpeed() {
        assertThatThrownBy(() -> new RouteMode("powered", 10.0, 1.0, 1.0, Double.POSITIVE_INFINITY, 11.0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("mode powered with a minimum speed of 11.0 m/s: it must be 0 to 10.0 m/s");
    }
}
