package org.dronewatch.placement.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.TriedBudgets;
import org.dronewatch.report.placement.RoutePlaceResults;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;

/** The layout against the weakest route under the worst of several conditions. */
class WeakestRouteWeathersTest {
    /** The exposures to several sensors may be added along a route or route by route. */
    private static final double ROUNDING = 1e-12;

    /** In the first, there is less time for detections; in the second, only sensors nearby detect the slow drone. */
    private static final String CONDITIONS =
            """
            fast: {drones.one.speed: 18 m/s}
            small: {drones.one.radar.crossSection: 0.002, drones.one.speed: 1 m/s}
            """;

    @TempDir
    private Path directory;

    private PlacePlan plan(String more, String scene, String conditions) throws IOException {
        FieldSite.in(directory, scene + "alert: {protect: {centre: [0, 0, 15], radius: 30}}\n");
        Files.writeString(directory.resolve("weather.yaml"), conditions);
        String candidates = conditions.isEmpty()
                ? WeakestRouteSearchTest.CANDIDATES
                : WeakestRouteSearchTest.CANDIDATES.replace("30 m]}", "30 m], conditions: weather.yaml}");
        Path file = Files.writeString(directory.resolve("ring.place.yaml"), candidates + more);
        return PlacePlan.read(file, runner -> {}, note -> {});
    }

    private static Map<SceneSettings, Stage> stages(PlacePlan plan) {
        Map<SceneSettings, Stage> stages = new LinkedHashMap<>();
        stages.put(plan.present(), plan.runner().stage(plan.present()));
        plan.conditions()
                .forEach(one -> stages.put(one.settings(), plan.runner().stage(one.settings())));
        return stages;
    }

    private static List<Double> exposures(
            PlacePlan plan, Map<SceneSettings, Stage> stages, RoutePlacement placement, List<Integer> chosen) {
        return stages.entrySet().stream()
                .map(scene -> WeakestRouteSearchTest.exposure(
                        plan, scene.getKey(), scene.getValue(), placement.grid(), chosen))
                .toList();
    }

    @Thorough
    @Test
    void isTheBestOfAllLayoutsUnderTheWorstCondition() throws IOException {
        PlacePlan plan = plan("budget: 2\n", FieldSite.ROUND, CONDITIONS);
        Map<SceneSettings, Stage> stages = stages(plan);
        RoutePlacement placement = WeakestRouteSearchTest.found(plan);
        double best = 0.0;
        double bestAsItIs = 0.0;
        for (int choice = 1; choice < 1 << plan.candidates().size(); choice++) {
            List<Integer> chosen = WeakestRouteSearchTest.chosen(plan, choice);
            double cost = chosen.stream()
                    .mapToDouble(one -> plan.candidates().get(one).candidate().cost())
                    .sum();
            if (cost <= 2.0) {
                List<Double> all = exposures(plan, stages, placement, chosen);
                best = Math.max(best, all.stream().min(Double::compare).orElseThrow());
                bestAsItIs = Math.max(bestAsItIs, all.get(0));
            }
        }
        List<Double> promised =
                exposures(plan, stages, placement, placement.result().chosen());

        assertThat(placement.complete()).isTrue();
        assertThat(placement.value()).isCloseTo(best, within(0.01 * best)).isPositive();
        assertThat(placement.bound()).isBetween(placement.value(), 1.01 * best);
        assertThat(placement.asItIs())
                .isCloseTo(promised.get(0), within(1e-3 * promised.get(0)))
                .isLessThan(0.9 * bestAsItIs);
        assertThat(placement.byCondition()).containsOnlyKeys("fast", "small");
        assertThat(placement.byCondition().get("fast")).isCloseTo(promised.get(1), within(1e-3 * promised.get(1)));
        assertThat(placement.byCondition().get("small")).isCloseTo(promised.get(2), within(1e-3 * promised.get(2)));
        assertThat(placement.value())
                .isCloseTo(
                        placement.byCondition().values().stream().reduce(placement.asItIs(), Math::min),
                        within(ROUNDING));
        assertThat(placement.weakest().condition()).contains("fast");
        assertStated(placement);
    }

    /** The printed lines and place.json state the value under each condition. */
    private static void assertStated(RoutePlacement placement) {
        FrontPoint<RoutePlacement> point = new FrontPoint<>(2.0, placement, List.of(), List.of(), Optional.empty());
        TriedBudgets tried = new TriedBudgets(1, List.of(), true);
        RoutePlaceResults results = new RoutePlaceResults(
                new BudgetFront<>(List.of(point), tried, true), Optional.empty(), Optional.empty());
        JsonNode json = results.toJson();

        assertThat(results.lines())
                .anyMatch(line ->
                        line.startsWith("On the weakest route past the layout, under the condition 'fast', the"))
                .anyMatch(line -> line.contains("), as estimated by the search; the route begins at "))
                .anyMatch(line -> line.startsWith("In the scene as it is, the layout detects the drone with a"));
        assertThat(json.get("as_it_is").asDouble()).isCloseTo(placement.asItIs(), within(1e-6));
        assertThat(json.get("conditions").get(0).get("name").asString()).isEqualTo("fast");
        assertThat(json.get("conditions").get(0).get("value")).isEqualTo(json.get("value"));
        assertThat(json.get("route").get("condition").asString()).isEqualTo("fast");
    }

    /** A condition that changes nothing does not change what is found, either. */
    @Thorough
    @Test
    void aSingleConditionWithoutEffectChangesNothing() throws IOException {
        RoutePlacement same = WeakestRouteSearchTest.found(
                plan("budget: 3\n", FieldSite.ROUND, "same: {drones.one.speed: 12 m/s}\n"));
        RoutePlacement alone = WeakestRouteSearchTest.found(plan("budget: 3\n", FieldSite.ROUND, ""));

        assertThat(same.result()).isEqualTo(alone.result());
        assertThat(same.lower()).isEqualTo(alone.lower());
        assertThat(same.parts()).isEqualTo(alone.parts());
        assertThat(same.routes()).isEqualTo(alone.routes());
        assertThat(same.byCondition()).containsOnlyKeys("same");
        assertThat(same.byCondition().get("same")).isCloseTo(alone.value(), within(ROUNDING));
        assertThat(alone.byCondition()).isEmpty();
    }

    /** A condition may switch off a sensor that is kept: it then detects nothing. */
    @Test
    void aSensorThatIsSwitchedOffDetectsNothing() throws IOException {
        String radar = FieldSite.ROUND.replace("minSpeed: 3 m/s", "minSpeed: 0.1 m/s");
        RoutePlacement placement = WeakestRouteSearchTest.found(
                plan("budget: 0\nkeep: [round]\n", radar, "broken: {sensors.round.enabled: false}\n"));

        assertThat(placement.asItIs()).isPositive();
        assertThat(placement.byCondition().get("broken")).isZero();
        assertThat(placement.value()).isZero();
        assertThat(placement.weakest().condition()).contains("broken");
        assertThat(placement.present().orElseThrow().value()).isZero();
    }
}
