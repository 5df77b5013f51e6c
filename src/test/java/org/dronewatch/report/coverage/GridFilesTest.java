package org.dronewatch.report.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.DetectableHeights;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.field.VisibleHeights;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.FieldSurvey;
import org.dronewatch.analysis.survey.Gap;
import org.dronewatch.analysis.survey.GapMap;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.geo.Origin;
import org.dronewatch.parallel.Workers;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.file.OutputDirectory;
import org.dronewatch.sensor.Cause;
import org.dronewatch.terrain.io.ElevationFiles;
import org.dronewatch.terrain.io.Window;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The files for geographic information systems, read again and compared with the field cell by cell. */
class GridFilesTest {
    private static final List<Double> HEIGHTS = List.of(2.0, 40.5);

    /** Detects at 0.9 in one look only nearby. */
    private static final String FAR =
            """
              far: {kind: radar, position: [0, 0, 4], minRange: 1, maxRange: 400, elevationWidth: 90 deg, minSpeed: 3 m/s,
                budget: {range: 140, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
            alert:
              zones:
                yard: {area: [[-190, -190], [190, -190], [190, 60], [-190, 190]], height: 40}
            """;

    @TempDir
    private static Path directory;

    private static FieldGrid grid;
    private static FieldCoverage coverage;
    private static FieldSurvey survey;

    @BeforeAll
    static void write() throws IOException {
        FieldSite site = FieldSite.in(directory, FieldSite.ROUND + FAR);
        AreaZone yard = AreaZone.inPlan("yard", site.settings().alert()).orElseThrow();
        grid = FieldGrid.over(yard, 20, HEIGHTS);
        try (Workers workers = new Workers(2)) {
            survey = workers.call(() -> {
                FieldSummary summary = FieldSummary.of(site.field(grid, 2), FieldCoverage.Choice.BEST, 0.9);
                return new FieldSurvey(
                        grid,
                        summary,
                        Optional.of(VisibleHeights.of(site.settings(), site.stage(), grid)),
                        Optional.of(DetectableHeights.of(summary.coverage(), cells -> {})),
                        Optional.empty());
            });
        }
        coverage = survey.summary().coverage();
        Origin origin = new Origin(Math.toRadians(50), Math.toRadians(15), Optional.empty());
        CoverageInputs inputs = new CoverageInputs(
                "site", FieldSite.DRONE, "best", 0.9, FieldTerms.ONE_LOOK, Optional.of("yard"), Optional.of(origin));
        try (OutputDirectory out = new OutputDirectory(directory.resolve("gis"))) {
            out.write(() -> {
                new GridFiles(survey, inputs, origin).write(out);
                out.publish(List.of());
            });
        }
    }

    private static float[] read(String name) throws IOException {
        return new ElevationFiles(directory.resolve("gis"))
                .open(name)
                .heights(new Window(0, 0, grid.columns(), grid.columns()));
    }

    /** The classes in the order of the names beside the file. */
    @Test
    void everyCellHasItsCause() throws IOException {
        int rarely = 0;
        int inside = 0;
        int outside = 0;
        for (int height = 0; height < 2; height++) {
            String name = List.of("cause-2.tif", "cause-40.5.tif").get(height);
            float[] causes = read(name);
            for (int cell = 0; cell < causes.length; cell++) {
                int column = cell % grid.columns();
                int row = cell / grid.columns();
                float its = causes[cell];
                if (!yardHolds(column, row)) {
                    assertThat(its).isNaN();
                    outside++;
                } else if (coverage.field().isInside(height, column, row)) {
                    assertThat(its).isEqualTo(12f);
                    inside++;
                } else if (coverage.isCovered(height, column, row)) {
                    assertThat(its).isEqualTo(Cause.DETECTED.ordinal());
                } else if (coverage.cause(height, column, row) == Cause.DETECTED) {
                    assertThat(its).isEqualTo(13f);
                    rarely++;
                } else {
                    assertThat(its)
                            .isEqualTo(coverage.cause(height, column, row).ordinal());
                }
            }
            List<String> names = Files.readAllLines(directory.resolve("gis").resolve(name + ".aux.xml")).stream()
                    .filter(line -> line.contains("<Category>"))
                    .map(line -> line.replaceAll("</?Category>", "").strip())
                    .toList();
            assertThat(names).hasSize(14).startsWith("unknown").contains("inside something solid");
            assertThat(names.get(Cause.DETECTED.ordinal())).isEqualTo("detected");
            assertThat(names.get(Cause.HIDDEN_BY_BUILDING.ordinal())).isEqualTo("hidden by a building");
            assertThat(names.get(13)).isEqualTo("detected, but less reliably");
        }
        assertThat(List.of(rarely, inside, outside)).allMatch(count -> count > 0);
    }

    /** The corner that the oblique edge of the yard cuts off: north of the line from (190, 60) to (-190, 190). */
    private static boolean yardHolds(int column, int row) {
        return grid.y(row) <= 60 + (190 - grid.x(column)) * 130 / 380;
    }

    @Test
    void everyKnownCellHasItsCount() throws IOException {
        for (int height = 0; height < 2; height++) {
            float[] counts = read(List.of("count-2.tif", "count-40.5.tif").get(height));
            int two = 0;
            for (int cell = 0; cell < counts.length; cell++) {
                int column = cell % grid.columns();
                int row = cell / grid.columns();
                if (coverage.isKnown(height, column, row)) {
                    int count = (coverage.covers(0, height, column, row) ? 1 : 0)
                            + (coverage.covers(1, height, column, row) ? 1 : 0);
                    assertThat(counts[cell]).isEqualTo(count);
                    two += count == 2 ? 1 : 0;
                } else {
                    assertThat(counts[cell]).isNaN();
                }
            }
            assertThat(two).isPositive();
        }
    }

    @Test
    void everyColumnHasItsHeights() throws IOException {
        float[] detectable = read("min-height.tif");
        float[] visible = read("visible-height.tif");
        int numbers = 0;
        for (int cell = 0; cell < detectable.length; cell++) {
            int column = cell % grid.columns();
            int row = cell / grid.columns();
            double lowest = survey.detectable().orElseThrow().height(column, row);
            assertThat(Float.compare(detectable[cell], (float) lowest)).isZero();
            double seen = survey.visible().orElseThrow().height(column, row);
            assertThat(Float.compare(visible[cell], (float) seen)).isZero();
            numbers += Float.isNaN(detectable[cell]) ? 0 : 1;
        }
        assertThat(numbers).isBetween(10, grid.cells() - 10);
    }

    /** Gaps of all heights, with areas that are those of the cells without coverage. */
    @Test
    void everyGapIsAnArea() throws IOException {
        JsonNode json = JsonMapper.builder()
                .build()
                .readTree(directory.resolve("gis/coverage.geojson").toFile());
        int gaps = 0;
        double area = 0.0;
        for (int height = 0; height < 2; height++) {
            List<Gap> all = GapMap.of(coverage, height).gaps();
            gaps += all.size();
            area += all.stream().mapToDouble(Gap::area).sum();
        }
        double stated = 0.0;
        OptionalDouble highest = OptionalDouble.empty();
        for (JsonNode feature : json.get("features")) {
            JsonNode its = feature.get("properties");
            stated += its.get("area_m2").asDouble();
            highest = OptionalDouble.of(Math.max(
                    highest.orElse(0.0), its.get("height_above_ground_m").asDouble()));
        }
        assertThat(json.get("features")).hasSize(gaps);
        assertThat(stated).isPositive().isCloseTo(area, within(1.0));
        assertThat(highest).hasValue(40.5);
        assertThat(Files.readString(directory.resolve("gis/coverage.kml"))).contains("40.5 m");
    }
}
