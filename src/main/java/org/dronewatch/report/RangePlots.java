package org.dronewatch.report;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.dronewatch.scene.Frame;
import org.dronewatch.scene.SceneResult;
import org.dronewatch.scene.SceneSettings;
import org.dronewatch.sensor.Observation;
import org.dronewatch.setting.Quantity;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** For each sensor, what it measured over the range, with its threshold: shows how close each decision was. */
final class RangePlots {
    /** More points than a plot can show; what comes later is left out. */
    private static final int MAX_POINTS = 200_000;

    /** Above so many thresholds the drone is certain, and the plot would only lose its scale. */
    private static final double TOP = 10.0;

    private static final double TEN = 10.0;

    /** The threshold is to be seen below the top, in thresholds. */
    private static final double LEAST_TOP = 1.5;

    private final Map<String, Map<List<Object>, Series>> sensors = new LinkedHashMap<>();
    private int points;

    void add(Frame frame) {
        for (Observation observation : frame.observations()) {
            // Minus infinity is the level of silence: nothing to draw.
            if (points < MAX_POINTS && Double.isFinite(observation.value())) {
                points++;
                sensors.computeIfAbsent(observation.sensor(), name -> new LinkedHashMap<>())
                        .computeIfAbsent(List.of(frame.run(), observation.drone()), key -> new Series(observation))
                        .add(observation);
            }
        }
    }

    /**
     * Writes a plot for each sensor.
     *
     * @param files where the plot of a sensor's name goes
     */
    void write(SceneResult result, Function<String, Path> files) {
        sensors.forEach((sensor, series) -> {
            Series any = series.values().iterator().next();
            XYChart chart = Charts.chart(
                    result.scene() + ": what '" + sensor + "' measured over the range",
                    "range [m]",
                    axisOf(series.values()));
            double farthest =
                    series.values().stream().mapToDouble(Series::farthest).max().orElse(1.0);
            series.forEach((key, values) -> {
                String name = name((int) key.get(0), (String) key.get(1), result);
                chart.addSeries(name, values.range, values.value).setMarker(SeriesMarkers.NONE);
            });
            // Where chance decides, each look has a threshold of its own: no line can stand for them.
            series.values().stream()
                    .filter(values -> !values.thresholdVaries)
                    .mapToDouble(values -> values.threshold)
                    .distinct()
                    .forEach(threshold -> {
                        String name = "threshold " + Quantity.NUMBER.inBrief(threshold) + " " + any.unit;
                        double[] ends = {0.0, farthest};
                        Charts.asReference(chart.addSeries(name, ends, new double[] {threshold, threshold}));
                    });
            if (Double.isFinite(any.top())) {
                double most = series.values().stream()
                        .mapToDouble(Series::highest)
                        .max()
                        .orElse(0.0);
                chart.getStyler().setYAxisMin(0.0);
                chart.getStyler().setYAxisMax(Math.min(any.top(), Math.max(1.05 * most, LEAST_TOP * any.threshold)));
            } else {
                showDecibels(chart, series.values());
            }
            Charts.write(chart, files.apply(sensor));
        });
    }

    /** Zero is no end of a scale of decibels: from one ten to another, with the thresholds that are drawn. */
    private static void showDecibels(XYChart chart, Collection<Series> series) {
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (Series values : series) {
            least = Math.min(least, values.lowest());
            most = Math.max(most, values.highest());
            if (!values.thresholdVaries) {
                least = Math.min(least, values.threshold);
                most = Math.max(most, values.threshold);
            }
        }
        double from = TEN * Math.floor(least / TEN);
        chart.getStyler().setYAxisMin(from);
        chart.getStyler().setYAxisMax(Math.max(from + TEN, TEN * Math.ceil(most / TEN)));
    }

    private static String axisOf(Collection<Series> series) {
        Series any = series.iterator().next();
        if (any.unit.isEmpty()) {
            return "probability";
        }
        String what = any.unit.equals(Quantity.PIXELS.unit()) ? "pixels of the drone" : "value [" + any.unit + "]";
        boolean cut = series.stream().anyMatch(values -> values.cut);
        return cut ? what + ", cut at " + Quantity.NUMBER.inBrief(any.top()) : what;
    }

    private static String name(int run, String drone, SceneResult result) {
        SceneSettings settings = result.runs().get(run).settings();
        return settings.sweep()
                .map(sweep -> drone + ", " + new SweptValue(settings, sweep).shortText())
                .orElse(drone);
    }

    private static final class Series {
        private final List<Double> range = new ArrayList<>();
        private final List<Double> value = new ArrayList<>();
        private final double threshold;
        private final String unit;
        private boolean thresholdVaries;
        private boolean cut;

        Series(Observation first) {
            this.threshold = first.threshold();
            this.unit = first.unit();
        }

        void add(Observation observation) {
            thresholdVaries |= observation.threshold() != threshold;
            range.add(observation.range());
            cut |= observation.value() > top();
            value.add(Math.min(observation.value(), top()));
        }

        /** Levels are logarithms: they need no top. */
        double top() {
            if (unit.equals(Quantity.LEVEL.unit())) {
                return Double.POSITIVE_INFINITY;
            }
            return unit.isEmpty() ? 1.0 : TOP * threshold;
        }

        double highest() {
            return value.stream().mapToDouble(Double::doubleValue).max().orElse(0.0);
        }

        double lowest() {
            return value.stream().mapToDouble(Double::doubleValue).min().orElse(0.0);
        }

        double farthest() {
            return range.stream().mapToDouble(Double::doubleValue).max().orElse(0.0);
        }
    }
}
