package org.dronewatch.report.route;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.map.RouteMap.Piece;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.search.RouteMode;

/** Divides routes into pieces, on each of which the exposure is of one class and the mode of flight is the same. */
final class RoutePieces {
    private RoutePieces() {}

    /** The pieces of all routes, in the order in which they are flown. */
    static List<Piece> of(RouteSurvey survey) {
        List<Piece> pieces = new ArrayList<>();
        for (SectorRoute route : survey.routes()) {
            of(route).forEach(points -> pieces.add(piece(route, points, survey.modes())));
        }
        return pieces;
    }

    /** The points of each piece of a route, of which the last is the first of the next piece. */
    static List<List<RoutePoint>> of(SectorRoute route) {
        List<RoutePoint> points = route.profile().points();
        List<List<RoutePoint>> pieces = new ArrayList<>();
        int first = 0;
        for (int i = 1; i < points.size(); i++) {
            boolean isLast = i + 1 == points.size()
                    || points.get(i).mode() != points.get(first).mode()
                    || RouteColours.of(points.get(i), points.get(i + 1))
                            != RouteColours.of(points.get(i - 1), points.get(i));
            if (isLast) {
                pieces.add(points.subList(first, i + 1));
                first = i;
            }
        }
        return pieces;
    }

    private static Piece piece(SectorRoute route, List<RoutePoint> points, List<RouteMode> modes) {
        RouteColours style = RouteColours.of(points.get(0), points.get(1));
        RoutePoint end = points.get(points.size() - 1);
        List<Position> corners = points.stream()
                .filter(point -> point.isCorner() || point == end || point == points.get(0))
                .map(RoutePoint::position)
                .toList();
        return new Piece(
                "from the " + RouteWords.sector(route),
                style.words(),
                modes.get(points.get(0).mode()).name(),
                corners,
                style.colour(),
                points.get(0).time(),
                end.time(),
                route.detectionUntil(end.time()));
    }
}
