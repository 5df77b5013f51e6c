package org.dronewatch.report.coverage;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.survey.ConditionCoverage;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.FieldSurvey;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.coverage.table.CoverageSite;
import org.dronewatch.report.coverage.table.SurveyTables;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The files of a survey that was interrupted, in a directory that holds those of an earlier one. */
class CoverageDirectoryTest {
    @TempDir
    private Path directory;

    @Test
    void whatIsNotWholeIsLeftOutAndNothingOldRemains() throws IOException {
        FieldSite site = FieldSite.in(directory, FieldSite.ROUND);
        FieldGrid grid = new FieldGrid(0, 0, 200, 50, List.of(10.0, 30.0));
        FieldRequest request = new FieldRequest(
                site.settings(),
                site.stage(),
                "one",
                grid,
                Course.all(site.settings().enabledSensors(), DetectionField.droneOf(site.stage(), "one")),
                FieldCoverage.Choice.BEST,
                FieldTerms.ONE_LOOK,
                0.5);
        FieldSurvey whole = FieldSurvey.of(request, List.of(), cells -> {}, () -> {});
        CoverageInputs inputs =
                new CoverageInputs("site", "one", "best", 0.5, FieldTerms.ONE_LOOK, Optional.empty(), Optional.empty());
        CoverageSite there = new CoverageSite(site.settings(), site.stage());
        Path out = Files.createDirectory(directory.resolve("field"));
        for (String name : List.of(
                "coverage.json", "cause-30.png", "cause-7.5.tif", "count-30.tif", "warning.png", "report.html")) {
            Files.writeString(out.resolve(name), "of an earlier survey");
        }
        Files.writeString(out.resolve("notes.txt"), "the user's own");

        FieldSummary low = new FieldSummary(
                whole.summary().coverage(), whole.summary().heights().subList(0, 1));
        try (CoverageDirectory target = new CoverageDirectory(out)) {
            target.write(
                    new FieldSurvey(grid, low, Optional.empty(), Optional.empty(), Optional.empty()),
                    inputs,
                    there,
                    Map.of());
        }
        try (Stream<Path> files = Files.list(out)) {
            assertThat(files.map(file -> file.getFileName().toString()))
                    .containsExactlyInAnyOrder("cause-10.png", "coverage.json", "notes.txt");
        }
        JsonNode json = json(out);
        assertThat(json.get("complete").asBoolean()).isFalse();
        assertThat(json.get("heights")).hasSize(1);
        assertThat(json.get("heights").get(0).get("covered_share").asDouble()).isPositive();
        assertThat(json.get("heights").get(0).get("visible_share").isNull()).isTrue();
        assertThat(json.get("heights").get(0).get("detectable_share").isNull()).isTrue();
        for (String key : List.of("idle_sensors", "covered_again_gap", "warning")) {
            assertThat(json.get(key).isNull()).as(key).isTrue();
        }

        assertThat(SurveyTables.missing(
                        new FieldSurvey(grid, low, Optional.empty(), Optional.empty(), Optional.empty(), List.of(), 2)))
                .isEqualTo("complete for 1 of 2 heights; missing: lowest visible heights, lowest detection heights,"
                        + " warnings, 2 of 2 conditions");
        assertThat(SurveyTables.missing(new FieldSurvey(
                        grid,
                        whole.summary(),
                        whole.visible(),
                        whole.detectable(),
                        whole.warnings(),
                        List.of(ConditionCoverage.asItIs(whole.summary()), ConditionCoverage.asItIs(whole.summary())),
                        3)))
                .isEqualTo("complete for 2 of 2 heights; missing: 2 of 3 conditions");

        try (CoverageDirectory target = new CoverageDirectory(out)) {
            target.write(whole, inputs, there, Map.of());
        }
        assertThat(out.resolve("report.html")).content().contains("<html");
        assertThat(json(out).get("complete").asBoolean()).isTrue();
        assertThat(json(out).propertyNames()).containsExactlyElementsOf(json.propertyNames());
        assertThat(json(out).get("heights").get(0).propertyNames())
                .containsExactlyElementsOf(json.get("heights").get(0).propertyNames());
    }

    private static JsonNode json(Path out) {
        return JsonMapper.builder()
                .build()
                .readTree(out.resolve("coverage.json").toFile());
    }
}
