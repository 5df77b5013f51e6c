package org.dronewatch.analysis.survey;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.store.SiteStore;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The coverage under conditions, against that of the changed scene, assessed on its own and counted cell by cell. */
class ConditionCoverageTest {
    private static final FieldGrid GRID = new FieldGrid(3, 2, 240, 40, List.of(2.0, 6.0));

    private static final String SENSORS = FieldSite.ROUND
            + """
              notched: {kind: radar, position: [5, 0, 4], minRange: 1, maxRange: 400, elevationWidth: 90 deg, azimuthWidth: 120 deg,
                budget: {range: 160, crossSection: 0.01}, notch: {kind: high-pass, halfPowerSpeed: 4 m/s},
                detection: {kind: chance, pulses: 8}}
              radio: {kind: rf, position: [0, 5, 4], threshold: 30}
            """;

    /** Changes by the names of the conditions; the last two do not only switch sensors off. */
    private static final Map<String, Map<String, String>> CHANGES = new LinkedHashMap<>();

    @TempDir
    private static Path scene;

    @TempDir
    private Path place;

    @BeforeAll
    static void write() throws IOException {
        FieldSite.in(scene, SENSORS);
        CHANGES.put("no radar", Map.of("sensors.round.enabled", "false"));
        CHANGES.put("no chance", Map.of("sensors.notched.enabled", "false"));
        CHANGES.put("radio alone", Map.of("sensors.round.enabled", "false", "sensors.notched.enabled", "false"));
        CHANGES.put(
                "nothing",
                Map.of(
                        "sensors.round.enabled", "false",
                        "sensors.notched.enabled", "false",
                        "sensors.radio.enabled", "false"));
        CHANGES.put("deafer", Map.of("sensors.radio.threshold", "34"));
        CHANGES.put("other seed", Map.of("run.seed", "8", "sensors.round.enabled", "false"));
    }

    private static FieldRequest request(Map<String, String> changes, FieldCoverage.Choice choice) {
        SceneRunner runner = new SceneRunner(new SceneFile(scene.resolve("site.yaml")));
        changes.forEach(runner::set);
        var stage = runner.stage(runner.settings());
        return new FieldRequest(
                runner.settings(),
                stage,
                FieldSite.DRONE,
                GRID,
                Course.all(runner.settings().enabledSensors(), DetectionField.droneOf(stage, FieldSite.DRONE)),
                choice,
                FieldTerms.ONE_LOOK,
                0.5);
    }

    private FieldSurvey survey(FieldCoverage.Choice choice, List<String> names, AtomicLong looks) {
        FieldRequest asItIs = request(Map.of(), choice);
        List<FieldCondition> conditions = names.stream()
                .map(name -> new FieldCondition(name, () -> request(CHANGES.get(name), choice)))
                .toList();
        SiteStore kept = new SiteStore(Optional.of(place), 1 << 28, 0.0, note -> {});
        try (Workers workers = new Workers(2)) {
            return workers.call(() -> FieldSurvey.of(
                    asItIs,
                    conditions,
                    settings -> LayerStore.of(settings, Map.of(), kept),
                    looks::addAndGet,
                    () -> {}));
        }
    }

    private static FieldCoverage alone(FieldRequest asked) {
        try (Workers workers = new Workers(2)) {
            return workers.call(() -> new FieldCoverage(
                    FieldAssessment.of(asked, LayerStore.NONE, cells -> {}), asked.choice(), asked.covered()));
        }
    }

    @Test
    void aConditionIsTheChangedSceneWhetherItsSensorsAreAssessedAgainOrNot() {
        for (FieldCoverage.Choice choice : FieldCoverage.Choice.values()) {
            List<String> names = choice == FieldCoverage.Choice.BEST
                    ? List.copyOf(CHANGES.keySet())
                    : List.of("no radar", "no chance");
            List<ConditionCoverage> found =
                    survey(choice, names, new AtomicLong()).conditions();
            assertThat(found).hasSize(names.size() + 1);
            FieldCoverage asItIs = alone(request(Map.of(), choice));
            int at = 1;
            for (String name : names) {
                assertThat(found.get(at).name()).isEqualTo(name);
                FieldCoverage under = alone(request(CHANGES.get(name), choice));
                for (int height = 0; height < 2; height++) {
                    check(found.get(at).heights().get(height), asItIs, under, height, choice + " " + name);
                    assertThat(found.get(at).heights().get(height).lost())
                            .as(name)
                            .isGreaterThanOrEqualTo(
                                    choice == FieldCoverage.Choice.BEST && name.equals("nothing") ? 10 : 0);
                }
                at++;
            }
        }
    }

    private static void check(
            ConditionCoverage.Height its, FieldCoverage asItIs, FieldCoverage under, int height, String what) {
        int known = 0;
        int covered = 0;
        int lost = 0;
        int[] bySensor = new int[under.field().sensors().size()];
        for (int row = 0; row < GRID.columns(); row++) {
            for (int column = 0; column < GRID.columns(); column++) {
                known += asItIs.isKnown(height, column, row) ? 1 : 0;
                covered += under.isCovered(height, column, row) ? 1 : 0;
                lost += asItIs.isCovered(height, column, row) && !under.isCovered(height, column, row) ? 1 : 0;
                for (int sensor = 0; sensor < bySensor.length; sensor++) {
                    bySensor[sensor] += under.covers(sensor, height, column, row) ? 1 : 0;
                }
            }
        }
        assertThat(its.summary().covered()).as(what).isEqualTo(covered);
        assertThat(its.lost()).as(what).isEqualTo(lost);
        assertThat(its.knownAsItIs()).as(what).isEqualTo(known);
        assertThat(its.bySensor().keySet())
                .as(what)
                .containsExactlyElementsOf(under.field().sensors());
        List<Integer> counts = new ArrayList<>(its.bySensor().values());
        for (int sensor = 0; sensor < bySensor.length; sensor++) {
            assertThat(counts.get(sensor)).as(what).isEqualTo(bySensor[sensor]);
        }
    }

    /** What lacks sensors alone is not assessed again; what else is changed is found the second time. */
    @Test
    void nothingIsAssessedTwice() throws IOException {
        AtomicLong alone = new AtomicLong();
        survey(FieldCoverage.Choice.BEST, List.of(), alone);
        int count = files().size();
        AtomicLong looks = new AtomicLong();
        survey(FieldCoverage.Choice.BEST, List.of("no radar", "no chance", "radio alone", "nothing"), looks);
        assertThat(looks.get()).isEqualTo(alone.get()).isPositive();
        assertThat(files()).hasSize(count);
        survey(FieldCoverage.Choice.BEST, List.of("deafer"), looks);
        List<Path> more = files();
        assertThat(more).as("one sensor at two heights").hasSize(count + 2);
        for (Path file : more) {
            Files.setLastModifiedTime(file, FileTime.fromMillis(0));
        }
        survey(FieldCoverage.Choice.BEST, List.of("deafer"), looks);
        assertThat(files()).hasSameSizeAs(more);
        for (Path file : more) {
            assertThat(Files.getLastModifiedTime(file).toMillis()).as("used").isPositive();
        }
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> all = Files.list(place)) {
            return all.sorted().toList();
        }
    }
}
