package org.dronewatch.report.route;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.List;
import java.util.stream.DoubleStream;
import org.dronewatch.report.Charts;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.SectorRoute;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.XYSeries.XYSeriesRenderStyle;
import org.knowm.xchart.style.Styler.YAxisPosition;
import org.knowm.xchart.style.markers.SeriesMarkers;

/**
 * The height of a route and of the ground below it versus the distance flown, with the probability of a detection so
 * far.
 */
final class RouteProfilePicture {
    private static final Color GROUND = new Color(0xb9b2a5);
    private static final Color EXPOSURE = new Color(0xb2182b);
    private static final float[] DASHES = {10f, 6f};

    private RouteProfilePicture() {}

    /** The plot; heights are those of the world frame. */
    static XYChart of(SectorRoute route, RouteInputs inputs) {
        XYChart chart = Charts.chart(
                inputs.scene() + ": the route from the " + RouteWords.sector(route),
                "distance flown [m]",
                "height (z) [m]");
        List<RoutePoint> points = route.profile().points();
        double[] distances = points.stream().mapToDouble(RoutePoint::distance).toArray();
        double[] ground = points.stream()
                .mapToDouble(point -> point.position().z() - point.above())
                .toArray();
        double[] flight =
                points.stream().mapToDouble(point -> point.position().z()).toArray();
        // The probabilities of the table: looks count when they are taken, and are not spread as on the plan.
        double[] detected = points.stream()
                .mapToDouble(point -> 100.0 * route.detectionUntil(point.time()))
                .toArray();
        XYSeries below = chart.addSeries("ground", distances, ground);
        below.setMarker(SeriesMarkers.NONE).setLineColor(GROUND).setFillColor(GROUND);
        below.setXYSeriesRenderStyle(XYSeriesRenderStyle.Area);
        XYSeries path = chart.addSeries("flight", distances, flight);
        path.setMarker(SeriesMarkers.NONE).setLineColor(Color.BLACK).setLineWidth(3f);
        XYSeries seen = chart.addSeries("detected so far [%], right-hand scale", distances, detected);
        seen.setMarker(SeriesMarkers.NONE).setLineColor(EXPOSURE);
        seen.setLineStyle(new BasicStroke(3f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10f, DASHES, 0f));
        seen.setYAxisGroup(1);
        chart.setYAxisGroupTitle(1, "detected so far [%]");
        chart.getStyler().setYAxisGroupPosition(1, YAxisPosition.Right);
        chart.getStyler().setYAxisMin(1, 0.0).setYAxisMax(1, 100.0);
        double lowest = DoubleStream.of(ground).min().orElse(0.0);
        double highest = DoubleStream.of(flight).max().orElse(1.0);
        chart.getStyler()
                .setYAxisMin(0, Math.min(0.0, lowest))
                .setYAxisMax(0, highest + 0.1 * (highest - lowest) + 1.0);
        if (inputs.response() > 0.0) {
            double critical = at(points, Math.max(0.0, route.critical(inputs.response())));
            XYSeries last = chart.addSeries(
                    "critical detection point: last timely detection",
                    new double[] {critical, critical},
                    new double[] {Math.min(0.0, lowest), highest});
            Charts.asReference(last);
        }
        return chart;
    }

    /** The distance flown by a time, m. */
    private static double at(List<RoutePoint> points, double time) {
        for (int i = 1; i < points.size(); i++) {
            RoutePoint before = points.get(i - 1);
            RoutePoint after = points.get(i);
            if (after.time() >= time) {
                double share = (time - before.time()) / (after.time() - before.time());
                return before.distance() + share * (after.distance() - before.distance());
            }
        }
        return points.get(points.size() - 1).distance();
    }
}
