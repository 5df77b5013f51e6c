package org.dronewatch.placement.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.RadarCandidates;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.AirSettings;
import org.dronewatch.placement.plan.LayoutConditions;
import org.dronewatch.placement.plan.PlaceObjective;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.PlaceSettings;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.CoveredCells;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.FrontSearch;
import org.dronewatch.placement.site.PlaceSearch;
import org.dronewatch.placement.site.PlaceStep;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.placement.solver.ExactSolver;
import org.dronewatch.report.placement.RoutePlaceResults;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Layouts round a protected zone, on a plain with four boxes, against the weakest routes that {@code route} finds. */
class WeakestRouteSearchTest {
    static final String CANDIDATES =
            "scene: site.yaml\nobjective: weakest-route\n" + RadarCandidates.SIX + RadarCandidates.AIR;

    @TempDir
    private Path directory;

    private PlacePlan plan(String more) throws IOException {
        FieldSite.in(directory, FieldSite.ROUND + "alert: {protect: {centre: [0, 0, 15], radius: 30}}\n");
        Path file = Files.writeString(directory.resolve("ring.place.yaml"), CANDIDATES + more);
        return PlacePlan.read(file, runner -> {}, note -> {});
    }

    static RoutePlacement found(PlacePlan plan) {
        Stage stage = plan.runner().stage(plan.present());
        return new WeakestRouteSearch(plan, stage, LayerStore.NONE, new ExactSolver())
                .found(SolverLimits.NONE, cells -> {}, round -> {});
    }

    /** The exposure on the weakest route past a layout, as {@code route} finds it for the layout as a scene. */
    private static double exposure(PlacePlan plan, RoutePlacement placement, Stage stage, List<Integer> chosen) {
        return exposure(plan, plan.present(), stage, placement.grid(), chosen);
    }

    /** The same under a condition. */
    static double exposure(PlacePlan plan, SceneSettings present, Stage stage, FieldGrid grid, List<Integer> chosen) {
        if (chosen.isEmpty()) {
            return 0.0;
        }
        SiteRoutes routes = routes(plan, present, stage, grid, chosen);
        return IntStream.range(0, SiteRoutes.SECTORS)
                .mapToObj(routes::from)
                .flatMap(Optional::stream)
                .mapToDouble(WeakestRoute::exposure)
                .min()
                .orElseThrow();
    }

    /** The routes past a layout as a scene. */
    private static SiteRoutes routes(
            PlacePlan plan, SceneSettings present, Stage stage, FieldGrid grid, List<Integer> chosen) {
        Map<String, SensorSettings<?>> sensors = new LinkedHashMap<>();
        chosen.stream().map(plan.candidates()::get).forEach(one -> sensors.put(one.name(), one.sensor()));
        var scene = SettingsForm.with(present, Map.of("sensors", sensors, "disabled", Set.of()));
        DetectionField field = FieldAssessment.of(
                scene,
                stage,
                plan.drone(),
                grid,
                Course.all(sensors, DetectionField.droneOf(stage, plan.drone())),
                FieldTerms.ONE_LOOK.withPointing(FieldTerms.Turning.SEARCH),
                cells -> {});
        return SiteRoutes.of(field, scene, stage, plan.drone());
    }

    @ParameterizedTest
    @CsvSource({"3, 0", "6, 0.05"})
    void isTheBestOfAllLayouts(double budget, double remaining) throws IOException {
        assumeTrue(LongForm.IS_ON || remaining == 0.0, "searches for the routes past sixty layouts");
        PlacePlan plan = plan("budget: " + budget + "\n"
                + (remaining > 0.0 ? "conditions: {anyoneLost: {atLeast: " + remaining + "}}\n" : ""));
        RoutePlacement placement = found(plan);
        Stage stage = plan.runner().stage(plan.present());
        double[] exposures = new double[1 << plan.candidates().size()];
        double best = 0.0;
        for (int choice = 0; choice < exposures.length; choice++) {
            List<Integer> chosen = chosen(plan, choice);
            double cost = chosen.stream()
                    .mapToDouble(one -> plan.candidates().get(one).candidate().cost())
                    .sum();
            if (cost <= budget) {
                exposures[choice] = exposure(plan, placement, stage, chosen);
                int all = choice;
                boolean survives = remaining == 0.0
                        || !chosen.isEmpty()
                                && chosen.stream()
                                        .allMatch(lost -> exposures[all & ~(1 << lost)] >= -Math.log1p(-remaining));
                best = survives ? Math.max(best, exposures[choice]) : best;
            }
        }

        assertThat(best).isBetween(0.05, 10.0);
        assertThat(placement.complete()).isTrue();
        assertThat(placement.result().value()).isCloseTo(best, within(0.01 * best));
        assertThat(placement.result().bound()).isBetween(placement.result().value(), 1.01 * best);
        assertThat(placement.lower()).isBetween(0.0, placement.result().value());
        if (remaining == 0.0) {
            assertFront(plan, exposures);
            assertPurchases(placement, exposures);
        }
        double promised = exposure(plan, placement, stage, placement.result().chosen());
        assertThat(placement.result().value()).isCloseTo(promised, within(1e-3 * promised));
    }

    /** Each step states what the sensors so far are worth: the most of all with one sensor less than the next step. */
    private static void assertPurchases(RoutePlacement placement, double[] exposures) {
        List<PlaceStep> steps = placement.purchases();
        List<Integer> chosen = placement.result().chosen();
        assertThat(steps).hasSameSizeAs(chosen).hasSizeGreaterThan(1);
        int bought = 0;
        for (PlaceStep step : steps) {
            int before = bought;
            bought |= chosen.stream()
                    .filter(one -> placement.plan().candidates().get(one).name().equals(step.added()))
                    .mapToInt(one -> 1 << one)
                    .sum();
            int all = bought;
            double best = chosen.stream()
                    .filter(one -> (all >> one & 1) == 1)
                    .mapToDouble(one -> exposures[all & ~(1 << one)])
                    .max()
                    .orElseThrow();
            assertThat(step.value()).isCloseTo(exposures[all], within(0.01 * exposures[all] + 1e-6));
            assertThat(exposures[before]).isCloseTo(best, within(0.01 * best + 1e-6));
        }
    }

    /** A flight of 2 m into the zone, say: whatever the layout is, it is no more exposed than there. */
    @Thorough
    @Test
    void aRouteThatWasFoundOtherwiseCountsForEachLayout() throws IOException {
        PlacePlan plan = plan("budget: 4\n");
        Stage stage = plan.runner().stage(plan.present());
        RouteLayouts layouts =
                new WeakestRouteSearch(plan, stage, LayerStore.NONE, new ExactSolver()).assessed(cells -> {});
        RoutePlacement before = layouts.found(SolverLimits.NONE, round -> {});
        SiteRoutes all = routes(
                plan,
                plan.present(),
                stage,
                before.grid(),
                chosen(plan, (1 << plan.candidates().size()) - 1));
        RoutePath path = new RoutePath(List.of(new Position(0, 31, 30), new Position(0, 29, 30)), List.of(0));
        SectorRoute learned = all.describe(0, new WeakestRoute(path, 0.0, 0.0, 2.0 / 12.0));
        Map<String, Double> exposures = learned.bySensor();
        assertThat(layouts.holds(before)).isTrue();
        int known = before.routes();

        layouts.learn(List.of(learned));
        assertThat(layouts.holds(before)).isFalse();
        RoutePlacement after = layouts.found(SolverLimits.NONE, round -> {});
        BudgetFront<RoutePlacement> front =
                new FrontSearch<>(layouts.cheaper(after)).found(FrontSearch.MOST, SolverLimits.NONE, budget -> {});

        assertThat(after.complete()).isTrue();
        assertThat(after.routes()).isGreaterThan(known);
        assertThat(after.weakest().route().path()).isEqualTo(path);
        assertThat(after.value()).isLessThan(0.5 * before.value()).isPositive();
        assertThat(layouts.holds(after)).isTrue();
        for (FrontPoint<RoutePlacement> point : front.points()) {
            double most = point.layout().chosen().stream()
                    .mapToDouble(one -> exposures.get(one.name()))
                    .sum();
            assertThat(point.layout().value()).isCloseTo(most, within(1e-6 * most));
            assertThat(layouts.holds(point.layout())).isTrue();
        }
        double best = 0.0;
        for (int choice = 1; choice < 1 << plan.candidates().size(); choice++) {
            List<Integer> chosen = chosen(plan, choice);
            double cost = chosen.stream()
                    .mapToDouble(one -> plan.candidates().get(one).candidate().cost())
                    .sum();
            double sum = chosen.stream()
                    .mapToDouble(one -> exposures.get(plan.candidates().get(one).name()))
                    .sum();
            best = cost <= 4.0 ? Math.max(best, sum) : best;
        }
        assertThat(after.value()).isCloseTo(best, within(1e-6 * best));
    }

    /** Each layout of the front is the best of all for its cost, and there is one as good for each cost. */
    private static void assertFront(PlacePlan plan, double[] exposures) {
        Stage stage = plan.runner().stage(plan.present());
        RouteLayouts layouts =
                new WeakestRouteSearch(plan, stage, LayerStore.NONE, new ExactSolver()).assessed(cells -> {});
        RoutePlacement whole = layouts.found(SolverLimits.NONE, round -> {});
        BudgetFront<RoutePlacement> front =
                new FrontSearch<>(layouts.cheaper(whole)).found(FrontSearch.MOST, SolverLimits.NONE, budget -> {});
        assertThat(front.complete()).isTrue();
        assertThat(front.best().value()).isEqualTo(whole.value());
        assertThat(front.best().withoutEach()).hasSameSizeAs(front.best().chosen());
        for (double budget = 1.0; budget <= plan.settings().budget(); budget++) {
            double most = 0.0;
            for (int choice = 0; choice < exposures.length; choice++) {
                double cost = chosen(plan, choice).stream()
                        .mapToDouble(
                                one -> plan.candidates().get(one).candidate().cost())
                        .sum();
                most = cost <= budget ? Math.max(most, exposures[choice]) : most;
            }
            double limit = budget;
            double best = front.points().stream()
                    .filter(point -> point.cost() <= limit)
                    .mapToDouble(point -> point.layout().value())
                    .max()
                    .orElse(0.0);
            assertThat(best).isCloseTo(most, within(0.01 * most));
            front.points().stream().filter(point -> point.cost() <= limit).forEach(point -> assertThat(
                            point.layout().bound())
                    .isGreaterThanOrEqualTo(point.layout().value()));
        }
    }

    /** Exposures are estimates: a step that raises one by less than the gap is none, and is not bought. */
    @Thorough
    @Test
    void aStepWithinTheGapIsNotBought() throws IOException {
        BudgetFront<RoutePlacement> front = front(plan("budget: 4\n"), SolverLimits.NONE.withGap(0.9));

        assertThat(front.points()).isNotEmpty();
        for (int at = 1; at < front.points().size(); at++) {
            assertThat(front.points().get(at).layout().value())
                    .isGreaterThan(1.9 * front.points().get(at - 1).layout().value());
        }
    }

    private static BudgetFront<RoutePlacement> front(PlacePlan plan, SolverLimits limits) {
        Stage stage = plan.runner().stage(plan.present());
        RouteLayouts layouts =
                new WeakestRouteSearch(plan, stage, LayerStore.NONE, new ExactSolver()).assessed(cells -> {});
        return new FrontSearch<>(layouts.cheaper(layouts.found(SolverLimits.NONE, round -> {})))
                .found(FrontSearch.MOST, limits, budget -> {});
    }

    /** Radars that see only what is faster than the drone. */
    @Test
    void whatGainsNothingIsNotBought() throws IOException {
        plan("budget: 4\n");
        Path file = directory.resolve("ring.place.yaml");
        Files.writeString(file, Files.readString(file).replace("minSpeed: 0.1 m/s", "minSpeed: 100 m/s"));
        BudgetFront<RoutePlacement> front =
                front(PlacePlan.read(file, runner -> {}, note -> {}), SolverLimits.NONE.withGap(0.001));
        RoutePlaceResults results = new RoutePlaceResults(front, Optional.empty(), Optional.empty());

        assertThat(front.points()).hasSize(1);
        assertThat(front.best().chosen()).isEmpty();
        assertThat(front.best().value()).isZero();
        assertThat(results.lines()).anyMatch(line -> line.startsWith("Buying nothing would do as well:"));
    }

    /** Each objective's layout is better on it than that of the other: the best coverage leaves a weaker route. */
    @Test
    void neitherObjectiveIsTheOther() throws IOException {
        assumeTrue(LongForm.IS_ON, "finds two layouts");
        PlacePlan against = plan("budget: 3\n");
        RoutePlacement routes = found(against);
        Path file = directory.resolve("ring.place.yaml");
        Files.writeString(file, Files.readString(file).replace("objective: weakest-route", "objective: coverage"));
        PlacePlan over = PlacePlan.read(file, runner -> {}, note -> {});
        Stage stage = over.runner().stage(over.present());
        SitePlacement coverage = new PlaceSearch(
                        over, new CoveredCells(over, stage, LayerStore.NONE), new ExactSolver())
                .found(SolverLimits.NONE, cells -> {}, () -> {});

        double exposed = routes.result().value();
        double exposedOfOther = exposure(
                against,
                routes,
                against.runner().stage(against.present()),
                coverage.result().chosen());
        double covered = coverage.result().value();
        double coveredOfOther = coverage.problem().value(routes.result().chosen());
        assertThat(exposed).isGreaterThan(1.1 * exposedOfOther);
        assertThat(covered).isGreaterThan(coveredOfOther);
    }

    /** On a packaged scene: each objective's layout is no worse on its own, and better on at least one. */
    @Test
    void atThePalaceEachLayoutIsTheBetterOneOnItsOwnObjective() {
        assumeTrue(LongForm.IS_ON, "assesses 17 candidates twice");
        PlacePlan read = PlacePlan.read(Path.of("scenes", "palace.place.yaml"), runner -> {}, note -> {});
        AirSettings air = SettingsForm.with(
                read.settings().air(), Map.of("side", Optional.of(1200.0), "cell", Optional.of(40.0)));
        PlacePlan over = with(read, air, PlaceObjective.COVERAGE);
        PlacePlan against = with(read, air, PlaceObjective.WEAKEST_ROUTE);
        Stage stage = over.runner().stage(over.present());
        RoutePlacement routes = found(against);
        SitePlacement coverage = new PlaceSearch(
                        over, new CoveredCells(over, stage, LayerStore.NONE), new ExactSolver())
                .found(SolverLimits.NONE, cells -> {}, () -> {});

        double exposed = routes.value();
        double exposedOfOther =
                exposure(against, routes, stage, coverage.result().chosen());
        double covered = coverage.result().value();
        double coveredOfOther = coverage.problem().value(routes.result().chosen());
        assertThat(exposed).isGreaterThanOrEqualTo(Math.min(exposedOfOther, WeakestRouteSearch.ENOUGH));
        assertThat(covered).isGreaterThanOrEqualTo(coveredOfOther);
        assertThat(exposed > 1.01 * exposedOfOther || covered > 1.01 * coveredOfOther)
                .as("exposures %s and %s, covered %s and %s", exposed, exposedOfOther, covered, coveredOfOther)
                .isTrue();
    }

    private static PlacePlan with(PlacePlan read, AirSettings air, PlaceObjective objective) {
        PlaceSettings settings = SettingsForm.with(
                read.settings(),
                Map.of("objective", objective, "budget", 85_000.0, "air", air, "conditions", LayoutConditions.NONE));
        return new PlacePlan(
                settings,
                read.scene(),
                read.runner(),
                read.present(),
                read.drone(),
                read.candidates(),
                read.conditions(),
                read.conditionsFile());
    }

    static List<Integer> chosen(PlacePlan plan, int choice) {
        return IntStream.range(0, plan.candidates().size())
                .filter(one -> (choice >> one & 1) == 1)
                .boxed()
                .toList();
    }

    /** Interrupted in the second round, the search gives the layout of the first. */
    @Test
    void anInterruptedSearchGivesTheBestSoFar() throws IOException {
        PlacePlan plan = plan("budget: 4\n");
        WeakestRouteSearch search =
                new WeakestRouteSearch(plan, plan.runner().stage(plan.present()), LayerStore.NONE, new ExactSolver());
        RoutePlacement placement;
        try {
            placement = search.found(SolverLimits.NONE, cells -> {}, round -> Thread.currentThread()
                    .interrupt());
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }

        assertThat(placement.complete()).isFalse();
        assertThat(placement.rounds()).isEqualTo(1);
        assertThat(placement.chosen()).isNotEmpty();
        assertThat(placement.result().bound())
                .isGreaterThanOrEqualTo(placement.result().value());
        assertThat(placement.weakest().route().seconds()).isPositive();
        assertThat(placement.purchases()).isEmpty();
    }

    @Test
    void withoutAnyLayoutTriedThereIsNone() throws IOException {
        PlacePlan plan = plan("budget: 4\n");
        WeakestRouteSearch search =
                new WeakestRouteSearch(plan, plan.runner().stage(plan.present()), LayerStore.NONE, new ExactSolver());
        SolverLimits stopped = new SolverLimits(0.0, 1.0, () -> true);

        assertThatThrownBy(() -> search.found(stopped, cells -> {}, round -> {}))
                .isInstanceOf(CancellationException.class);
    }
}
