package org.dronewatch.placement.site;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.placement.solver.ExactSolver;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The best layout for the worst of several conditions. */
class PlaceWeathersTest {
    /** In each of them, another kind of sensor is weak. */
    private static final String CONDITIONS =
            """
            silent: {drones.one.radio.power: -45}
            slow: {drones.one.speed: 2 m/s}
            """;

    @TempDir
    private Path directory;

    private PlacePlan plan(String conditions, String budget) throws IOException {
        Path file = PlacedSite.in(directory, budget);
        Files.writeString(
                directory.resolve("site.yaml"),
                "alert: {protect: {centre: [0, 0, 10], radius: 30 m}}\n",
                StandardOpenOption.APPEND);
        Files.writeString(directory.resolve("weather.yaml"), conditions);
        Files.writeString(
                file,
                Files.readString(file)
                        .replace(
                                "heights: [10 m, 40 m]",
                                "heights: [10 m, 40 m], heading: inbound, conditions: weather.yaml"));
        return PlacePlan.read(file, runner -> {}, note -> {});
    }

    private static SitePlacement found(PlacePlan plan) {
        CoveredCells cells = new CoveredCells(plan, plan.runner().stage(plan.present()), LayerStore.NONE);
        return new PlaceSearch(plan, cells, new ExactSolver()).found(SolverLimits.NONE, some -> {}, () -> {});
    }

    /** The settings of the scene as it is and under each condition, as {@code coverage} reads them. */
    private static List<SceneSettings> scenes(PlacePlan plan) {
        List<SceneSettings> scenes = new ArrayList<>(List.of(plan.present()));
        plan.conditions().forEach(one -> scenes.add(one.settings()));
        return scenes;
    }

    /** What a layout covers under each of them, as {@code coverage} finds it. */
    private static List<Double> coverages(PlacePlan plan, FieldGrid grid, List<SiteCandidate> layout) {
        Map<String, SensorSettings<?>> sensors = new LinkedHashMap<>();
        layout.forEach(one -> sensors.put(one.name(), one.sensor()));
        List<Double> coverages = new ArrayList<>();
        for (SceneSettings scene : scenes(plan)) {
            SceneSettings alone = SettingsForm.with(scene, Map.of("sensors", sensors, "disabled", Set.of()));
            Stage stage = plan.runner().stage(alone);
            List<Course> courses = List.of(Course.inbound(InboundTarget.of(alone, stage.protection(), grid)));
            DetectionField field = FieldAssessment.of(alone, stage, FieldSite.DRONE, grid, courses, some -> {});
            coverages.add(LayoutFields.share(FieldSummary.of(field, FieldCoverage.Choice.WORST, 0.5), 1));
        }
        return coverages;
    }

    /** All choices, each as good as its coverage under the worst condition. */
    @ParameterizedTest
    @CsvSource({"3.5", "5"})
    void isTheBestOfAllChoicesInTheWorstWeather(double budget) throws IOException {
        PlacePlan plan = plan(CONDITIONS, "budget: " + budget + "\n");
        SitePlacement placement = found(plan);
        List<Integer> candidates = new ArrayList<>();
        double best = 0.0;
        int size = plan.candidates().size();
        // By condition and candidate: what it covers, as a set of cells.
        List<List<BitSet>> covered = covered(placement);
        int cells = placement.cells();
        for (int choice = 0; choice < 1 << size; choice++) {
            candidates.clear();
            double cost = 0.0;
            for (int number = 0; number < size; number++) {
                if ((choice >> number & 1) == 1) {
                    candidates.add(number);
                    cost += plan.candidates().get(number).candidate().cost();
                }
            }
            if (cost <= budget) {
                double worst = 1.0;
                for (List<BitSet> condition : covered) {
                    BitSet all = new BitSet();
                    candidates.forEach(number -> all.or(condition.get(number)));
                    worst = Math.min(worst, (double) all.cardinality() / cells);
                }
                best = Math.max(best, worst);
            }
        }

        assertThat(placement.value()).isCloseTo(best, within(1e-12)).isBetween(0.05, 0.99);
        assertThat(placement.bound()).isEqualTo(placement.value());
        assertThat(placement.complete()).isTrue();
    }

    private static List<List<BitSet>> covered(SitePlacement placement) {
        PlacePlan plan = placement.plan();
        List<List<BitSet>> covered = new ArrayList<>();
        for (SceneSettings scene : scenes(plan)) {
            Map<String, SensorSettings<?>> sensors = new LinkedHashMap<>();
            plan.candidates().forEach(one -> sensors.put(one.name(), one.sensor()));
            SceneSettings all = SettingsForm.with(scene, Map.of("sensors", sensors, "disabled", Set.of()));
            Stage stage = plan.runner().stage(all);
            FieldGrid grid = placement.grid();
            List<Course> courses = List.of(Course.inbound(InboundTarget.of(all, stage.protection(), grid)));
            DetectionField field = FieldAssessment.of(all, stage, FieldSite.DRONE, grid, courses, some -> {});
            List<BitSet> ofSensors = new ArrayList<>();
            for (int sensor = 0; sensor < sensors.size(); sensor++) {
                BitSet cells = new BitSet();
                for (int cell = 0; cell < 2 * grid.cells(); cell++) {
                    int row = cell / grid.columns() % grid.columns();
                    boolean covers = field.covers(sensor, cell / grid.cells(), cell % grid.columns(), row, 0, 0.5);
                    cells.set(cell, covers);
                }
                ofSensors.add(cells);
            }
            covered.add(ofSensors);
        }
        return covered;
    }

    /** The layout promises no more in the worst weather than {@code coverage} finds under that condition. */
    @Test
    void coverageUnderEachConditionKeepsWhatIsPromised() throws IOException {
        PlacePlan plan = plan(CONDITIONS, "budget: 5\n");
        SitePlacement placement = found(plan);
        List<Double> coverages = coverages(plan, placement.grid(), placement.chosen());

        assertThat(placement.asItIs()).isCloseTo(coverages.get(0), within(1e-12));
        assertThat(placement.byCondition()).hasSize(2);
        assertThat(placement.byCondition().get("silent")).isCloseTo(coverages.get(1), within(1e-12));
        assertThat(placement.byCondition().get("slow")).isCloseTo(coverages.get(2), within(1e-12));
        assertThat(placement.value())
                .isCloseTo(coverages.stream().min(Double::compare).orElseThrow(), within(1e-12));
        // The best layout for the scene as it is does worse in the worst weather.
        PlacePlan fair = new PlacePlan(
                plan.settings(),
                plan.scene(),
                plan.runner(),
                plan.present(),
                plan.drone(),
                plan.candidates(),
                List.of(),
                plan.conditionsFile());
        SitePlacement careless = found(fair);
        assertThat(careless.value()).isGreaterThanOrEqualTo(placement.asItIs());
        assertThat(coverages(plan, placement.grid(), careless.chosen()).stream()
                        .min(Double::compare)
                        .orElseThrow())
                .isLessThan(placement.value());
    }

    @Test
    void aFileElsewhereOrAConditionThatDoesNotFitIsRefused() throws IOException {
        assertThatThrownBy(() -> plan("fog: {world.fog: 3}\n", "budget: 5\n"))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("weather.yaml:1:")
                .hasMessageContaining("world.fog");
        Path file = directory.resolve("radars.place.yaml");
        Files.writeString(file, Files.readString(file).replace("weather.yaml", "../weather.yaml"));
        assertThatThrownBy(() -> PlacePlan.read(file, runner -> {}, note -> {}))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("air.conditions ../weather.yaml: must be in the directory of the placement file");
    }
}
