package org.dronewatch.report.placement;

import java.awt.Color;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.placement.site.PresentLayout;
import org.dronewatch.report.Charts;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** The value of the best layouts versus their cost, as steps, with the most that any layout could reach. */
final class FrontPicture {
    private static final Color LAYOUTS = new Color(0x0072b2);
    private static final Color TODAY = new Color(0xd55e00);
    private static final double TEN = 10.0;

    /** The part of the axis that is left free above what is drawn, if values have no limit. */
    private static final double FREE = 0.05;

    private final BudgetFront<? extends PlacedLayout> front;
    private final PlaceMeasure measure;
    private final PlacePlan plan;
    private final double dearest;

    FrontPicture(BudgetFront<? extends PlacedLayout> front, PlaceMeasure measure) {
        this.front = front;
        this.measure = measure;
        this.plan = front.best().plan();
        this.dearest = Math.max(plan.settings().budget(), priceOfToday().orElse(0.0));
    }

    /** The plot. */
    XYChart chart() {
        String currency = plan.present().prices().currency();
        XYChart chart = Charts.chart(
                plan.scene().name() + ": best layouts for the money", "cost [" + currency + "]", measure.axis());
        addLayouts(chart);
        addBound(chart);
        front.best().present().ifPresent(own -> addToday(chart, own));
        DoubleSummaryStatistics drawn = chart.getSeriesCollection().stream()
                .flatMapToDouble(series -> DoubleStream.of(series.getYMin(), series.getYMax()))
                .summaryStatistics();
        double least = drawn.getMin();
        chart.getStyler()
                .setXAxisMin(0.0)
                .setYAxisMin(Math.max(0.0, Math.floor(least / TEN - 0.5) * TEN))
                .setYAxisMax(measure.most().orElse(Math.max(1.0, (1.0 + FREE) * drawn.getMax())))
                .setXAxisDecimalPattern("#,##0.##");
        return chart;
    }

    /** A step up at the cost of each layout. */
    private void addLayouts(XYChart chart) {
        List<Double> costs = new ArrayList<>();
        List<Double> values = new ArrayList<>();
        for (FrontPoint<? extends PlacedLayout> point : front.points()) {
            if (!values.isEmpty()) {
                costs.add(point.cost());
                values.add(values.get(values.size() - 1));
            }
            costs.add(point.cost());
            values.add(measure.plotted(point.layout().value()));
        }
        costs.add(dearest);
        values.add(values.get(values.size() - 1));
        XYSeries steps = chart.addSeries("best layouts", costs, values);
        steps.setMarker(SeriesMarkers.NONE).setLineColor(LAYOUTS).setLineWidth(3f);
        XYSeries dots = chart.addSeries(
                "layouts",
                front.points().stream().map(FrontPoint::cost).toList(),
                front.points().stream()
                        .map(point -> measure.plotted(point.layout().value()))
                        .toList());
        dots.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
        dots.setMarker(SeriesMarkers.CIRCLE).setMarkerColor(LAYOUTS).setShowInLegend(false);
    }

    /** The bound of a layout holds for all budgets above that of the previous layout. */
    private void addBound(XYChart chart) {
        List<Double> budgets = new ArrayList<>();
        List<Double> bounds = new ArrayList<>();
        double from = front.points().get(0).cost();
        for (FrontPoint<? extends PlacedLayout> point : front.points()) {
            double bound = measure.plotted(point.layout().bound());
            budgets.add(from);
            bounds.add(bound);
            budgets.add(point.budget());
            bounds.add(bound);
            from = point.budget();
        }
        Charts.asReference(chart.addSeries(measure.unbeaten(), budgets, bounds));
    }

    /** A point if all prices are known; otherwise a line, since the cost of today's layout is then unknown. */
    private void addToday(XYChart chart, PresentLayout own) {
        double value = measure.plotted(own.value());
        OptionalDouble price = priceOfToday();
        if (price.isPresent()) {
            XYSeries point =
                    chart.addSeries("today's layout", new double[] {price.getAsDouble()}, new double[] {value});
            point.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
            point.setMarker(SeriesMarkers.DIAMOND).setMarkerColor(TODAY);
        } else {
            XYSeries line = chart.addSeries(
                    "today's layout, at unknown cost", new double[] {0.0, dearest}, new double[] {value, value});
            line.setMarker(SeriesMarkers.NONE).setLineColor(TODAY).setLineWidth(2f);
        }
    }

    private OptionalDouble priceOfToday() {
        Map<String, Double> prices = plan.present().prices().sensors();
        var own = plan.present().enabledSensors().keySet();
        return !own.isEmpty() && prices.keySet().containsAll(own)
                ? OptionalDouble.of(own.stream().mapToDouble(prices::get).sum())
                : OptionalDouble.empty();
    }
}
