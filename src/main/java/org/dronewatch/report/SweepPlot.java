package org.dronewatch.report;

import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.SweepPoint;
import org.dronewatch.scenario.SweepAxis;
import org.dronewatch.scene.Scene;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsPath;
import org.knowm.xchart.XYChart;

/** First-detection range versus the swept value, with the analytic model of the scene if there is one. */
final class SweepPlot {
    private final Scene scene;
    private final SceneResult result;
    private final String parameter;

    private SweepPlot(Scene scene, SceneResult result, String parameter) {
        this.scene = scene;
        this.result = result;
        this.parameter = parameter;
    }

    /** The plot of a result, or empty when it has no sweep over numbers. */
    static Optional<SweepPlot> of(Scene scene, SceneResult result) {
        List<SweepPoint> points = result.sweep();
        boolean numbers = !points.isEmpty() && points.stream().allMatch(point -> point.value() instanceof Number);
        return numbers ? Optional.of(new SweepPlot(scene, result, points.get(0).parameter())) : Optional.empty();
    }

    /** The caption. */
    String caption() {
        return "Range at which each sensor first detects a drone, as a function of '" + parameter + "'.";
    }

    /** The parameter as part of a file name. */
    String fileName() {
        return parameter.replaceAll("[^A-Za-z0-9]+", "-");
    }

    void write(Path file) {
        SweepAxis axis = scene.sweepAxis().orElseGet(this::ofTheSetting);
        XYChart chart = Charts.chart(
                result.scene() + ": range of first detection", axis.label(), "range of first detection [m]");
        Set<String> sensors = new LinkedHashSet<>();
        result.sweep().forEach(point -> sensors.add(point.sensor()));
        for (String sensor : sensors) {
            addMeasured(chart, axis, sensor);
            addExpected(chart, axis, sensor);
        }
        if (!chart.getSeriesCollection().isEmpty()) {
            Charts.write(chart, file);
        }
    }

    private SweepAxis ofTheSetting() {
        SettingsPath path = new SettingsPath(parameter);
        Quantity quantity = path.quantity(result.runs().get(0).settings());
        String unit = quantity.displayUnit();
        String label = unit.isEmpty() ? parameter : parameter + " [" + unit + "]";
        return new SweepAxis(label, settings -> quantity.displayed(((Number) path.read(settings)).doubleValue()));
    }

    private void addMeasured(XYChart chart, SweepAxis axis, String sensor) {
        Map<Double, Double> points = new TreeMap<>();
        for (RunResult run : result.runs()) {
            run.firstDetectionRange(sensor)
                    .ifPresent(range -> points.put(axis.value().applyAsDouble(run.settings()), range));
        }
        if (!points.isEmpty()) {
            chart.addSeries(sensor, List.copyOf(points.keySet()), List.copyOf(points.values()));
        }
    }

    private void addExpected(XYChart chart, SweepAxis axis, String sensor) {
        Map<Double, Double> points = new TreeMap<>();
        for (RunResult run : result.runs()) {
            scene.expectedRange(run.settings(), sensor)
                    .ifPresent(range -> points.put(axis.value().applyAsDouble(run.settings()), range));
        }
        if (!points.isEmpty()) {
            String name = sensor + ": expected";
            Charts.asReference(chart.addSeries(name, List.copyOf(points.keySet()), List.copyOf(points.values())));
        }
    }
}
