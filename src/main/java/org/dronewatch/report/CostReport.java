package org.dronewatch.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.function.Supplier;
import org.dronewatch.bench.CostCurves;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.file.OutputDirectory;
import org.dronewatch.report.file.Table;
import org.knowm.xchart.XYChart;

/**
 * Writes cost curves, each as a table and a plot. The axes are logarithmic, with two exceptions: plots versus the
 * number of threads have linear axes, and costs that differ by at most a factor of two have a linear axis.
 */
public final class CostReport {
    /** Format of the numbers at logarithmic axes, which would otherwise be shown as 1E4. */
    private static final String PLAIN = "#,##0.#########";

    private CostReport() {}

    /**
     * Writes a CSV file and a PNG image for each curve.
     *
     * @param directory the target, which is created if missing and receives either all files or none
     * @param study returns the curves; called once the directory is known to be writable
     */
    public static void write(Path directory, Supplier<List<CostCurves>> study) {
        try (OutputDirectory target = new OutputDirectory(directory)) {
            List<CostCurves> all = study.get();
            target.write(() -> {
                for (CostCurves curves : all) {
                    table(curves, target.file(curves.name() + ".csv"));
                    plot(curves, target.file(curves.name() + ".png"));
                }
                target.publish(List.of());
            });
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
        if (!curves.xLabel().equals("threads")) {
            chart.getStyler().setXAxisLogarithmic(true).setXAxisDecimalPattern(PLAIN);
            if (grows(curves)) {
                chart.getStyler().setYAxisMin(null).setYAxisLogarithmic(true).setYAxisDecimalPattern(PLAIN);
            }
        }
        for (CostCurves.Line line : curves.lines()) {
            chart.addSeries(line.name(), line.x(), line.y());
        }
        Charts.write(chart, file);
    }

    /** A cost that hardly changes is shown from zero. */
    private static boolean grows(CostCurves curves) {
        DoubleSummaryStatistics costs = curves.lines().stream()
                .flatMap(line -> line.y().stream())
                .mapToDouble(Double::doubleValue)
                .summaryStatistics();
        return costs.getMax() > 2.0 * costs.getMin();
    }
}
