package org.dronewatch.app.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.app.Program;
import org.dronewatch.app.console.InterruptedTask;
import org.dronewatch.placement.RadarCandidates;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.TimeOver;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.route.WeakestRouteSearch;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.FrontSearch;
import org.dronewatch.placement.site.LeftOut;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.placement.site.PlacedSite;
import org.dronewatch.placement.solver.ExactSolver;
import org.dronewatch.report.placement.PlaceDirectory;
import org.dronewatch.report.placement.PlaceResults;
import org.dronewatch.report.provenance.Provenance;
import org.dronewatch.run.store.StorePlace;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/**
 * Interrupted at any moment, each objective gives the best so far, whole, and says that it is not complete if, and only
 * if, something is left out.
 */
class PlaceMomentsTest {
    private static final String COMPLETE = "complete";
    private static final String STOPPED = "stopped";

    /** How many moments are tried besides the first and the last ones. */
    private static final int MOMENTS = LongForm.count(4, 1000);

    private static final int FIRST_AND_LAST = LongForm.count(2, 5);

    /** Files are written at one of so many moments. */
    private static final int WRITTEN = LongForm.count(4, 1);

    private static final String ROUTE_CANDIDATES = "scene: site.yaml\nobjective: weakest-route\nbudget: 4\n"
            + RadarCandidates.FOUR + RadarCandidates.COARSE_AIR;

    @TempDir
    private Path directory;

    /** What a task has found by the moment of its interruption; empty if that is nothing. */
    private record Found(Optional<PlaceResults> results, int moments) {}

    private static Found found(PlacePlan plan, int when) {
        try (InterruptedTask task = new InterruptedTask(when)) {
            SolverLimits limits = new SolverLimits(0.001, Double.POSITIVE_INFINITY, () -> {
                task.moment();
                return task.interruption().happened();
            });
            return found(plan, task, limits);
        }
    }

    private static Found found(PlacePlan plan, InterruptedTask task, SolverLimits limits) {
        PlaceTask place = PlaceTask.of(plan, limits, FrontSearch.MOST, task.interruption(), task.shown());
        Optional<PlaceResults> results;
        try {
            results = Optional.of(PlaceFinder.of(plan.settings().objective()).find(place));
        } catch (CancellationException e) {
            results = Optional.empty();
        }
        return new Found(results, task.moments());
    }

    /** The time of the search is over at once, and that of all else at a moment, 0 for never. */
    private static Found foundInTime(PlacePlan plan, int when) {
        try (InterruptedTask task = InterruptedTask.outOfTime(when)) {
            return found(plan, task, TimeOver.limits(0.001, () -> {
                task.moment();
                return false;
            }));
        }
    }

    private static String coarser(String lines, String air, String inTheBuild) {
        assertThat(lines).contains(air);
        return LongForm.IS_ON ? lines : lines.replace(air, inTheBuild);
    }

    private PlacePlan protectedPlan(String lines) throws IOException {
        Path file = PlacedSite.in(directory, lines);
        String text = Files.readString(file);
        // No warning is worse than another one in larger cells: these are at fewer heights instead.
        Files.writeString(
                file,
                lines.contains("coverage")
                        ? coarser(text, "cell: 80 m", "cell: 100 m")
                        : coarser(text, "heights: [10 m, 40 m]", "heights: [40 m]"));
        Path scene = directory.resolve("site.yaml");
        Files.writeString(scene, Files.readString(scene) + "alert: {protect: {centre: [0, 0, 15], radius: 30}}\n");
        return plan(file);
    }

    private PlacePlan plan(Path file) {
        return PlacePlan.read(file, runner -> runner.store(StorePlace.NONE), note -> {});
    }

    @Thorough
    @ParameterizedTest
    @ValueSource(
            strings = {
                "objective: coverage\nbudget: 6\n",
                "objective: coverage\nbudget: 9\nconditions: {anyoneLost: {atLeast: 0.3}}\n",
                "objective: coverage\nbudget: 9\nconditions: {fold: 2}\n",
                "objective: warning-time\nwarning: mean\nbudget: 6\n",
                "objective: warning-time\nwarning: worst\nbudget: 9\nconditions: {fold: 2}\n",
            })
    void theBestSoFarIsWhole(String lines) throws IOException {
        assertWholeAtAllMoments(protectedPlan(lines), 1);
    }

    @Thorough
    @ParameterizedTest
    @ValueSource(
            strings = {
                "objective: coverage\nbudget: 6\n",
                "objective: warning-time\nwarning: mean\nbudget: 6\n",
            })
    void whatIsNotCompleteInTimeIsNamed(String lines) throws IOException {
        assertNamedAtAllMoments(protectedPlan(lines));
    }

    @Thorough
    @Test
    void whatIsNotCompleteInTimeIsNamedOfRoutes() throws IOException {
        FieldSite.in(directory, FieldSite.ROUND + "alert: {protect: {centre: [0, 0, 15], radius: 30}}\n");
        assertNamedAtAllMoments(plan(Files.writeString(directory.resolve("ring.place.yaml"), ROUTE_CANDIDATES)));
    }

    private void assertNamedAtAllMoments(PlacePlan plan) throws IOException {
        Found all = foundInTime(plan, 0);
        PlaceResults whole = all.results().orElseThrow();
        assertThat(whole.front().stopped().orElseThrow().leftOut()).isEmpty();
        int incomplete = 0;
        for (int when : moments(all.moments())) {
            Optional<PlaceResults> found = foundInTime(plan, when).results();
            if (found.isPresent()) {
                PlaceResults results = found.get();
                List<LeftOut> leftOut = results.front().stopped().orElseThrow().leftOut();
                String moment = "moment " + when + " of " + all.moments() + ": " + leftOut;
                assertThat(results.isInterrupted()).as(moment).isFalse();
                assertThat(results.complete()).as(moment).isFalse();
                assertThat(results.toJson().get(STOPPED).get("left_out").size())
                        .as(moment)
                        .isEqualTo(leftOut.size());
                assertThat(leftOut.isEmpty()).as(moment).isEqualTo(isSame(results, whole));
                assertThat(String.join("\n", results.lines()).contains("10 s after the time limit of "))
                        .as(moment)
                        .isEqualTo(!leftOut.isEmpty());
                incomplete += leftOut.isEmpty() ? 0 : 1;
            }
        }
        assertThat(incomplete).isPositive();
    }

    /** Before the first layout has been tested against the weakest routes past it, there is none. */
    @Thorough
    @Test
    void theBestSoFarAgainstRoutesIsWhole() throws IOException {
        FieldSite.in(directory, FieldSite.ROUND + "alert: {protect: {centre: [0, 0, 15], radius: 30}}\n");
        Path file = Files.writeString(directory.resolve("ring.place.yaml"), ROUTE_CANDIDATES);
        PlacePlan plan = plan(file);
        AtomicInteger queries = new AtomicInteger();
        AtomicInteger first = new AtomicInteger();
        SolverLimits counted = new SolverLimits(0.001, Double.POSITIVE_INFINITY, () -> queries.incrementAndGet() < 0);
        new WeakestRouteSearch(plan, plan.runner().stage(plan.present()), LayerStore.NONE, new ExactSolver())
                .found(counted, cells -> {}, round -> first.compareAndSet(0, queries.get()));
        // A line says that all candidates have been assessed.
        assertWholeAtAllMoments(plan, 1 + first.get());
    }

    /**
     * Interrupts a search at one moment after another.
     *
     * @param least number of moments after which there is a layout
     */
    private void assertWholeAtAllMoments(PlacePlan plan, int least) throws IOException {
        Found all = found(plan, 0);
        PlaceResults whole = all.results().orElseThrow();
        assertThat(whole.complete()).isTrue();
        int incomplete = 0;
        int tried = 0;
        for (int when : moments(all.moments())) {
            Optional<PlaceResults> results = found(plan, when).results();
            String moment = "moment " + when + " of " + all.moments();
            assertThat(results.isPresent() || when <= least).as(moment).isTrue();
            if (results.isPresent()) {
                assertWhole(results.get(), plan, moment);
                if (tried++ % WRITTEN == 0) {
                    assertFiles(results.get(), plan, moment);
                }
                assertThat(results.get().complete()).as(moment).isEqualTo(isSame(results.get(), whole));
                incomplete += results.get().complete() ? 0 : 1;
            }
            if (when == all.moments()) {
                assertThat(results.orElseThrow().complete()).as(moment).isTrue();
            }
        }
        assertThat(incomplete).isGreaterThan(FIRST_AND_LAST);
    }

    private static TreeSet<Integer> moments(int count) {
        TreeSet<Integer> moments = new TreeSet<>();
        for (int at = 1; at <= Math.min(FIRST_AND_LAST, count); at++) {
            moments.add(at);
            moments.add(count + 1 - at);
        }
        for (int step = 1; step < MOMENTS; step++) {
            moments.add(Math.max(1, (int) ((long) count * step / MOMENTS)));
        }
        return moments;
    }

    /** Whether nothing that is printed or written is missing but that something is. */
    private static boolean isSame(PlaceResults results, PlaceResults whole) {
        return json(results).equals(json(whole)) && lines(results).equals(lines(whole));
    }

    private static ObjectNode json(PlaceResults results) {
        ObjectNode json = results.toJson();
        json.remove(List.of(COMPLETE, STOPPED));
        return json;
    }

    private static List<String> lines(PlaceResults results) {
        return results.lines().stream()
                .filter(line -> !line.contains(" time limit of "))
                .toList();
    }

    private void assertWhole(PlaceResults results, PlacePlan plan, String moment) throws IOException {
        double budget = plan.settings().budget();
        double cost = -1.0;
        double value = -1.0;
        for (FrontPoint<? extends PlacedLayout> point : results.front().points()) {
            assertThat(point.cost()).as(moment).isGreaterThan(cost).isLessThanOrEqualTo(point.budget());
            assertThat(point.layout().value()).as(moment).isGreaterThan(value);
            assertThat(point.layout().bound())
                    .as(moment)
                    .isGreaterThanOrEqualTo(point.layout().value());
            cost = point.cost();
            value = point.layout().value();
        }
        assertThat(cost).as(moment).isLessThanOrEqualTo(budget);
        assertThat(results.front().stopped()).as(moment).isEmpty();
        assertThat(results.complete()).as(moment).isEqualTo(!results.isInterrupted());
        assertThat(results.lines()).as(moment).isNotEmpty().noneMatch(line -> line.contains("NaN"));
        assertThat(Thread.currentThread().isInterrupted()).as(moment).isFalse();
    }

    /** All files can be read, and say whether anything is left out. */
    private void assertFiles(PlaceResults results, PlacePlan plan, String moment) throws IOException {
        try (PlaceDirectory out = new PlaceDirectory(directory, directory.resolve("radars.place.yaml"), plan)) {
            Provenance provenance = new Provenance(
                    Instant.now(), List.of("place"), plan.runner().inputs());
            out.write(results, provenance, 1, note -> {});
        }
        JsonNode json = JsonMapper.builder()
                .build()
                .readTree(directory.resolve("place.json").toFile());
        assertThat(json.get(COMPLETE).asBoolean()).as(moment).isEqualTo(results.complete());
        assertThat(json.get("chosen"))
                .as(moment)
                .hasSize(results.best().chosen().size());
        assertThat(directory.resolve("report.html"))
                .content()
                .as(moment)
                .contains("</html>")
                .satisfies(page ->
                        assertThat(page.contains("the search was interrupted")).isEqualTo(!results.complete()));
        try (Stream<Path> files = Files.list(directory)) {
            assertThat(files.map(file -> file.getFileName().toString())).noneMatch(name -> name.startsWith(".partial"));
        }
        assertThat(Program.run("check", directory.resolve("layout.yaml").toString())
                        .code())
                .as(moment)
                .isZero();
    }
}
