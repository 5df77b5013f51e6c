package org.dronewatch.placement.site;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.placement.solver.ExactSolver;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The best layout of a plain with four boxes against all choices among its candidates. */
class PlaceSearchTest {
    @TempDir
    private Path directory;

    /** By the set of candidates that cover it: the number of cells and headings. */
    private final Map<Integer, Integer> covered = new HashMap<>();

    private int all;

    private PlacePlan plan(String more) throws IOException {
        return PlacePlan.read(PlacedSite.in(directory, more), runner -> {}, note -> {});
    }

    private static SitePlacement found(PlacePlan plan) {
        Stage stage = plan.runner().stage(plan.present());
        return new PlaceSearch(plan, new CoveredCells(plan, stage, LayerStore.NONE), new ExactSolver())
                .found(SolverLimits.NONE, cells -> {}, () -> {});
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "5 | 14 | 1 | 0",
                "8 | 14 | 2 | 0",
                "7 |  3 | 1 | 0",
                "9 | 14 | 1 | 0.3",
            })
    void isTheBestOfAllChoices(double budget, int atMost, int fold, double remaining) throws IOException {
        PlacePlan plan = plan("budget: " + budget + "\nconditions: {atMost: " + atMost + ", fold: " + fold
                + (remaining > 0.0 ? ", anyoneLost: {atLeast: " + remaining + "}}\n" : "}\n"));
        SitePlacement placement = found(plan);
        countAll(plan, placement);
        double best = 0.0;
        for (int choice = 0; choice < 1 << plan.candidates().size(); choice++) {
            boolean complies = Integer.bitCount(choice) <= atMost
                    && cost(plan, choice) <= budget
                    && (remaining == 0.0 || worstLoss(choice, fold) >= remaining);
            best = complies ? Math.max(best, value(choice, fold)) : best;
        }

        assertThat(placement.value()).isCloseTo(best, within(1e-12));
        assertThat(placement.bound()).isEqualTo(placement.value());
        assertThat(placement.complete()).isTrue();
        assertThat(placement.value()).isBetween(0.05, 0.99);
        assertThat(placement.withoutEach().values().stream().min(Double::compare))
                .hasValueSatisfying(least -> assertThat(least).isGreaterThanOrEqualTo(remaining));
    }

    /** The best of all choices for each sum of prices: those that a cheaper one equals are left out. */
    @ParameterizedTest
    @CsvSource({"6, 12", "4, 12", "9, 3"})
    void theFrontHasTheBestOfAllChoicesForEachBudget(double budget, int budgets) throws IOException {
        PlacePlan plan = plan("budget: " + budget + "\n");
        CoveredCells cells = new CoveredCells(plan, plan.runner().stage(plan.present()), LayerStore.NONE);
        SitePlacement whole =
                new PlaceSearch(plan, cells, new ExactSolver()).found(SolverLimits.NONE, some -> {}, () -> {});
        BudgetFront<SitePlacement> front = new FrontSearch<>(new CheaperCoverage(whole, cells, new ExactSolver()))
                .found(budgets, SolverLimits.NONE, some -> {});
        countAll(plan, whole);
        double cost = whole.result().cost();
        List<Double> asked = BudgetSteps.spread(
                BudgetSteps.sums(cost, whole.problem().table().candidates()), cost, budgets - 1);
        List<Double> bests = new ArrayList<>();
        for (double limit : asked) {
            double best = bestOfAll(plan, limit);
            if (best > 0.0 && (bests.isEmpty() || best > bests.get(bests.size() - 1) + 1e-12)) {
                bests.add(best);
            }
        }
        bests.add(whole.value());

        assertThat(front.complete()).isTrue();
        assertThat(front.best().value()).isEqualTo(whole.value());
        assertThat(front.points()).hasSameSizeAs(bests).hasSizeGreaterThan(2);
        for (int at = 0; at < bests.size(); at++) {
            FrontPoint<SitePlacement> point = front.points().get(at);
            assertThat(point.layout().value()).isCloseTo(bests.get(at), within(1e-12));
            assertThat(point.layout().bound()).isEqualTo(point.layout().value());
            assertThat(point.cost()).isLessThanOrEqualTo(point.budget());
            assertGain(
                    point,
                    at == 0 ? List.of() : front.points().get(at - 1).layout().chosen(),
                    cells);
        }
    }

    private double bestOfAll(PlacePlan plan, double limit) {
        double best = 0.0;
        for (int choice = 0; choice < 1 << plan.candidates().size(); choice++) {
            best = cost(plan, choice) <= limit + 1e-9 ? Math.max(best, value(choice, 1)) : best;
        }
        return best;
    }

    /** What a step adds and removes turns the previous layout into this one; the part that gains is counted anew. */
    private static void assertGain(FrontPoint<SitePlacement> point, List<SiteCandidate> before, CoveredCells cells) {
        List<String> names =
                new ArrayList<>(before.stream().map(SiteCandidate::name).toList());
        names.removeAll(point.removed());
        names.addAll(point.added());
        assertThat(names)
                .containsExactlyInAnyOrderElementsOf(point.layout().chosen().stream()
                        .map(SiteCandidate::name)
                        .toList());
        SectorGain gain = point.gain().orElseThrow();
        assertThat(share(gain, point.layout().chosen(), point.layout(), cells)).isCloseTo(gain.after(), within(1e-12));
        assertThat(share(gain, before, point.layout(), cells)).isCloseTo(gain.before(), within(1e-12));
        assertThat(gain.after()).isGreaterThan(gain.before());
    }

    /** The fraction of the rows in an eighth of the compass at some heights that a layout covers. */
    private static double share(
            SectorGain gain, List<SiteCandidate> layout, SitePlacement placement, CoveredCells cells) {
        Set<Integer> covered = new HashSet<>();
        for (SiteCandidate one : layout) {
            var column = placement
                    .problem()
                    .table()
                    .column(placement.plan().candidates().indexOf(one));
            for (int at = 0; at < column.size(); at++) {
                covered.add(column.row(at));
            }
        }
        FieldGrid grid = cells.grid();
        int[] rows = cells.cells();
        int all = 0;
        int in = 0;
        for (int row = 0; row < rows.length; row++) {
            double height = grid.heights().get(rows[row] / grid.cells());
            double x = grid.x(rows[row] % grid.columns()) - grid.east();
            double y = grid.y(rows[row] / grid.columns() % grid.columns()) - grid.north();
            double off = Math.IEEEremainder(Math.atan2(x, y) - gain.bearing(), 2.0 * Math.PI);
            if (off >= -Math.PI / 8.0 && off < Math.PI / 8.0 && height >= gain.lowest() && height <= gain.highest()) {
                all++;
                in += covered.contains(row) ? 1 : 0;
            }
        }
        return (double) in / all;
    }

    /** All candidates are sensors of one scene, whose field says which of them cover each cell on each heading. */
    private void countAll(PlacePlan plan, SitePlacement placement) {
        DetectionField field = CandidateField.of(plan, placement.grid());
        int columns = placement.grid().columns();
        for (int at = 0; at < columns * columns * 2 * 8; at++) {
            int column = at % columns;
            int row = at / columns % columns;
            int height = at / (columns * columns) % 2;
            int course = at / (columns * columns * 2);
            if (field.isOpen(height, column, row)) {
                int who = 0;
                for (int sensor = 0; sensor < plan.candidates().size(); sensor++) {
                    who |= field.probability(sensor, height, column, row, course) >= 0.5 ? 1 << sensor : 0;
                }
                covered.merge(who, 1, Integer::sum);
                all++;
            }
        }
        assertThat(placement.cells() * 8).isEqualTo(all);
    }

    private double value(int choice, int fold) {
        return covered.entrySet().stream()
                        .filter(one -> Integer.bitCount(one.getKey() & choice) >= fold)
                        .mapToInt(Map.Entry::getValue)
                        .sum()
                / (double) all;
    }

    private double worstLoss(int choice, int fold) {
        double worst = choice == 0 ? 0.0 : 1.0;
        for (int lost = 0; lost < 14; lost++) {
            worst = (choice >> lost & 1) == 1 ? Math.min(worst, value(choice & ~(1 << lost), fold)) : worst;
        }
        return worst;
    }

    private static double cost(PlacePlan plan, int choice) {
        double cost = 0.0;
        for (int candidate = 0; candidate < plan.candidates().size(); candidate++) {
            cost += (choice >> candidate & 1)
                    * plan.candidates().get(candidate).candidate().cost();
        }
        return cost;
    }

    @Test
    void candidatesStandOnTheHighestSurfaceAndFaceAllDirections() throws IOException {
        Map<String, SiteCandidate> byName = plan("budget: 5\n").candidates().stream()
                .collect(Collectors.toMap(SiteCandidate::name, one -> one, (one, other) -> one, LinkedHashMap::new));

        assertThat(byName.keySet())
                .containsExactly(
                        "radar-1",
                        "radar-2",
                        "radar-3",
                        "radio-1",
                        "radio-2",
                        "radio-3",
                        "radio-4",
                        "radio-5",
                        "radio-6",
                        "radio-7",
                        "eye-1-0",
                        "eye-1-90",
                        "eye-1-180",
                        "eye-1-270");
        // The box "terrain" is 15 m high.
        assertPosition(byName.get("radar-3"), -85, -10, 17);
        assertPosition(byName.get("radio-1"), -135, 0, 3);
        assertPosition(byName.get("radio-2"), -85, 0, 18);
        assertPosition(byName.get("radio-7"), 165, 0, 3);
        Position east = byName.get("eye-1-90")
                .sensor()
                .as(Aimed.class)
                .orElseThrow()
                .aim()
                .from(new Position(0, 0, 0));
        assertThat(east.x()).isCloseTo(1.0, within(1e-12));
        assertThat(east.y()).isCloseTo(0.0, within(1e-12));
    }

    /** In the scene of a layout, angles have the digits of the file. */
    @Test
    void turnedAimsAreWholeDegrees() throws IOException {
        Path file = PlacedSite.in(directory, "budget: 9\n");
        Files.writeString(
                file,
                Files.readString(file)
                        .replace("fov: 40 deg,", "aim: {azimuth: 30 deg, elevation: 12 deg}, fov: 40 deg,"));
        List<String> written = PlacePlan.read(file, runner -> {}, note -> {}).candidates().stream()
                .filter(one -> one.name().startsWith("eye"))
                .map(one -> (Aim.Direction)
                        one.sensor().as(Aimed.class).orElseThrow().aim())
                .map(aim -> Quantity.ANGLE.exactly(aim.azimuth()) + ", " + Quantity.ANGLE.exactly(aim.elevation()))
                .toList();

        assertThat(written).containsExactly("30 deg, 12 deg", "120 deg, 12 deg", "-150 deg, 12 deg", "-60 deg, 12 deg");
    }

    /** The camera in each of four directions, and on a positioner that the radars of the layout cue. */
    @Test
    void aSensorMayBeFixedOrOnAPositioner() throws IOException {
        Path file = PlacedSite.in(directory, "budget: 9\n");
        Files.writeString(
                file,
                Files.readString(file)
                        .replace(
                                "    aims: 4\n",
                                "    aims: 4\n    positioners:\n      slow: {positioner: {panSpeed: 5 deg/s}, price: 1}\n"
                                        + "      quick: {positioner: {use: viper}, price: 2.5}\n"));
        PlacePlan plan = PlacePlan.read(file, runner -> {}, note -> {});
        Map<String, SiteCandidate> byName = new LinkedHashMap<>();
        plan.candidates().forEach(one -> byName.put(one.name(), one));

        assertThat(byName.keySet()).hasSize(16).contains("eye-1-0", "eye-1-270", "eye-1-slow", "eye-1-quick");
        assertThat(byName.get("eye-1-quick").candidate().cost()).isEqualTo(3.5);
        assertThat(byName.get("eye-1-quick").candidate().kind()).isEqualTo("eye");
        SitePlacement placement = found(plan);
        double turning = placement.alone(byName.get("eye-1-quick")).orElseThrow();
        double ahead = placement.alone(byName.get("eye-1-0")).orElseThrow();
        assertThat(turning).isGreaterThan(2.0 * ahead);
        SceneSettings layout =
                Layout.of(plan, List.of(byName.get("radar-2"), byName.get("radio-1"), byName.get("eye-1-slow")));
        assertThat(Mounted.positioner(layout.sensors().get("eye-1-slow")).orElseThrow())
                .satisfies(its -> assertThat(its.cues()).containsExactly("radar-2"))
                .satisfies(its -> assertThat(its.panSpeed()).isCloseTo(Math.toRadians(5.0), within(1e-12)));
    }

    @Test
    void aSecondPositionerIsRefused() throws IOException {
        Path file = PlacedSite.in(directory, "budget: 9\n");
        Files.writeString(
                file,
                Files.readString(file)
                        .replace("height: 600}", "height: 600, positioner: {use: viper}}")
                        .replace("    aims: 4\n", "    positioners: {slow: {positioner: {}, price: 1}}\n"));

        assertThatThrownBy(() -> PlacePlan.read(file, runner -> {}, note -> {}))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("candidates.eye.positioners: the sensor already has a positioner");
    }

    /** The sensor that is kept stands where the first radar would. */
    @Test
    void anExclusivePlaceIsTakenByASensorThatIsKept() throws IOException {
        Path file = PlacedSite.in(directory, "budget: 2\nkeep: [round]\n");
        String text = Files.readString(file);
        List<Boolean> isAllowed = new ArrayList<>();
        for (String exclusive : List.of("false", "true")) {
            Files.writeString(file, text.replace("price: 2\n", "price: 2\n    exclusive: " + exclusive + "\n"));
            PlacePlan plan = PlacePlan.read(file, runner -> {}, note -> {});
            assertThat(plan.candidates().subList(0, 2).stream().map(SiteCandidate::name))
                    .containsExactly("round", "radar-1");
            isAllowed.add(found(plan).problem().isAllowed(List.of(0, 1)));
        }

        assertThat(isAllowed).containsExactly(true, false);
    }

    /** Behind the building, which is 30 m high, a base station on a mast has no link to the middle of the site. */
    @Test
    void placesWithoutALineOfSightToTheBaseAreLeftOut() throws IOException {
        List<String> names = plan("budget: 5\nconditions: {base: [0, 100, 40]}\n").candidates().stream()
                .map(SiteCandidate::name)
                .toList();

        assertThat(names).contains("radar-2", "radio-1", "radio-7", "eye-1-0").doesNotContain("radar-1", "radio-4");
    }

    private static void assertPosition(SiteCandidate candidate, double x, double y, double z) {
        Position position = candidate.sensor().position();
        assertThat(position.x()).isCloseTo(x, within(1e-9));
        assertThat(position.y()).isCloseTo(y, within(1e-9));
        assertThat(position.z()).isCloseTo(z, within(1e-4));
    }

    /** Interrupted after two thirds of the cells, the search chooses among the candidates that were assessed. */
    @ParameterizedTest
    @ValueSource(strings = {"{}", "{fold: 2}", "{anyoneLost: {atLeast: 0.1}}"})
    void anInterruptedSearchGivesTheBestSoFar(String conditions) throws IOException {
        PlacePlan plan = plan("budget: 9\nconditions: " + conditions + "\n");
        CoveredCells cells = new CoveredCells(plan, plan.runner().stage(plan.present()), LayerStore.NONE);
        AtomicInteger left = new AtomicInteger((int) cells.looks() / 3 * 2);
        SitePlacement placement = new PlaceSearch(plan, cells, new ExactSolver())
                .found(
                        SolverLimits.NONE,
                        some -> {
                            if (left.addAndGet(-some) < 0) {
                                Thread.currentThread().interrupt();
                            }
                        },
                        Thread::interrupted);

        assertThat(placement.complete()).isFalse();
        assertThat(placement.value()).isPositive();
        assertThat(placement.bound()).isEqualTo(1.0);
        assertThat(placement.chosen()).isNotEmpty();
        assertThat(placement.problem().isAllowed(placement.result().chosen())).isTrue();
    }

    /** No layout of those assessed complies, but that of others might: the conditions are not to blame. */
    @Test
    void anInterruptedSearchWithoutALayoutDoesNotBlameTheConditions() throws IOException {
        PlacePlan plan = plan("budget: 9\nconditions: {anyoneLost: {atLeast: 0.3}}\n");
        CoveredCells cells = new CoveredCells(plan, plan.runner().stage(plan.present()), LayerStore.NONE);
        AtomicInteger left = new AtomicInteger((int) cells.looks() / 5);

        assertThatThrownBy(() -> new PlaceSearch(plan, cells, new ExactSolver())
                        .found(
                                SolverLimits.NONE,
                                some -> {
                                    if (left.addAndGet(-some) < 0) {
                                        Thread.currentThread().interrupt();
                                    }
                                },
                                Thread::interrupted))
                .isInstanceOf(CancellationException.class);
    }

    @Test
    void withoutAnyAssessedCandidateThereIsNoLayout() throws IOException {
        PlacePlan plan = plan("budget: 9\n");
        CoveredCells cells = new CoveredCells(plan, plan.runner().stage(plan.present()), LayerStore.NONE);
        Thread.currentThread().interrupt();
        try {
            assertThatThrownBy(() -> new PlaceSearch(plan, cells, new ExactSolver())
                            .found(SolverLimits.NONE, some -> {}, () -> {}))
                    .isInstanceOf(CancellationException.class);
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
    }
}
