package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.FlightPerformance;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.radar.DopplerFilter;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SlowFlightTest {
    private static final double CRUISE = 15.0;
    private static final double FASTEST = 100.0;

    /** A hundredth of the signal passes, and the drone keeps a hundredth of the speed in reserve. */
    private static final double BELOW = 0.99;

    private static final DroneSettings DRONE = DroneSettings.of(
                    ModelSettings.packaged("quadrotor.obj"), Hover.at(new Position(0, 0, 10)))
            .withSpeed(CRUISE);
    private static final RadarSettings RADAR =
            RadarSettings.at(new Position(0, 0, 0), LinkBudget.DataSheet.of(1000, 0.01));

    private static List<Double> speeds(RadarSettings... radars) {
        return SlowFlight.speeds(DRONE, List.of(radars));
    }

    @Test
    void aDroneStaysBelowTheLeastSpeedOfARadar() {
        assertThat(speeds(RADAR.withSpeeds(3.0, FASTEST))).singleElement().satisfies(speed -> assertThat(speed)
                .isCloseTo(BELOW * 3.0, within(1e-6)));
    }

    /** 1 / (1 + (w / v)^4) = 0.01 at v = w / 99^(1/4). */
    @Test
    void twentyDecibelsOfAHighPassFilterAreEnough() {
        assertThat(speeds(RADAR.withNotch(new DopplerFilter.HighPass(6.0, 2))))
                .singleElement()
                .satisfies(speed -> assertThat(speed).isCloseTo(BELOW * 6.0 / Math.pow(99.0, 0.25), within(1e-6)));
    }

    /** sin^2(pi v / b) = 0.01 below its first lobe, and its fastest blind speed below the cruise speed. */
    @ParameterizedTest
    @CsvSource({"12, 12", "7, 14", "5, 10", "3.7, 14.8"})
    void aCancellerIsPassedBelowItsFirstLobeOrAtABlindSpeed(double first, double fastest) {
        List<Double> speeds = speeds(RADAR.withNotch(new DopplerFilter.Canceller(2, first)));

        assertThat(speeds).hasSize(2);
        assertThat(speeds.get(0)).isCloseTo(fastest, within(1e-6));
        assertThat(speeds.get(1)).isCloseTo(BELOW * first * Math.asin(0.1) / Math.PI, within(1e-6));
    }

    /** At cruise speed, the drone has a blind speed already. */
    @Test
    void aBandAroundTheCruiseSpeedIsLeftOut() {
        assertThat(speeds(RADAR.withNotch(new DopplerFilter.Canceller(2, CRUISE))))
                .hasSize(1);
        assertThat(speeds(RADAR.withSpeeds(3.0, CRUISE - 1.0))).hasSize(1);
    }

    @Test
    void radarsOfDifferentSpeedsGiveOneEachTheFastestFirst() {
        RadarSettings one = RADAR.withSpeeds(1.0, FASTEST);
        RadarSettings two = RADAR.withSpeeds(2.0, FASTEST);

        assertThat(speeds(one, two, one.withRate(2.0)))
                .hasSize(2)
                .isEqualTo(Stream.of(speeds(two), speeds(one))
                        .flatMap(List::stream)
                        .toList());
    }

    @Test
    void nothingIsSlowerForARadarThatSeesAllOrNothing() {
        assertThat(speeds()).isEmpty();
        assertThat(speeds(RADAR.withSpeeds(0.0, FASTEST))).isEmpty();
        assertThat(speeds(RADAR.withSpeeds(0.05, FASTEST))).isEmpty();
        assertThat(speeds(RADAR.withSpeeds(CRUISE + 1.0, FASTEST))).isEmpty();
    }

    @Test
    void aDroneThatCannotHoverHasNoSuchSpeed() {
        DroneSettings wings = DRONE.withPerformance(FlightPerformance.TYPICAL.withHover(false));

        assertThat(SlowFlight.speeds(wings, List.of(RADAR.withSpeeds(3.0, FASTEST))))
                .isEmpty();
    }
}
