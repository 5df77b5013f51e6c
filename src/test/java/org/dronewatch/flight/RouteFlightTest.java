package org.dronewatch.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Ground;
import org.junit.jupiter.api.Test;

class RouteFlightTest {
    private static final Position START = new Position(0, 0, 100);

    private static RouteLeg leg(double x, double y, double z, double speed) {
        return new RouteLeg(new Position(x, y, z), Optional.of(speed), true);
    }

    private static RouteLeg glide(double x, double y, double z) {
        return new RouteLeg(new Position(x, y, z), Optional.empty(), false);
    }

    /** 30 m north at 5 m/s, 40 m east at 20 m/s, then a glide of 50 m at cruise speed, 10 m/s. */
    private static final RouteFlight ROUTE =
            RouteFlight.of(START, List.of(leg(0, 30, 100, 5), leg(40, 30, 100, 20), glide(40, 0, 60)));

    @Test
    void fliesEachLegAtItsOwnSpeedWithoutStopping() {
        FlightPath path = ROUTE.create(10, 2, Ground.NONE);

        FlightState first = path.at(3);
        assertThat(first.position().distance(new Position(0, 15, 100))).isLessThan(1e-12);
        assertThat(first.velocity()).isEqualTo(new Position(0, 5, 0));
        assertThat(first.heading()).isZero();
        FlightState second = path.at(7);
        assertThat(second.position().distance(new Position(20, 30, 100))).isLessThan(1e-12);
        assertThat(second.heading()).isEqualTo(Math.PI / 2);
        assertThat(second.isPowered()).isTrue();
        assertThat(ROUTE.duration(10)).isCloseTo(6 + 2 + 5, within(1e-12));
    }

    @Test
    void waitsWhereItBegins() {
        RouteFlight later = RouteFlight.of(START, List.of(leg(40, 0, 100, 20))).withDelay(3.0);
        FlightPath path = later.create(10, 2, Ground.NONE);

        assertThat(path.at(2.9).position()).isEqualTo(START);
        assertThat(path.at(2.9).velocity()).isEqualTo(new Position(0, 0, 0));
        assertThat(path.at(2.9).heading()).isEqualTo(Math.PI / 2);
        assertThat(path.at(4.0).position().distance(new Position(20, 0, 100))).isLessThan(1e-12);
        assertThat(later.duration(10)).isCloseTo(5, within(1e-12));
    }

    @Test
    void countsTheTimeSinceItsMotorsStopped() {
        RouteFlight further = RouteFlight.of(START, List.of(leg(0, 30, 100, 5), glide(0, 60, 90), glide(0, 90, 80)));
        FlightPath path = further.create(10, 2, Ground.NONE);
        double gliding = 2 * Math.hypot(30, 10) / 10;

        assertThat(path.at(5.9).gliding()).isEmpty();
        assertThat(path.at(8).gliding().orElseThrow()).isCloseTo(2.0, within(1e-9));
        assertThat(path.at(6 + gliding - 1e-6).gliding().orElseThrow()).isCloseTo(gliding, within(2e-6));
    }

    @Test
    void staysAtItsEnd() {
        FlightState end = ROUTE.create(10, 2, Ground.NONE).at(1000);

        assertThat(end.position()).isEqualTo(new Position(40, 0, 60));
        assertThat(end.velocity()).isEqualTo(new Position(0, 0, 0));
        assertThat(Math.abs(end.heading())).isEqualTo(Math.PI);
    }

    @Test
    void rejectsWhatCannotBeFlown() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> RouteFlight.of(START, List.of()))
                .withMessage("legs has 0 legs but needs 1 to 10000");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> RouteFlight.of(START, List.of(glide(0, 30, 100))))
                .withMessage("leg 1 without power ends at 100.0 m: it must end below its beginning at 100.0 m");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> RouteFlight.of(START, List.of(leg(0, 0, 100, 5))))
                .withMessageContaining("length of leg 1");
    }
}
