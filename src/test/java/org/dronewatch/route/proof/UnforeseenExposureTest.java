package org.dronewatch.route.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.FlownExposure;
import org.dronewatch.route.FlownExposure.Step;
import org.dronewatch.route.RouteCauses;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteProfile;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.route.search.RouteGrid;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.WeakestRoute;
import org.junit.jupiter.api.Test;

/**
 * A straight route from west to east, at 5 m/s, 15 m above level ground, of which the search expects an exposure of
 * 0.01 a second.
 */
class UnforeseenExposureTest {
    private static final double SPEED = 5.0;
    private static final double CELL = 20.0;
    private static final double HEIGHT = 15.0;
    private static final double EXPECTED = 0.01;
    private static final double SECONDS = 40.0;
    private static final List<RouteMode> MODES = List.of(RouteMode.free("flight", SPEED));
    private static final RouteGrid GRID = RouteGrid.level(0.0, 0.0, CELL, 11, 11, 10.0, 20.0, 40.0);

    /** At the middle of the row of cubes between the sixth and the seventh row of nodes. */
    private static final double NORTH = 110.0;

    private static RoutePoint point(double time) {
        return new RoutePoint(
                time,
                SPEED * time,
                new Position(SPEED * time, NORTH, HEIGHT),
                HEIGHT,
                0,
                EXPECTED * time,
                time == 0.0 || time == SECONDS);
    }

    private static SectorRoute flown(Step... looks) {
        return ofFlights(List.of(List.of(looks)));
    }

    private static SectorRoute ofFlights(List<List<Step>> flights) {
        RouteProfile profile = new RouteProfile(List.of(point(0.0), point(10.0), point(SECONDS)));
        RoutePath path =
                new RoutePath(List.of(point(0.0).position(), point(SECONDS).position()), List.of(0));
        return new SectorRoute(
                6,
                new WeakestRoute(path, EXPECTED * SECONDS, 0.0, SECONDS),
                profile,
                Map.of("radar", EXPECTED * SECONDS),
                RouteCauses.NONE,
                Optional.of(new FlownExposure(flights, Map.of("radar", 1.0))));
    }

    private static double rate(UnforeseenExposure field, double x, double y, double z) {
        return field.rate(x, y, z, new LegMotion(0.0, 0.0, SPEED, 0.0), 0);
    }

    /** The drone is at 70 m, in the middle of a cube, at 14 s: it needs 4 s for 20 m. */
    @Test
    void whatALookAddsIsSpreadOverTheTimeFromNodeToNode() {
        UnforeseenExposure field = UnforeseenExposure.none(GRID).with(flown(new Step(12.0, 14.0, 0.42)), MODES);
        double rate = (0.42 - 2.0 * EXPECTED) * SPEED / CELL;

        for (double z : new double[] {10.0, 15.0, 20.0}) {
            assertThat(rate(field, 70.0, NORTH, z)).isCloseTo(rate, within(1e-12));
            assertThat(rate(field, 60.0, 100.0, z)).isCloseTo(rate, within(1e-12));
        }
        assertThat(rate(field, 50.0, NORTH, HEIGHT)).isCloseTo(0.5 * rate, within(1e-12));
        assertThat(rate(field, 50.0, 90.0, 30.0)).isCloseTo(0.125 * rate, within(1e-12));
        assertThat(rate(field, 40.0, NORTH, HEIGHT)).isZero();
        assertThat(rate(field, 70.0, 140.0, HEIGHT)).isZero();
        assertThat(rate(field, 70.0, NORTH, 40.0)).isZero();
        assertThat(field.least(new Position(60, 100, 10), new Position(80, 120, 20), 0))
                .isZero();
    }

    /** Outside the grid, its edge counts. */
    @Test
    void theFieldEndsAtTheEdgeLikeThatOfTheSensors() {
        UnforeseenExposure field = UnforeseenExposure.none(GRID).with(flown(new Step(39.0, 39.5, 1.0)), MODES);

        assertThat(rate(field, 197.5, NORTH, HEIGHT))
                .isPositive()
                .isCloseTo(rate(field, 230.0, NORTH, 5.0), within(1e-12));
    }

    @Test
    void looksInOneCubeAddUpAndFlightsAreAveraged() {
        Step first = new Step(12.0, 13.0, 0.51);
        Step second = new Step(13.0, 14.0, 0.31);
        UnforeseenExposure field =
                UnforeseenExposure.none(GRID).with(ofFlights(List.of(List.of(first, second), List.of())), MODES);

        assertThat(rate(field, 70.0, NORTH, HEIGHT)).isCloseTo(0.5 * 0.8 * SPEED / CELL, within(1e-12));
    }

    @Test
    void whatTheSearchExpectedAddsNothing() {
        UnforeseenExposure field = UnforeseenExposure.none(GRID)
                .with(flown(new Step(12.0, 14.0, 2.0 * EXPECTED), new Step(20.0, 24.0, 0.01)), MODES);

        for (double x = 0.0; x <= 200.0; x += 10.0) {
            assertThat(rate(field, x, NORTH, HEIGHT)).isCloseTo(0.0, within(1e-15));
        }
    }

    @Test
    void ofSeveralRoutesTheHighestRateCounts() {
        SectorRoute weak = flown(new Step(13.0, 14.0, 0.21));
        SectorRoute strong = flown(new Step(13.0, 14.0, 0.41));
        UnforeseenExposure none = UnforeseenExposure.none(GRID);

        for (UnforeseenExposure field : List.of(
                none.with(weak, MODES).with(strong, MODES),
                none.with(strong, MODES).with(weak, MODES))) {
            assertThat(rate(field, 70.0, NORTH, HEIGHT)).isCloseTo(0.4 * SPEED / CELL, within(1e-12));
        }
        assertThat(rate(none, 70.0, NORTH, HEIGHT)).isZero();
    }

    @Test
    void aGridWithOneLevelHasOneRateAtAllHeights() {
        RouteGrid flat = RouteGrid.level(0.0, 0.0, CELL, 11, 11, HEIGHT);
        UnforeseenExposure field = UnforeseenExposure.none(flat).with(flown(new Step(13.0, 14.0, 0.41)), MODES);

        for (double z : new double[] {0.0, HEIGHT, 40.0}) {
            assertThat(rate(field, 70.0, NORTH, z)).isCloseTo(0.4 * SPEED / CELL, within(1e-12));
        }
    }
}
