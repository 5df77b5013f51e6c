package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.route.search.PlanDirections;
import org.dronewatch.route.search.RouteGrid;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.RouteProblem;
import org.junit.jupiter.api.Test;

/** A flight of 100 m east at 10 m/s, then 300 m north at 2 m/s up, past a sensor that only watches the second leg. */
class RouteProfileTest {
    private static final double RATE = 0.05;
    private static final double SPEED = 10.0;
    private static final RoutePath PATH = new RoutePath(
            List.of(new Position(0, 0, 20), new Position(100, 0, 20), new Position(100, 300, 80)), List.of(0, 0));

    /** Watches whatever is north of y = 0. */
    private record North(double watched) implements ExposureField {
        @Override
        public double rate(double x, double y, double z, LegMotion motion, int mode) {
            return y > 0.0 ? watched : 0.0;
        }

        @Override
        public double least(Position low, Position high, int mode) {
            return 0.0;
        }
    }

    private static RouteProfile profile(double rate) {
        BitSet any = new BitSet();
        any.set(0);
        RouteGrid grid = RouteGrid.level(0.0, 0.0, 20.0, 20, 20, 20.0, 80.0);
        RouteMode mode = new RouteMode("powered", SPEED, 1.0, 1.0, Double.POSITIVE_INFINITY);
        return RouteProfile.of(
                PATH,
                new RouteProblem(grid, new North(rate), List.of(mode), 0.0, PlanDirections.of(16), any, any),
                grid::above);
    }

    /** 15.3 of the 60 s of the second leg have passed; the route is over after 70 s. */
    @Test
    void theDroneIsBetweenThePointsOfTheProfile() {
        RouteProfile profile = profile(RATE);
        RoutePoint there = profile.at(25.3);
        assertThat(there.position().distance(new Position(100, 76.5, 35.3))).isLessThan(1e-9);
        assertThat(there.above()).isCloseTo(35.3, within(1e-9));
        assertThat(there.distance()).isCloseTo(100.0 + 0.255 * Math.hypot(300.0, 60.0), within(1e-9));
        assertThat(there.time()).isCloseTo(25.3, within(1e-9));
        assertThat(there.exposure()).isCloseTo(15.3 * RATE, within(1e-9));
        assertThat(there.isCorner()).isFalse();
        assertThat(profile.at(0.0)).isEqualTo(profile.points().get(0));
        assertThat(profile.at(-1.0)).isEqualTo(profile.points().get(0));
        assertThat(profile.at(70.5)).isEqualTo(profile.end());
    }

    /** The second leg climbs 60 m at 1 m/s: it takes 60 s, longer than its length at cruise speed. */
    @Test
    void timesDistancesAndExposuresAddUp() {
        RouteProfile profile = profile(RATE);
        assertThat(profile.end().time()).isCloseTo(70.0, within(1e-9));
        assertThat(profile.end().distance()).isCloseTo(100.0 + Math.hypot(300.0, 60.0), within(1e-9));
        assertThat(profile.exposure()).isCloseTo(60.0 * RATE, within(1e-9));
        assertThat(profile.detection()).isCloseTo(1.0 - Math.exp(-60.0 * RATE), within(1e-9));
        assertThat(profile.exposureUntil(10.0)).isZero();
        assertThat(profile.exposureUntil(25.3)).isCloseTo(15.3 * RATE, within(1e-9));
        assertThat(profile.exposureUntil(1e6)).isEqualTo(profile.exposure());
        for (int i = 1; i < profile.points().size(); i++) {
            RoutePoint before = profile.points().get(i - 1);
            RoutePoint after = profile.points().get(i);
            assertThat(after.distance() - before.distance()).isBetween(1.0, 10.0);
            assertThat(after.time()).isGreaterThan(before.time());
            assertThat(after.exposure()).isGreaterThanOrEqualTo(before.exposure());
        }
    }

    /** A radar that is certain to detect the drone from 30 s on, every 5 s: no look before, then one in 5 s. */
    @Test
    void looksOfSlowSensorsAreShownWhereTheyAre() {
        List<List<FlownExposure.Step>> flights = IntStream.range(0, 8)
                .mapToObj(flight -> IntStream.range(6, 14)
                        .mapToDouble(look -> 5.0 * look + 0.625 * flight)
                        .mapToObj(time -> new FlownExposure.Step(time - 5.0, time, 13.8))
                        .toList())
                .toList();
        RouteProfile flown = profile(RATE).with(new FlownExposure(flights, Map.of()));
        for (RoutePoint point : flown.points()) {
            double expected = 0.2 * Math.max(0.0, point.time() - 30.0);
            assertThat(point.exposure()).isCloseTo(expected, within(0.2 * 0.625 + 1e-5));
            assertThat(point.time() < 29.3 && point.exposure() > 0.0).isFalse();
        }
    }

    /** Of a constant rate r over T, with P = 1 - exp(-r T): half of all detections come before -ln(1 - P/2) / r. */
    @Test
    void theMedianIsThatOfAConstantRate() {
        double all = 1.0 - Math.exp(-60.0 * RATE);
        assertThat(profile(RATE).medianDetection().orElseThrow())
                .isCloseTo(10.0 - Math.log(1.0 - 0.5 * all) / RATE, within(1e-9));
        assertThat(profile(1e-9).medianDetection().orElseThrow()).isCloseTo(40.0, within(1e-5));
        assertThat(profile(0.0).medianDetection()).isEmpty();
        assertThat(profile(1e3).medianDetection().orElseThrow()).isBetween(10.0, 10.01);
    }

    /** 10 s of 70 s are level at 20 m, the others climb from there to 80 m: the median is that 35 s after the start. */
    @Test
    void theMedianHeightIsThatOverTheTime() {
        assertThat(profile(RATE).medianHeight()).isCloseTo(45.0, within(2.0));
        assertThat(profile(RATE).points().get(0).above()).isEqualTo(20.0);
    }
}
