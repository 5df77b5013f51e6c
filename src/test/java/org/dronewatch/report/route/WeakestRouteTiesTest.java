package org.dronewatch.report.route;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.function.DoubleFunction;
import java.util.stream.DoubleStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.FlownExposure;
import org.dronewatch.route.RouteCauses;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteProfile;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.WeakestRoute;
import org.junit.jupiter.api.Test;

/**
 * Of routes whose figures the table prints alike, the first clockwise from north is the weakest; otherwise the one
 * whose figure is less.
 */
class WeakestRouteTiesTest {
    private static final int NORTH = 0;
    private static final int EAST = 2;
    private static final double RESPONSE = 5.0;

    /** A route of 43 s: the drone is detected in time and too late by one look each. */
    private static SectorRoute route(int sector, double exposure, double seconds, double inTime, double tooLate) {
        Position start = new Position(0, 430, 30);
        Position end = new Position(0, 0, 30);
        return new SectorRoute(
                sector,
                new WeakestRoute(new RoutePath(List.of(start, end), List.of(0)), exposure, 0.0, seconds),
                new RouteProfile(List.of(
                        new RoutePoint(0.0, 0.0, start, 30.0, 0, 0.0, true),
                        new RoutePoint(43.0, 430.0, end, 30.0, 0, exposure, true))),
                Map.of(),
                RouteCauses.NONE,
                Optional.of(new FlownExposure(
                        List.of(List.of(
                                new FlownExposure.Step(0.0, 10.0, -Math.log1p(-inTime)),
                                new FlownExposure.Step(40.0, 41.0, -Math.log1p(-tooLate)))),
                        Map.of())));
    }

    private static int weakest(SectorRoute north, SectorRoute east) {
        List<RouteMode> modes = List.of(RouteMode.free("flight", 10.0));
        RouteSurvey survey = new RouteSurvey(
                List.of(north, east), modes, north.searched().end().position(), RESPONSE, true);
        return survey.weakest().orElseThrow().sector();
    }

    /** Digits that are not printed differ by up to a hundredth of a per cent. */
    @Test
    void figuresThatArePrintedAlikeTie() {
        assertThat(weakest(route(NORTH, 167.1304, 43.02, 0.5, 0.9), route(EAST, 167.1297, 42.98, 0.5, 0.9)))
                .isEqualTo(NORTH);
        assertThat(weakest(route(NORTH, 167.1304, 43.02, 0.5, 0.9), route(EAST, 167.1297, 42.9, 0.5, 0.9)))
                .isEqualTo(EAST);
        assertThat(weakest(route(NORTH, 167.13, 42.0, 0.5, 0.9), route(EAST, 167.12, 43.0, 0.5, 0.9)))
                .isEqualTo(EAST);
        assertThat(weakest(route(NORTH, 5e-4, 43.0, 0.0, 0.0), route(EAST, 0.0, 43.0, 0.0, 0.0)))
                .isEqualTo(NORTH);
        assertThat(weakest(route(NORTH, 3.0, 43.0, 0.504, 0.9), route(EAST, 1.0, 43.0, 0.496, 0.904)))
                .isEqualTo(EAST);
    }

    @Test
    void soDoExposures() {
        assertTies(
                value -> RouteNumbers.exposure(value < 0.001 ? 0.0 : value),
                0.0005,
                DoubleStream.of(0.0, 1e-3, 0.01, 0.3, 0.998, 1.0, 1.5, 12.0, 167.13),
                (sector, value) -> route(sector, value, 43.0, 0.5, 0.9));
    }

    @Test
    void soDoTimes() {
        assertTies(
                value -> RouteNumbers.seconds(OptionalDouble.of(value)),
                0.1,
                DoubleStream.of(0.3, 9.9, 43.0, 99.8, 100.0, 317.5),
                (sector, value) -> route(sector, 2.0, value, 0.5, 0.9));
    }

    @Test
    void soDoProbabilities() {
        assertTies(
                value -> RouteNumbers.percent(value < 0.001 ? 0.0 : value),
                0.0005,
                DoubleStream.of(0.0005, 0.001, 0.02, 0.0985, 0.11, 0.5, 0.99),
                (sector, value) -> route(sector, 2.0, 43.0, value, 0.9));
    }

    private interface Routes {
        SectorRoute with(int sector, double value);
    }

    private static void assertTies(DoubleFunction<String> print, double step, DoubleStream values, Routes routes) {
        SplittableRandom random = new SplittableRandom(29);
        int[] ties = new int[2];
        values.forEach(value -> {
            for (int i = 0; i < 200; i++) {
                double least = value + step * random.nextDouble();
                double more = least + step * random.nextDouble();
                boolean isTie = print.apply(least).equals(print.apply(more));
                ties[isTie ? 1 : 0]++;
                assertThat(weakest(routes.with(NORTH, more), routes.with(EAST, least)))
                        .as("%s and %s", more, least)
                        .isEqualTo(isTie ? NORTH : EAST);
            }
        });
        assertThat(ties[0]).isGreaterThan(100);
        assertThat(ties[1]).isGreaterThan(100);
    }
}
