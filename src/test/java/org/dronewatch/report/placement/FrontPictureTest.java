package org.dronewatch.report.placement;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.CheaperCoverage;
import org.dronewatch.placement.site.CoveredCells;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.FrontSearch;
import org.dronewatch.placement.site.PlaceSearch;
import org.dronewatch.placement.site.PlacedSite;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.placement.solver.ExactSolver;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;

/** The plot of value over cost shows the layouts as steps, the bounds above them, and today's layout at its price. */
class FrontPictureTest {
    @TempDir
    private Path directory;

    private static BudgetFront<SitePlacement> front(Path file) {
        PlacePlan plan = PlacePlan.read(file, runner -> {}, note -> {});
        CoveredCells cells = new CoveredCells(plan, plan.runner().stage(plan.present()), LayerStore.NONE);
        var whole = new PlaceSearch(plan, cells, new ExactSolver()).found(SolverLimits.NONE, some -> {}, () -> {});
        return new FrontSearch<>(new CheaperCoverage(whole, cells, new ExactSolver()))
                .found(4, SolverLimits.NONE, some -> {});
    }

    private static XYSeries series(XYChart chart, String name) {
        return chart.getSeriesCollection().stream()
                .filter(one -> one.getName().equals(name))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void stepsUpAtTheCostOfEachLayout() throws IOException {
        Path file = PlacedSite.in(directory, "budget: 7\n");
        Path site = directory.resolve("site.yaml");
        Files.writeString(site, Files.readString(site) + "prices: {currency: CHF, sensors: {round: 9}}\n");
        BudgetFront<SitePlacement> front = front(file);
        XYChart chart = new FrontPicture(front, new ShareMeasure(1, false, 8)).chart();
        XYSeries steps = series(chart, "best layouts");
        List<FrontPoint<SitePlacement>> points = front.points();

        assertThat(points).hasSizeBetween(2, 4);
        assertThat(steps.getXData()).hasSize(2 * points.size()).isSorted();
        assertThat(steps.getYData()).isSorted();
        for (int at = 0; at < points.size(); at++) {
            assertThat(steps.getXData()[2 * at]).isEqualTo(points.get(at).cost());
            assertThat(steps.getYData()[2 * at])
                    .isEqualTo(100.0 * points.get(at).layout().value());
        }
        assertThat(Arrays.stream(series(chart, "no layout covers more").getYData()))
                .allMatch(bound -> bound >= 100.0 * points.get(0).layout().value())
                .hasSize(2 * points.size());
        assertThat(chart.getXAxisTitle()).isEqualTo("cost [CHF]");
        XYSeries today = series(chart, "today's layout");
        assertThat(today.getXData()).containsExactly(9.0);
        assertThat(today.getYData())
                .containsExactly(100.0 * front.best().present().orElseThrow().value());
    }
}
