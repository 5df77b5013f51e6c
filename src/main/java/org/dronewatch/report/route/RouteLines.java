package org.dronewatch.report.route;

import java.awt.Color;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.render.canvas.SiteLines;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;

/** Routes as lines through a view of the site, coloured by how exposed the drone is. */
public final class RouteLines {
    private RouteLines() {}

    /** The lines, each with its direction and the probability that the drone is detected. */
    public static SiteLines of(RouteSurvey survey) {
        Map<String, Color> legend = new LinkedHashMap<>();
        for (RouteColours style : RouteColours.values()) {
            legend.put("chance of a detection within 1 s: " + style.words(), style.colour());
        }
        return new SiteLines(
                survey.routes().stream()
                        .filter(route -> route.profile().points().size() > 1)
                        .map(route -> line(route, survey))
                        .toList(),
                legend);
    }

    private static SiteLines.Line line(SectorRoute route, RouteSurvey survey) {
        double response = survey.response();
        String inTime = response > 0.0 ? ", " + RouteNumbers.percent(route.inTime(response)) + " in time" : "";
        String words = RouteWords.sector(route) + ": "
                + (route.detection() == 0.0
                        ? "not detected"
                        : RouteNumbers.percent(route.detection()) + " detected" + inTime);
        List<SiteLines.Piece> pieces =
                RoutePieces.of(route).stream().map(RouteLines::piece).toList();
        return new SiteLines.Line(words, pieces);
    }

    private static SiteLines.Piece piece(List<RoutePoint> points) {
        RouteColours style = RouteColours.of(points.get(0), points.get(1));
        return new SiteLines.Piece(points.stream().map(RoutePoint::position).toList(), style.colour(), style.width());
    }
}
