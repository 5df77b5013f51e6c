package org.dronewatch.report;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.dronewatch.scene.RunResult;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneResult;
import org.dronewatch.scene.SettingsPath;
import org.dronewatch.scene.SweepPoint;
import org.dronewatch.setting.Quantity;
import org.knowm.xchart.XYChart;

/** First-detection range over the value of a sweep, with the law that the scene expects. */
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

    /** The parameter as part of a file name. */
    String fileName() {
        return parameter.replaceAll("[^A-Za-z0-9]+", "-");
    }

    void write(Path file) {
        Quantity quantity =
                new SettingsPath(parameter).quantity(result.runs().get(0).settings());
        String unit = quantity.unit().isEmpty() ? "" : " [" + quantity.unit() + "]";
        XYChart chart = Charts.chart(
                result.scene() + ": range of first detection", parameter + unit, "range of first detection [m]");
        Set<String> sensors = new LinkedHashSet<>();
        result.sweep().forEach(point -> sensors.add(point.sensor()));
        for (String sensor : sensors) {
            addMeasured(chart, sensor);
            addExpected(chart, sensor);
        }
        if (!chart.getSeriesCollection().isEmpty()) {
            Charts.write(chart, file);
        }
    }

    private void addMeasured(XYChart chart, String sensor) {
        List<Double> x = new ArrayList<>();
        List<Double> y = new ArrayList<>();
        for (SweepPoint point : result.sweep()) {
            if (point.sensor().equals(sensor) && point.range().isPresent()) {
                x.add(((Number) point.value()).doubleValue());
                y.add(point.range().getAsDouble());
            }
        }
        if (!x.isEmpty()) {
            chart.addSeries(sensor, x, y);
        }
    }

    private void addExpected(XYChart chart, String sensor) {
        List<Double> x = new ArrayList<>();
        List<Double> y = new ArrayList<>();
        for (RunResult run : result.runs()) {
            OptionalDouble expected = scene.expectedRange(run.settings(), sensor);
            if (expected.isPresent()) {
                x.add(((Number) new SettingsPath(parameter).read(run.settings())).doubleValue());
                y.add(expected.getAsDouble());
            }
        }
        if (!x.isEmpty()) {
            Charts.asReference(chart.addSeries(sensor + ": mean law", x, y));
        }
    }
}
