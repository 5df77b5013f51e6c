package org.dronewatch.report;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import org.dronewatch.bench.CostCurves;
import org.knowm.xchart.XYChart;

/** Writes curves of costs: a table and a plot each, both axes logarithmic but for threads. */
public final class CostReport {
    private CostReport() {}

    /**
     * Writes a CSV file and a PNG picture for each.
     *
     * @param directory where to; made if it is not there, and it gets all files or none
     * @param study is done once it is known that the directory can be written
     */
    public static void write(Path directory, Supplier<List<CostCurves>> study) {
        try (OutputDirectory target = new OutputDirectory(directory)) {
            for (CostCurves curves : study.get()) {
                table(curves, target.file(curves.name() + ".csv"));
                plot(curves, target.file(curves.name() + ".png"));
            }
            target.publish(List.of());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void table(CostCurves curves, Path file) throws IOException {
        try (Table table = new Table(file, "line", curves.xLabel(), curves.yLabel())) {
            for (CostCurves.Line line : curves.lines()) {
                for (int i = 0; i < line.x().size(); i++) {
                    table.row(
                            line.name(),
                            Numbers.text(line.x().get(i)),
                            Numbers.text(line.y().get(i)));
                }
            }
        }
    }

    private static void plot(CostCurves curves, Path file) {
        XYChart chart = Charts.chart(curves.title(), curves.xLabel(), curves.yLabel());
        boolean linear = curves.xLabel().equals("threads");
        chart.getStyler().setXAxisLogarithmic(!linear).setYAxisLogarithmic(!linear);
        if (!linear) {
            chart.getStyler().setYAxisMin(null);
        }
        for (CostCurves.Line line : curves.lines()) {
            chart.addSeries(line.name(), line.x(), line.y());
        }
        Charts.write(chart, file);
    }
}
