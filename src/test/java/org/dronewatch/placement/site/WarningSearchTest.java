package org.dronewatch.placement.site;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.WarningMeasure;
import org.dronewatch.placement.solver.ExactSolver;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The layout with the longest warning among all, on a plain with four boxes, as {@code coverage} finds warnings. */
class WarningSearchTest {
    static final String CANDIDATES =
            """
            scene: site.yaml
            objective: warning-time
            candidates:
              radar:
                sensor: {kind: radar, minRange: 1, maxRange: 150, elevationWidth: 90 deg, minSpeed: 3 m/s,
                  budget: {range: 5000, crossSection: 0.01}}
                price: 2
                places: [[0, 90, 4], [0, -95, 4], [-55, 10, 17], [110, 0, 4]]
              radio:
                sensor: {kind: rf, threshold: 12}
                price: 1.5
                places: [[0, 0, 4], [60, 0, 4], [-50, -50, 4]]
            air: {side: 400 m, cell: 20 m, heights: [12 m, 40 m]}
            """;

    @TempDir
    private Path directory;

    private PlacePlan plan(String more) throws IOException {
        FieldSite.in(directory, FieldSite.ROUND + "alert: {protect: {centre: [0, 0, 15], radius: 30}}\n");
        Path file = Files.writeString(directory.resolve("early.place.yaml"), CANDIDATES + more);
        return PlacePlan.read(file, runner -> {}, note -> {});
    }

    /** The warning of a layout as a scene, s. */
    private static double warning(PlacePlan plan, Stage stage, WarningPlacement placement, List<Integer> chosen) {
        if (chosen.isEmpty()) {
            return 0.0;
        }
        Map<String, SensorSettings<?>> sensors = new LinkedHashMap<>();
        chosen.stream().map(plan.candidates()::get).forEach(one -> sensors.put(one.name(), one.sensor()));
        var scene = SettingsForm.with(plan.present(), Map.of("sensors", sensors, "disabled", Set.of()));
        InboundWarnings warnings = InboundWarnings.of(
                scene, stage, FieldSite.DRONE, placement.grid(), FieldTerms.ONE_LOOK, 0.5, cells -> {});
        var times = warnings.all().stream().mapToDouble(one -> one.time().orElse(0.0));
        return placement.measure() == WarningMeasure.WORST
                ? times.min().orElseThrow()
                : times.average().orElseThrow();
    }

    @Thorough
    @ParameterizedTest
    @CsvSource({"worst, 4, 0, false", "mean, 4, 0, true", "worst, 8, 1, true", "mean, 5, 5, false"})
    void isTheBestOfAllLayouts(String measure, double budget, double remaining, boolean isLong) throws IOException {
        assumeTrue(LongForm.IS_ON || !isLong, "searches all layouts");
        PlacePlan plan = plan("warning: " + measure + "\nbudget: " + budget + "\n"
                + (remaining > 0.0 ? "conditions: {anyoneLost: {warning: " + remaining + " s}}\n" : ""));
        Stage stage = plan.runner().stage(plan.present());
        WarningPlacement placement = new WarningSearch(plan, stage, LayerStore.NONE, new ExactSolver())
                .found(SolverLimits.NONE, cells -> {}, () -> {});
        double[] warnings = new double[1 << plan.candidates().size()];
        double best = 0.0;
        for (int choice = 0; choice < warnings.length; choice++) {
            int all = choice;
            List<Integer> chosen = IntStream.range(0, plan.candidates().size())
                    .filter(one -> (all >> one & 1) == 1)
                    .boxed()
                    .toList();
            double cost = chosen.stream()
                    .mapToDouble(one -> plan.candidates().get(one).candidate().cost())
                    .sum();
            if (cost <= budget) {
                warnings[choice] = warning(plan, stage, placement, chosen);
                boolean survives = remaining == 0.0
                        || !chosen.isEmpty()
                                && chosen.stream().allMatch(lost -> warnings[all & ~(1 << lost)] >= remaining);
                best = survives ? Math.max(best, warnings[choice]) : best;
            }
        }

        if (remaining == 0.0) {
            assertFront(placement, warnings);
        }
        assertThat(best).isBetween(1.0, 0.95 * placement.longest());
        assertThat(placement.complete()).isTrue();
        assertThat(placement.value()).isCloseTo(best, within(1e-9));
        assertThat(placement.bound()).isCloseTo(best, within(1e-9));
        assertThat(placement.withoutEach().values()).allMatch(left -> left >= remaining - 1e-9);
        assertThat(warning(plan, stage, placement, placement.result().chosen())).isCloseTo(best, within(1e-9));
    }

    /** Each layout of the front is the best of all for its cost, and its gain is where flights are seen earlier. */
    private static void assertFront(WarningPlacement whole, double[] warnings) {
        PlacePlan plan = whole.plan();
        BudgetFront<WarningPlacement> front = new FrontSearch<>(new CheaperWarnings(whole, new ExactSolver()))
                .found(FrontSearch.MOST, SolverLimits.NONE, budget -> {});
        assertThat(front.complete()).isTrue();
        assertThat(front.best().value()).isEqualTo(whole.value());
        assertThat(front.points()).hasSizeGreaterThan(1);
        for (FrontPoint<WarningPlacement> point : front.points()) {
            double most = 0.0;
            for (int choice = 0; choice < warnings.length; choice++) {
                int all = choice;
                double cost = IntStream.range(0, plan.candidates().size())
                        .filter(one -> (all >> one & 1) == 1)
                        .mapToDouble(
                                one -> plan.candidates().get(one).candidate().cost())
                        .sum();
                most = cost <= point.cost() ? Math.max(most, warnings[choice]) : most;
            }
            assertThat(point.layout().value()).isCloseTo(most, within(1e-9));
            assertThat(point.layout().bound())
                    .isGreaterThanOrEqualTo(point.layout().value());
            assertThat(point.gain()).hasValueSatisfying(gain -> {
                assertThat(gain.after()).isGreaterThan(gain.before());
                assertThat(gain.after()).isLessThanOrEqualTo(whole.longest());
            });
        }
    }

    /** Interrupted at any moment after the first candidate, it gives the best layout of those assessed. */
    @Test
    void anInterruptedSearchGivesTheBestSoFar() throws IOException {
        PlacePlan plan = plan("warning: mean\nbudget: 4\n");
        Stage stage = plan.runner().stage(plan.present());
        AtomicInteger calls = new AtomicInteger();
        new WarningSearch(plan, stage, LayerStore.NONE, new ExactSolver())
                .found(SolverLimits.NONE, cells -> calls.incrementAndGet(), () -> {});
        int all = calls.get();
        assertThat(all).isGreaterThan(plan.candidates().size());
        int layouts = 0;
        for (int when = 1; when <= all; when += LongForm.count(1 + all / 12, 1)) {
            AtomicInteger left = new AtomicInteger(when);
            try {
                WarningPlacement placement = new WarningSearch(plan, stage, LayerStore.NONE, new ExactSolver())
                        .found(
                                SolverLimits.NONE,
                                cells -> {
                                    if (left.decrementAndGet() == 0) {
                                        Thread.currentThread().interrupt();
                                    }
                                },
                                Thread::interrupted);
                layouts++;
                boolean isLeftOut = placement.assessed() < plan.candidates().size()
                        || placement.present().isEmpty()
                                && !plan.present().enabledSensors().isEmpty();
                assertThat(placement.complete())
                        .as("call " + when + " of " + all)
                        .isEqualTo(!isLeftOut);
                assertThat(placement.problem().isAllowed(placement.result().chosen()))
                        .isTrue();
                assertThat(placement.bound()).isGreaterThanOrEqualTo(placement.value());
            } catch (CancellationException e) {
                assertThat(when)
                        .as("of " + all)
                        .isLessThanOrEqualTo(all / plan.candidates().size() + 1);
            } finally {
                Thread.interrupted();
            }
        }
        assertThat(layouts).isGreaterThan(5);
    }
}
