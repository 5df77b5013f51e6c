package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program.Child;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.app.console.InterruptedLine;
import org.dronewatch.app.search.PlaceFinder;
import org.dronewatch.app.search.PlaceTask;
import org.dronewatch.placement.RadarCandidates;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.site.FrontSearch;
import org.dronewatch.report.placement.RoutePlaceResults;
import org.dronewatch.run.store.StorePlace;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A request to end while the routes past the best layout are searched for and flown: the layout, whole. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "there a process can only be killed")
class RoutePlaceInterruptionTest {
    private static final String PLACEMENT = "scene: site.yaml\nobjective: weakest-route\nbudget: 3\n"
            + RadarCandidates.FOUR + RadarCandidates.COARSE_AIR;

    @TempDir
    private Path directory;

    @Thorough
    @ParameterizedTest
    @ValueSource(strings = {"layouts and routes past them: done", "detection field: done"})
    void theLayoutIsWhole(String reached) throws Exception {
        site();
        Outcome outcome;
        try (Child place = Program.start(
                directory,
                List.of("-Xmx1g", "-XX:+UseSerialGC"),
                "place ring.place.yaml --threads 1 --progress --out .".split(" "))) {
            awaitText(place.err(), reached);
            // Not SIGINT, which a build in the background ignores, and with it all that it starts.
            place.process().destroy();
            outcome = place.await();
        }
        JsonNode json = JsonMapper.builder()
                .build()
                .readTree(directory.resolve("place.json").toFile());

        assertThat(outcome.code()).as(outcome.err()).isEqualTo(143);
        assertThat(outcome.err()).doesNotContain("error").doesNotContain("Exception");
        assertThat(json.get("complete").asBoolean()).isFalse();
        assertThat(json.get("chosen")).isNotEmpty();
        assertThat(json.get("cost").asDouble()).isBetween(1.0, 3.0);
        assertThat(json.get("value").asDouble()).isPositive();
        assertThat(json.get("bound").asDouble())
                .isGreaterThanOrEqualTo(json.get("value").asDouble());
        assertThat(json.get("route").get("exposure")).isEqualTo(json.get("value"));
        assertThat(Program.run("check", directory.resolve("layout.yaml").toString())
                        .code())
                .isZero();
        assertThat(directory.resolve("report.html")).content().endsWith("</html>\n");
    }

    /** What an interruption leaves of the routes is flown; those past the scene's own sensors are not begun. */
    @Test
    void nothingElseIsFlown() throws IOException {
        PlacePlan plan = plan();
        try (InterruptedLine task = InterruptedLine.noticedAfter("routes: done")) {
            RoutePlaceResults results = found(plan, task);

            assertThat(results.layout()).isPresent();
            assertThat(results.present()).isEmpty();
            assertThat(results.isInterrupted()).isTrue();
            assertThat(task.linesAfter())
                    .anyMatch(line -> line.startsWith("looks along the routes: done"))
                    .noneMatch(line -> line.startsWith("detection field"));
        }
    }

    private PlacePlan plan() throws IOException {
        return PlacePlan.read(site(), runner -> runner.store(StorePlace.NONE), note -> {});
    }

    /** The placement file, beside the scene. */
    private Path site() throws IOException {
        FieldSite.in(directory, FieldSite.ROUND + "alert: {protect: {centre: [0, 0, 15], radius: 30}}\n");
        return Files.writeString(directory.resolve("ring.place.yaml"), PLACEMENT);
    }

    private static RoutePlaceResults found(PlacePlan plan, InterruptedLine task) {
        SolverLimits limits = new SolverLimits(
                0.001, Double.POSITIVE_INFINITY, () -> task.interruption().happened());
        PlaceTask place = PlaceTask.of(plan, limits, FrontSearch.MOST, task.interruption(), task.shown());
        return (RoutePlaceResults) PlaceFinder.of(plan.settings().objective()).find(place);
    }

    private static void awaitText(Path file, String text) throws IOException, InterruptedException {
        long end = System.nanoTime() + TimeUnit.MINUTES.toNanos(2);
        while (!Files.readString(file).contains(text)) {
            assertThat(System.nanoTime())
                    .as("%s: %s", text, Files.readString(file))
                    .isLessThan(end);
            Thread.sleep(10);
        }
    }
}
