package org.dronewatch.report.route;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.RouteCauses;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteProfile;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.WeakestRoute;
import org.junit.jupiter.api.Test;

class RouteDirectionsTest {
    private static final Position HERE = new Position(0, 0, 30);

    private static List<SectorRoute> from(int... sectors) {
        RouteProfile profile = new RouteProfile(List.of(new RoutePoint(0, 0, HERE, 30, 0, 0, true)));
        WeakestRoute route = new WeakestRoute(new RoutePath(List.of(HERE), List.of()), 0, 0, 0);
        return IntStream.of(sectors)
                .mapToObj(
                        sector -> new SectorRoute(sector, route, profile, Map.of(), RouteCauses.NONE, Optional.empty()))
                .toList();
    }

    @Test
    void severalDirectionsAreListed() {
        assertThat(RouteDirections.routes(from(0))).isEqualTo("the route from the north");
        assertThat(RouteDirections.routes(from(3, 5))).isEqualTo("the routes from the south-east and south-west");
        assertThat(RouteDirections.from(from(0, 1, 2, 3, 4, 5)))
                .isEqualTo("from the north, north-east, east, south-east, south and south-west");
    }

    @Test
    void nobodyNeedsToCountToEight() {
        assertThat(RouteDirections.routes(from(0, 1, 2, 3, 4, 5, 6, 7))).isEqualTo("the routes from all directions");
        assertThat(RouteDirections.from(from(0, 1, 2, 3, 4, 5, 7))).isEqualTo("from all directions but the west");
    }
}
