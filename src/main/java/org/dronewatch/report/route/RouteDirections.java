package org.dronewatch.report.route;

import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.setting.PlainText;

/** The directions of several routes in words. */
final class RouteDirections {
    private static final String ALL = "from all directions";

    private RouteDirections() {}

    /**
     * {@code from the north, east and south}; or {@code from all directions}, or {@code from all directions but the
     * west}.
     *
     * @param routes one or more, in the order of their sectors
     */
    static String from(List<SectorRoute> routes) {
        List<Integer> others = IntStream.range(0, SiteRoutes.SECTORS)
                .filter(sector -> routes.stream().noneMatch(route -> route.sector() == sector))
                .boxed()
                .toList();
        return switch (others.size()) {
            case 0 -> ALL;
            case 1 -> ALL + " but the " + RouteWords.sector(others.get(0));
            default ->
                "from the "
                        + PlainText.list(routes.stream().map(RouteWords::sector).toList());
        };
    }

    /** The routes in words: {@code the route from the north}, {@code the routes from the north and east}. */
    static String routes(List<SectorRoute> routes) {
        return (routes.size() == 1 ? "the route " : "the routes ") + from(routes);
    }
}
