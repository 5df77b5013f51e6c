package org.dronewatch.placement.site;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.DoubleFunction;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.solver.ExactSolver;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A step that the table would print like the one before buys nothing that anyone could see. */
class FrontSearchTest {
    @TempDir
    private Path directory;

    /** What is printed like buying nothing buys nothing, either; the best layout is stated in any case. */
    @Test
    void layoutsThatArePrintedLikeNothingAreLeftOut() throws IOException {
        CheaperCoverage cheaper = cheaper();
        List<FrontPoint<SitePlacement>> all = new FrontSearch<>(cheaper)
                .found(FrontSearch.MOST, SolverLimits.NONE, budget -> {})
                .points();
        for (int least = 0; least < all.size(); least++) {
            double limit = all.get(least).layout().value();
            DoubleFunction<String> coarse = value -> value < limit ? "none" : Double.toString(value);
            BudgetFront<SitePlacement> printed =
                    new FrontSearch<>(cheaper, coarse).found(FrontSearch.MOST, SolverLimits.NONE, budget -> {});

            assertThat(printed.points())
                    .extracting(point -> point.layout().result().chosen())
                    .containsExactlyElementsOf(all.subList(least, all.size()).stream()
                            .map(point -> point.layout().result().chosen())
                            .toList());
        }
        assertThat(all).hasSizeGreaterThan(2);
    }

    private CheaperCoverage cheaper() throws IOException {
        PlacePlan plan = PlacePlan.read(PlacedSite.in(directory, "budget: 9\n"), runner -> {}, note -> {});
        CoveredCells cells = new CoveredCells(plan, plan.runner().stage(plan.present()), LayerStore.NONE);
        SitePlacement whole =
                new PlaceSearch(plan, cells, new ExactSolver()).found(SolverLimits.NONE, some -> {}, () -> {});
        return new CheaperCoverage(whole, cells, new ExactSolver());
    }

    @Test
    void ofLayoutsThatArePrintedAlikeOnlyTheCheapestIsKept() throws IOException {
        CheaperCoverage cheaper = cheaper();
        DoubleFunction<String> tenths = value -> String.format(Locale.ROOT, "%.1f", value);
        BudgetFront<SitePlacement> all =
                new FrontSearch<>(cheaper).found(FrontSearch.MOST, SolverLimits.NONE, budget -> {});
        BudgetFront<SitePlacement> printed =
                new FrontSearch<>(cheaper, tenths).found(FrontSearch.MOST, SolverLimits.NONE, budget -> {});
        Map<String, FrontPoint<SitePlacement>> cheapest = new LinkedHashMap<>();
        all.points()
                .forEach(point ->
                        cheapest.putIfAbsent(tenths.apply(point.layout().value()), point));

        cheapest.remove(tenths.apply(0.0));
        assertThat(cheapest).hasSizeBetween(2, all.points().size() - 1);
        assertThat(printed.points())
                .extracting(point -> point.layout().result().chosen())
                .containsExactlyElementsOf(cheapest.values().stream()
                        .map(point -> point.layout().result().chosen())
                        .toList());
        assertThat(printed.best().result().cost())
                .isLessThan(all.best().result().cost());
        assertThat(printed.best().result().bound())
                .isGreaterThanOrEqualTo(all.best().result().value());
    }
}
