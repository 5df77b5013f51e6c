package org.dronewatch.report.route;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.map.RouteMap.Piece;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;

/** Routes in pieces on each of which the exposure is of one class. */
final class RoutePieces {
    private RoutePieces() {}

    /** The pieces of all routes, in the order in which they are flown. */
    static List<Piece> of(RouteSurvey survey) {
        List<Piece> pieces = new ArrayList<>();
        survey.routes().forEach(route -> add(route, pieces));
        return pieces;
    }

    private static void add(SectorRoute route, List<Piece> pieces) {
        List<RoutePoint> points = route.profile().points();
        int first = 0;
        for (int i = 1; i < points.size(); i++) {
            RouteColours style = RouteColours.of(points.get(i - 1), points.get(i));
            boolean isLast = i + 1 == points.size() || RouteColours.of(points.get(i), points.get(i + 1)) != style;
            if (isLast) {
                pieces.add(piece(route, points.subList(first, i + 1), style));
                first = i;
            }
        }
    }

    private static Piece piece(SectorRoute route, List<RoutePoint> points, RouteColours style) {
        RoutePoint end = points.get(points.size() - 1);
        List<Position> corners = points.stream()
                .filter(point -> point.isCorner() || point == end || point == points.get(0))
                .map(RoutePoint::position)
                .toList();
        return new Piece(
                "from the " + RouteWords.sector(route),
                style.words(),
                corners,
                style.colour(),
                points.get(0).time(),
                end.time(),
                -Math.expm1(-end.exposure()));
    }
}
