package org.dronewatch.placement.site;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.solver.ExactSolver;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The layout with the longest warning under the worst of several conditions. */
class WarningWeathersTest {
    private static final String CANDIDATES =
            WarningSearchTest.CANDIDATES.replace("40 m]}", "40 m], conditions: weather.yaml}");

    /** In the first, receivers are weak; in the second, there is less time. */
    private static final String CONDITIONS =
            """
            silent: {drones.one.radio.power: POWER}
            fast: {drones.one.speed: 18 m/s}
            """;

    @TempDir
    private Path directory;

    private PlacePlan plan(String more, String conditions) throws IOException {
        FieldSite.in(directory, FieldSite.ROUND + "alert: {protect: {centre: [0, 0, 15], radius: 30}}\n");
        Files.writeString(directory.resolve("weather.yaml"), conditions);
        Path file = Files.writeString(directory.resolve("early.place.yaml"), CANDIDATES + more);
        return PlacePlan.read(file, runner -> {}, note -> {});
    }

    private static WarningPlacement found(PlacePlan plan) {
        Stage stage = plan.runner().stage(plan.present());
        return new WarningSearch(plan, stage, LayerStore.NONE, new ExactSolver())
                .found(SolverLimits.NONE, cells -> {}, () -> {});
    }

    /** The warning of a layout in the scene as it is and under each condition, as {@code coverage} finds it, s. */
    private static List<Double> warnings(
            PlacePlan plan, Map<SceneSettings, Stage> stages, WarningPlacement placement, List<Integer> chosen) {
        Map<String, SensorSettings<?>> sensors = new LinkedHashMap<>();
        chosen.stream().map(plan.candidates()::get).forEach(one -> sensors.put(one.name(), one.sensor()));
        List<Double> warnings = new ArrayList<>();
        stages.forEach((scene, stage) -> {
            var alone = SettingsForm.with(scene, Map.of("sensors", sensors, "disabled", Set.of()));
            var times = InboundWarnings.of(
                            alone, stage, FieldSite.DRONE, placement.grid(), FieldTerms.ONE_LOOK, 0.5, cells -> {})
                    .all()
                    .stream()
                    .mapToDouble(one -> one.time().orElse(0.0));
            warnings.add(
                    plan.settings().warning().name().equals("WORST")
                            ? times.min().orElseThrow()
                            : times.average().orElseThrow());
        });
        return warnings;
    }

    private static Map<SceneSettings, Stage> stages(PlacePlan plan) {
        Map<SceneSettings, Stage> stages = new LinkedHashMap<>();
        stages.put(plan.present(), plan.runner().stage(plan.present()));
        plan.conditions()
                .forEach(one -> stages.put(one.settings(), plan.runner().stage(one.settings())));
        return stages;
    }

    @Thorough
    @ParameterizedTest
    @CsvSource({"mean, -45", "worst, -11"})
    void isTheBestOfAllLayoutsUnderTheWorstCondition(String measure, String power) throws IOException {
        PlacePlan plan = plan("warning: " + measure + "\nbudget: 5\n", CONDITIONS.replace("POWER", power));
        Map<SceneSettings, Stage> stages = stages(plan);
        WarningPlacement placement = found(plan);
        double best = 0.0;
        for (int choice = 1; choice < 1 << plan.candidates().size(); choice++) {
            int all = choice;
            List<Integer> chosen = IntStream.range(0, plan.candidates().size())
                    .filter(one -> (all >> one & 1) == 1)
                    .boxed()
                    .toList();
            double cost = chosen.stream()
                    .mapToDouble(one -> plan.candidates().get(one).candidate().cost())
                    .sum();
            if (cost <= 5.0) {
                double worst = warnings(plan, stages, placement, chosen).stream()
                        .min(Double::compare)
                        .orElseThrow();
                best = Math.max(best, worst);
            }
        }
        List<Double> promised =
                warnings(plan, stages, placement, placement.result().chosen());

        assertThat(placement.value()).isCloseTo(best, within(1e-9)).isPositive();
        assertThat(placement.bound()).isCloseTo(best, within(1e-9));
        assertThat(placement.complete()).isTrue();
        assertThat(placement.flights()).isEqualTo(72);
        assertThat(placement.asItIs()).isCloseTo(promised.get(0), within(1e-9)).isGreaterThan(placement.value());
        assertThat(placement.byCondition()).containsOnlyKeys("silent", "fast");
        assertThat(placement.byCondition().get("silent")).isCloseTo(promised.get(1), within(1e-9));
        assertThat(placement.byCondition().get("fast")).isCloseTo(promised.get(2), within(1e-9));
        assertThat(placement.value())
                .isCloseTo(promised.stream().min(Double::compare).orElseThrow(), within(1e-9));
        assertThat(placement.present().orElseThrow().value()).isLessThanOrEqualTo(best);
    }

    /** A condition may switch off a sensor that is kept: it then gives no warning. */
    @Test
    void aSensorThatIsSwitchedOffGivesNoWarning() throws IOException {
        PlacePlan plan = plan("warning: mean\nbudget: 0\nkeep: [round]\n", "broken: {sensors.round.enabled: false}\n");
        WarningPlacement placement = found(plan);

        assertThat(placement.asItIs()).isPositive();
        assertThat(placement.byCondition().get("broken")).isZero();
        assertThat(placement.value()).isZero();
        assertThat(placement.detected()).isZero();
    }
}
