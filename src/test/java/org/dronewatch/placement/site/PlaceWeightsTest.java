package org.dronewatch.placement.site;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.solver.ExactSolver;
import org.dronewatch.run.Stage;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The best layout where some zones count more than others, against all choices. */
class PlaceWeightsTest {
    private static final int FIRST = 20261129;

    @TempDir
    private Path directory;

    /** A rectangle that is a zone of the scene. */
    private record Rectangle(double west, double south, double east, double north, double weight) {
        boolean contains(double x, double y) {
            return x > west && x < east && y > south && y < north;
        }

        static Rectangle random(SplittableRandom random) {
            double west = random.nextDouble(-200.0, 100.0);
            double south = random.nextDouble(-200.0, 100.0);
            double weight = random.nextInt(4) == 0 ? 0.0 : Math.rint(random.nextDouble(0.0, 20.0)) / 2.0;
            return new Rectangle(
                    west, south, west + random.nextDouble(90.0, 200.0), south + random.nextDouble(90.0, 200.0), weight);
        }

        private String setting() {
            return String.format(
                    Locale.ROOT,
                    "{area: [[%s, %s], [%s, %s], [%s, %s], [%s, %s]], height: 100}",
                    west,
                    south,
                    east,
                    south,
                    east,
                    north,
                    west,
                    north);
        }
    }

    private PlacePlan plan(Map<String, Rectangle> zones, String more) throws IOException {
        Path file = PlacedSite.in(directory, more);
        StringBuilder scene = new StringBuilder("alert:\n  zones:\n");
        StringBuilder weights = new StringBuilder();
        zones.forEach((name, zone) -> {
            scene.append("    " + name + ": " + zone.setting() + "\n");
            weights.append(weights.isEmpty() ? "" : ", ").append(name + ": " + zone.weight());
        });
        Files.writeString(directory.resolve("site.yaml"), scene, StandardOpenOption.APPEND);
        Files.writeString(file, Files.readString(file).replace("air: {", "air: {weights: {" + weights + "}, "));
        return PlacePlan.read(file, runner -> {}, note -> {});
    }

    private static SitePlacement found(PlacePlan plan) {
        Stage stage = plan.runner().stage(plan.present());
        return new PlaceSearch(plan, new CoveredCells(plan, stage, LayerStore.NONE), new ExactSolver())
                .found(SolverLimits.NONE, cells -> {}, () -> {});
    }

    @Test
    void isTheBestOfAllChoices() throws IOException {
        for (int seed = FIRST; seed < FIRST + LongForm.count(4, 60); seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            Map<String, Rectangle> zones = new LinkedHashMap<>();
            zones.put("works", Rectangle.random(random));
            zones.put("yard", Rectangle.random(random));
            int fold = 1 + seed % 2;
            double loss = seed % 3 == 0 ? 0.1 : 0.0;
            double budget = 4.0 + random.nextInt(6);
            assertIsBest(zones, budget, fold, loss, "seed " + seed);
        }
    }

    private void assertIsBest(Map<String, Rectangle> zones, double budget, int fold, double loss, String name)
            throws IOException {
        PlacePlan plan = plan(
                zones,
                "budget: " + budget + "\nconditions: {fold: " + fold
                        + (loss > 0.0 ? ", anyoneLost: {atLeast: " + loss + "}}\n" : "}\n"));
        FieldGrid grid = new CoveredCells(plan, plan.runner().stage(plan.present()), LayerStore.NONE).grid();
        AllChoices all = AllChoices.of(plan, grid, zones);
        double best = Double.NaN;
        for (int choice = 0; choice < 1 << plan.candidates().size(); choice++) {
            if (cost(plan, choice) <= budget && (loss == 0.0 || all.worstLoss(choice, fold) >= loss - 1e-9)) {
                best = Double.isNaN(best) ? all.value(choice, fold) : Math.max(best, all.value(choice, fold));
            }
        }
        if (Double.isNaN(best)) {
            assertThatThrownBy(() -> found(plan)).as(name).isInstanceOf(InputException.class);
            return;
        }
        SitePlacement placement = found(plan);
        int chosen =
                placement.result().chosen().stream().mapToInt(one -> 1 << one).sum();

        assertThat(placement.value()).as(name).isCloseTo(best, within(1e-9)).isBetween(0.0, 1.0);
        assertThat(placement.bound()).as(name).isCloseTo(best, within(1e-9));
        assertThat(all.value(chosen, fold)).as(name).isCloseTo(best, within(1e-9));
        assertThat(placement.complete()).as(name).isTrue();
        for (ZoneCoverage zone : placement.byZone()) {
            String where = zone.zone().isEmpty() ? AllChoices.OTHERS : zone.zone();
            assertThat(zone.layout()).as(name + " " + where).isCloseTo(all.covered(where, chosen, fold), within(1e-12));
            assertThat(zone.cells() * placement.headings())
                    .as(name + " " + where)
                    .isEqualTo(all.size(where));
            assertThat(zone.weight())
                    .isEqualTo(
                            zone.zone().isEmpty() ? 1.0 : zones.get(zone.zone()).weight());
        }
    }

    private static double cost(PlacePlan plan, int choice) {
        double cost = 0.0;
        for (int candidate = 0; candidate < plan.candidates().size(); candidate++) {
            cost += (choice >> candidate & 1)
                    * plan.candidates().get(candidate).candidate().cost();
        }
        return cost;
    }

    /**
     * What each choice among the candidates covers, from one field of all of them.
     *
     * @param weights by the set of candidates that cover it: the weight of the cells and headings
     * @param counts by zone and set of candidates: the number of cells and headings
     */
    private record AllChoices(Map<Integer, Double> weights, Map<String, Map<Integer, Integer>> counts) {
        static final String OTHERS = "others";

        static AllChoices of(PlacePlan plan, FieldGrid grid, Map<String, Rectangle> zones) {
            DetectionField field = CandidateField.of(plan, grid);
            AllChoices all = new AllChoices(new HashMap<>(), new HashMap<>());
            int columns = grid.columns();
            for (int at = 0; at < columns * columns * 2 * 8; at++) {
                int column = at % columns;
                int row = at / columns % columns;
                int height = at / (columns * columns) % 2;
                if (field.isOpen(height, column, row)) {
                    int who = 0;
                    for (int sensor = 0; sensor < plan.candidates().size(); sensor++) {
                        who |= field.probability(sensor, height, column, row, at / (columns * columns * 2)) >= 0.5
                                ? 1 << sensor
                                : 0;
                    }
                    all.count(who, grid.x(column), grid.y(row), zones);
                }
            }
            return all;
        }

        private void count(int who, double x, double y, Map<String, Rectangle> zones) {
            double weight = -1.0;
            for (Map.Entry<String, Rectangle> zone : zones.entrySet()) {
                if (zone.getValue().contains(x, y)) {
                    weight = Math.max(weight, zone.getValue().weight());
                    count(zone.getKey(), who);
                }
            }
            if (weight < 0.0) {
                count(OTHERS, who);
            }
            weights.merge(who, weight < 0.0 ? 1.0 : weight, Double::sum);
        }

        private void count(String zone, int who) {
            counts.computeIfAbsent(zone, name -> new HashMap<>()).merge(who, 1, Integer::sum);
        }

        double value(int choice, int fold) {
            double covered = 0.0;
            double sum = 0.0;
            for (Map.Entry<Integer, Double> one : weights.entrySet()) {
                sum += one.getValue();
                covered += Integer.bitCount(one.getKey() & choice) >= fold ? one.getValue() : 0.0;
            }
            return covered / sum;
        }

        double worstLoss(int choice, int fold) {
            double worst = value(choice == 0 ? 0 : choice, fold);
            for (int lost = 0; lost < 14; lost++) {
                worst = (choice >> lost & 1) == 1 ? Math.min(worst, value(choice & ~(1 << lost), fold)) : worst;
            }
            return worst;
        }

        double covered(String zone, int choice, int fold) {
            return counts.get(zone).entrySet().stream()
                            .filter(one -> Integer.bitCount(one.getKey() & choice) >= fold)
                            .mapToInt(Map.Entry::getValue)
                            .sum()
                    / (double) size(zone);
        }

        int size(String zone) {
            return counts.get(zone).values().stream()
                    .mapToInt(Integer::intValue)
                    .sum();
        }
    }
}
