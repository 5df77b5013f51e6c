package org.dronewatch.report;

import java.awt.Color;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenario.SweptValue;
import org.dronewatch.setting.Quantity;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** A plot of one sensor's measured values versus range. */
final class RangePlot {
    private static final double TEN = 10.0;

    /** The least top of the plot, as a multiple of the threshold, so that the threshold is visible below it. */
    private static final double LEAST_TOP = 1.5;

    /** Thresholds of more runs than this are listed without their runs. */
    private static final int NAMED_RUNS = 2;

    private final SceneResult result;
    private final String sensor;
    private final List<RangeCurve> curves;
    /** The runs of each threshold. */
    private final Map<Double, Set<Integer>> thresholds = new LinkedHashMap<>();

    /**
     * A plot.
     *
     * @param curves one or more
     */
    RangePlot(SceneResult result, String sensor, List<RangeCurve> curves) {
        this.result = result;
        this.sensor = sensor;
        this.curves = curves;
        for (RangeCurve curve : curves) {
            curve.thresholds()
                    .forEach((run, threshold) -> threshold.ifPresent(level -> thresholds
                            .computeIfAbsent(level, none -> new TreeSet<>())
                            .add(run)));
        }
    }

    XYChart chart() {
        XYChart chart = Charts.chart(
                result.scene() + ": values measured by '" + sensor + "' vs range", "range [m]", valueAxis());
        for (int i = 0; i < curves.size(); i++) {
            RangeCurve curve = curves.get(i);
            XYSeries series = chart.addSeries(unique(chart, nameOf(curve)), curve.ranges(), curve.values());
            series.setMarker(curve.isOfOneRange() ? SeriesMarkers.CIRCLE : SeriesMarkers.NONE);
            series.setMarkerColor(Charts.colour(i)).setLineColor(Charts.colour(i));
        }
        double farthest =
                curves.stream().mapToDouble(RangeCurve::farthest).max().orElse(1.0);
        int drawn = 0;
        for (Map.Entry<Double, Set<Integer>> entry : thresholds.entrySet()) {
            double[] ends = {0.0, farthest};
            double[] level = {entry.getKey(), entry.getKey()};
            Charts.asReference(
                    chart.addSeries(unique(chart, nameOf(entry.getKey(), entry.getValue())), ends, level),
                    colourOf(entry.getValue(), drawn++));
        }
        RangeCurve any = curves.get(0);
        if (Double.isFinite(any.top())) {
            double most = curves.stream().mapToDouble(RangeCurve::highest).max().orElse(0.0);
            double toSee = thresholds.keySet().stream()
                    .mapToDouble(threshold -> LEAST_TOP * threshold)
                    .max()
                    .orElse(0.0);
            chart.getStyler().setYAxisMin(0.0);
            chart.getStyler().setYAxisMax(Math.min(any.top(), Math.max(1.05 * most, toSee)));
        } else {
            showDecibels(chart);
        }
        return chart;
    }

    /** What the plot shows, and whether a threshold is drawn. */
    String caption() {
        long without = curves.stream()
                .flatMap(curve -> curve.thresholds().values().stream())
                .filter(OptionalDouble::isEmpty)
                .count();
        String kind = settings(firstRun()).sensors().get(sensor).kind();
        String note = ", with the detection threshold.";
        if (thresholds.isEmpty()) {
            note = ". No threshold is drawn, since it differs from look to look.";
        } else if (without > 0) {
            note = ", with the detection threshold where it is the same in all looks.";
        }
        return "Values measured by '" + sensor + "' (" + kind + ") versus the drone's range" + note;
    }

    /** A decibel axis does not start at zero: it spans multiples of ten that include the thresholds. */
    private void showDecibels(XYChart chart) {
        double least = thresholds.keySet().stream()
                .mapToDouble(Double::doubleValue)
                .min()
                .orElse(Double.POSITIVE_INFINITY);
        double most = thresholds.keySet().stream()
                .mapToDouble(Double::doubleValue)
                .max()
                .orElse(Double.NEGATIVE_INFINITY);
        for (RangeCurve curve : curves) {
            least = Math.min(least, curve.lowest());
            most = Math.max(most, curve.highest());
        }
        double from = TEN * Math.floor(least / TEN);
        chart.getStyler().setYAxisMin(from);
        chart.getStyler().setYAxisMax(Math.max(from + TEN, TEN * Math.ceil(most / TEN)));
    }

    private String valueAxis() {
        RangeCurve any = curves.get(0);
        String measured =
                settings(firstRun()).sensors().get(sensor).description().measures();
        String what = any.unit().isEmpty() ? measured : measured + " [" + any.unit() + "]";
        boolean cut = curves.stream().anyMatch(RangeCurve::isCut);
        return cut ? what + ", clipped at " + Quantity.NUMBER.inBrief(any.top()) : what;
    }

    private int firstRun() {
        return curves.get(0).thresholds().keySet().iterator().next();
    }

    /** The plotting library rejects duplicate series names. */
    private static String unique(XYChart chart, String name) {
        Set<String> taken =
                chart.getSeriesCollection().stream().map(XYSeries::getName).collect(Collectors.toSet());
        String free = name;
        for (int i = 2; taken.contains(free); i++) {
            free = name + " (" + i + ")";
        }
        return free;
    }

    private String nameOf(RangeCurve curve) {
        Collection<Integer> runs = curve.thresholds().keySet();
        if (runs.size() > 1 && runs.size() <= NAMED_RUNS) {
            return curve.drone() + swept(runs);
        }
        return runs.size() > 1
                ? curve.drone() + ", " + runs.size() + " identical runs"
                : (curve.drone() + swept(runs)).strip();
    }

    private String nameOf(double threshold, Collection<Integer> runs) {
        String name = ("threshold " + Quantity.NUMBER.inBrief(threshold) + " "
                        + curves.get(0).unit())
                .strip();
        return thresholds.size() > 1 && runs.size() <= NAMED_RUNS ? name + swept(runs) : name;
    }

    /** The values of what is swept in some runs, after a comma; empty without a sweep. */
    private String swept(Collection<Integer> runs) {
        String values = runs.stream()
                .map(this::settings)
                .flatMap(
                        settings -> settings.sweep().stream().map(sweep -> new SweptValue(settings, sweep).shortText()))
                .distinct()
                .collect(Collectors.joining(" and "));
        return values.isEmpty() ? "" : ", " + values;
    }

    /**
     * The settings of the run with a given number, which differs from its index if only some runs of the sweep were
     * made.
     */
    private SceneSettings settings(int run) {
        return result.runs().stream()
                .filter(one -> one.run() == run)
                .findFirst()
                .orElseThrow()
                .settings();
    }

    /**
     * The colour of a threshold: grey if it is the only one, that of its curve if it belongs to only one, otherwise one
     * that no curve has.
     */
    private Color colourOf(Set<Integer> runs, int number) {
        if (thresholds.size() == 1) {
            return Color.GRAY;
        }
        List<RangeCurve> theirs = curves.stream()
                .filter(curve -> curve.thresholds().keySet().stream().anyMatch(runs::contains))
                .toList();
        boolean own = theirs.size() == 1
                && runs.containsAll(theirs.get(0).thresholds().keySet());
        return Charts.colour(own ? curves.indexOf(theirs.get(0)) : curves.size() + number);
    }
}
