package org.dronewatch.report.coverage.table;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.GapMap;
import org.dronewatch.analysis.survey.GapSpan;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.html.ReportPage;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;

/** The largest gaps as the report describes them, against the cells of which they consist. */
class WorstPlacesTest {
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 380, 10, List.of(2.0, 26.0));
    private static final Position TARGET = new Position(30, -20, 0);

    private static final String SENSORS = FieldSite.ROUND.replace("maxRange: 150", "maxRange: 400")
            + """
              dome: {kind: camera, position: [0, 0, 4], fov: 40 deg, width: 800, height: 600}
            """;

    @TempDir
    private static Path directory;

    private static FieldSite site;
    private static FieldSummary summary;
    private static List<GapSpan> spans;
    private static Document page;

    @BeforeAll
    static void describe() throws IOException {
        site = FieldSite.in(directory, SENSORS);
        summary = FieldSummary.of(site.field(GRID, 2), FieldCoverage.Choice.BEST, 0.5);
        spans = GapSpan.of(summary.coverage()).stream()
                .filter(span -> span.gap().cells() > 1)
                .limit(6)
                .toList();
        page = ReportPage.parsed("<r>" + places(summary).html() + "</r>");
    }

    private static WorstPlaces places(FieldSummary of) {
        return new WorstPlaces(
                of,
                new CoverageSite(site.settings(), site.stage()),
                new ReferencePoint(TARGET, "the centre of the test", Optional.empty()));
    }

    private static List<String> gaps() {
        return ReportPage.texts(page, "p").stream()
                .filter(line -> line.startsWith("A gap of "))
                .toList();
    }

    private static List<Double> numbers(String text, String pattern) {
        Matcher found = Pattern.compile(pattern).matcher(text);
        assertThat(found.find()).as(text).isTrue();
        List<Double> numbers = new ArrayList<>();
        for (int group = 1; group <= found.groupCount(); group++) {
            numbers.add(Double.parseDouble(found.group(group)));
        }
        return numbers;
    }

    @Test
    void gapsAreListedFromTheLargestOnWithTheirAreas() {
        assertThat(spans).hasSizeGreaterThan(2);
        List<String> headings = ReportPage.texts(page, "h3");
        assertThat(headings).hasSameSizeAs(spans);
        assertThat(gaps()).hasSameSizeAs(spans);
        for (int i = 0; i < spans.size(); i++) {
            double hectares = spans.get(i).gap().cells() * 100 * 1e-4;
            assertThat(headings.get(i)).startsWith((i + 1) + ". At ");
            assertThat(numbers(headings.get(i), ": ([\\d.]+) ha$").get(0)).isCloseTo(hectares, within(0.051));
            int known = summary.heights().get(spans.get(i).height()).known();
            assertThat(numbers(gaps().get(i), "\\(([\\d.]+) % of the known area\\)")
                            .get(0))
                    .isCloseTo(100.0 * spans.get(i).gap().cells() / known, within(0.051));
        }
    }

    @Test
    void eachIsWhereItsCellsAre() {
        for (int i = 0; i < spans.size(); i++) {
            GapSpan span = spans.get(i);
            GapMap map = GapMap.of(summary.coverage(), span.height());
            String text = gaps().get(i);
            List<Double> inner = numbers(text, "innermost point is at x (-?\\d+) m, y (-?\\d+) m");
            int nearest = Arrays.stream(map.cells(span.number()))
                    .boxed()
                    .min((a, b) -> Double.compare(distance(a), distance(b)))
                    .orElseThrow();
            boolean holds = Arrays.stream(map.cells(span.number()))
                    .anyMatch(cell -> Math.abs(GRID.x(cell % GRID.columns()) - inner.get(0)) < 0.51
                            && Math.abs(GRID.y(cell / GRID.columns()) - inner.get(1)) < 0.51);
            assertThat(holds).as(text).isTrue();
            if (distance(nearest) > GRID.cell()) {
                assertThat(numbers(text, "begins (\\d+) m [a-z-]+ of the centre of the test")
                                .get(0))
                        .isCloseTo(distance(nearest), within(0.51));
            } else {
                assertThat(text).contains("includes the centre of the test");
            }
            boolean isAtEdge = Arrays.stream(map.cells(span.number()))
                    .anyMatch(cell -> cell < GRID.columns()
                            || cell >= GRID.cells() - GRID.columns()
                            || cell % GRID.columns() == 0
                            || cell % GRID.columns() == GRID.columns() - 1);
            assertThat(text)
                    .contains(isAtEdge ? "reaches the edge of the area" : "does not reach the edge of the area");
        }
    }

    private static double distance(int cell) {
        return Math.hypot(GRID.x(cell % GRID.columns()) - TARGET.x(), GRID.y(cell / GRID.columns()) - TARGET.y());
    }

    /** The causes of the sensor that comes nearest, with the fraction of each, and a row for every sensor. */
    @Test
    void eachStatesWhyAndForEverySensor() {
        List<String> cells = ReportPage.texts(page, "td");
        for (int i = 0; i < spans.size(); i++) {
            Map<Cause, Integer> causes = spans.get(i).gap().causes();
            for (Map.Entry<Cause, Integer> one : causes.entrySet()) {
                double percent = 100.0 * one.getValue() / spans.get(i).gap().cells();
                assertThat(gaps().get(i)).contains(CoverageTable.name(one.getKey()));
                if (causes.size() > 1 && percent >= 1 && percent < 99) {
                    assertThat(gaps().get(i)).contains(String.format(Locale.ROOT, " in %.0f %% of the cells", percent));
                }
            }
        }
        for (String sensor : List.of("round", "dome")) {
            long rows = cells.stream()
                    .filter(cell -> List.of(cell.split(", ")).contains(sensor))
                    .count();
            assertThat(rows).as(sensor).isEqualTo(spans.size());
        }
        assertThat(gaps()).anyMatch(text -> text.contains("hidden by a building (building.obj)"));
    }

    @Test
    void theVerdictIsAboutTheLargest() {
        Cause main = spans.get(0).gap().causes().entrySet().stream()
                .max(Map.Entry.comparingByValue())
                .orElseThrow()
                .getKey();
        assertThat(places(summary).worstInWords())
                .startsWith("The largest gap, at ")
                .endsWith("The main reason there: " + CoverageTable.name(main) + ".");
        FieldGrid near = new FieldGrid(60, 60, 20, 10, List.of(26.0));
        WorstPlaces none = places(FieldSummary.of(site.field(near, 1), FieldCoverage.Choice.BEST, 0.5));
        assertThat(none.worstInWords()).isEqualTo("There is no gap in the coverage at these heights.");
        assertThat(none.html()).contains("the drone is detected everywhere");
    }
}
