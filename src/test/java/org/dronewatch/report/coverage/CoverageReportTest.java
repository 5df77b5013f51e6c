package org.dronewatch.report.coverage;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.DetectableHeights;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.VisibleHeights;
import org.dronewatch.analysis.field.Warning;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.FieldSurvey;
import org.dronewatch.analysis.survey.GapMap;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.geo.Origin;
import org.dronewatch.parallel.Workers;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.coverage.table.CoverageSite;
import org.dronewatch.report.coverage.table.Losses;
import org.dronewatch.report.html.ReportPage;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.scenario.SceneSettings;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;

/** The report of a coverage: what it says is what was found. */
class CoverageReportTest {
    private static final FieldGrid GRID = new FieldGrid(0, 0, 400, 20, List.of(2.0, 60.0));

    /** The second one sees nothing that the first one does not see. */
    private static final String SENSORS =
            FieldSite.ROUND + FieldSite.ROUND.replace("round", "short").replace("maxRange: 150", "maxRange: 40");

    @TempDir
    private static Path directory;

    private static FieldSite site;
    private static FieldSurvey found;
    private static Document page;
    private static String text;

    @BeforeAll
    static void report() throws IOException {
        site = FieldSite.in(directory, SENSORS);
        found = find(site.settings());
        String html = html(found, site.settings(), Optional.of(new Origin(0.8, 0.2, Optional.empty())));
        page = ReportPage.parsed(html);
        text = page.getDocumentElement().getTextContent();
    }

    private static FieldSurvey find(SceneSettings settings) {
        try (Workers workers = new Workers(2)) {
            return workers.call(() -> {
                FieldSummary summary = FieldSummary.of(site.field(GRID, 2), FieldCoverage.Choice.BEST, 0.5);
                return new FieldSurvey(
                        GRID,
                        summary,
                        Optional.of(VisibleHeights.of(settings, site.stage(), GRID)),
                        Optional.of(DetectableHeights.of(summary.coverage(), cells -> {})),
                        Optional.of(InboundWarnings.of(
                                settings, site.stage(), FieldSite.DRONE, GRID, FieldTerms.ONE_LOOK, 0.5, cells -> {})));
            });
        }
    }

    private static String html(FieldSurvey survey, SceneSettings settings, Optional<Origin> origin) throws IOException {
        return html(survey, settings, origin, "best");
    }

    private static String html(FieldSurvey survey, SceneSettings settings, Optional<Origin> origin, String heading)
            throws IOException {
        CoverageInputs inputs = new CoverageInputs(
                "boxes <1>", FieldSite.DRONE, heading, 0.5, FieldTerms.ONE_LOOK, Optional.empty(), origin);
        CoverageSite there = new CoverageSite(settings, site.stage());
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        new CoverageReport(survey, inputs, there)
                .write(bytes, new FieldPictures(there, inputs, GRID).all(survey).values(), Map.of("program", "<2>"));
        return bytes.toString(StandardCharsets.UTF_8);
    }

    @Test
    void theWorstPlaceIsTheFirstAndIsDescribedWithItsNumbers() {
        List<String> headings = ReportPage.texts(page, "h3");
        double area = found.summary().heights().get(0).gap().orElseThrow().area();
        assertThat(headings.get(0))
                .isEqualTo(String.format(Locale.ROOT, "1. At 2 to 60 m above the ground: %.1f ha", 1e-4 * area));
        Matcher hectares = Pattern.compile("([\\d.]+) ha").matcher(String.join("; ", headings));
        double before = Double.POSITIVE_INFINITY;
        while (hectares.find()) {
            double its = Double.parseDouble(hectares.group(1));
            assertThat(its).isLessThanOrEqualTo(before);
            before = its;
        }
        String first = ReportPage.texts(page, "p").stream()
                .filter(line -> line.startsWith("A gap of "))
                .findFirst()
                .orElseThrow();
        Matcher begins = Pattern.compile(
                        "begins (\\d+) m ([a-z-]+) of the centroid of the sensors and reaches the edge")
                .matcher(first);
        assertThat(begins.find()).as(first).isTrue();
        assertThat(Double.parseDouble(begins.group(1))).isEqualTo(Math.rint(nearest()));
        assertThat(first).contains("° N", "° E");
    }

    /** The distance of the nearest cell of the largest gap, by looking at all cells. */
    private static double nearest() {
        GapMap map = GapMap.of(found.summary().coverage(), 0);
        double nearest = Double.POSITIVE_INFINITY;
        for (int row = 0; row < GRID.columns(); row++) {
            for (int column = 0; column < GRID.columns(); column++) {
                if (map.contains(0, column, row)) {
                    nearest = Math.min(nearest, Math.hypot(GRID.x(column), GRID.y(row)));
                }
            }
        }
        return nearest;
    }

    /** On the worst heading, both radars are blind, and the report says why and where to look for other headings. */
    @Test
    void theCausesOfEachSensorAreStatedWithTheReasonForBlindRadars() throws IOException {
        FieldSurvey worst = new FieldSurvey(
                GRID,
                FieldSummary.of(found.summary().coverage().field(), FieldCoverage.Choice.WORST, 0.5),
                found.visible(),
                found.detectable(),
                found.warnings());
        Document blind = ReportPage.parsed(html(worst, site.settings(), Optional.empty(), "worst"));

        assertThat(ReportPage.texts(page, "p"))
                .contains("The table states what each sensor detects by itself, and why it misses the rest, in % of the"
                        + " known area at all heights.")
                .noneMatch(line -> line.startsWith("Too slow: "));
        assertThat(ReportPage.texts(page, "th")).contains("out of range [%]");
        assertThat(ReportPage.texts(blind, "p"))
                .containsSubsequence(
                        "The table states what each sensor detects by itself, and why it misses the rest, in % of the"
                                + " known area at all heights.",
                        "Too slow: hovering, or flying across a radar's line of sight; what is detected on other headings"
                                + " is shown by --heading best or inbound.");
    }

    @Test
    void whatHidesTheDroneIsNamed() {
        assertThat(text)
                .contains("hidden by a building (building.obj)")
                .contains("hidden by terrain (terrain.obj)")
                .contains("out of range (beyond 150 m)")
                .contains("out of range (beyond 40 m)");
    }

    /** Hovering is one of the courses from which the best and the worst are chosen. */
    @Test
    void theReportSaysThatTheDroneMayHover() {
        assertThat(text).contains("is assessed, in level flight at its cruise speed and hovering; sensors on");
    }

    @Test
    void theSensorThatAddsNothingIsNamedAndTheOneThatCarriesAllOfIt() {
        String verdict = ReportPage.texts(page, "p").get(0);
        assertThat(verdict)
                .startsWith(
                        "The drone 'one', on the heading on which it is most likely to be detected, is detected in ")
                .contains("the loss is greatest without 'round'")
                .contains("'short' adds nothing");
        assertThat(text).contains("Without 'round', at least half of the coverage is lost at 2 to 60 m.");
    }

    /** Of 10,000 known cells, one in a thousand is 10. */
    @Test
    void theLossOfHardlyAnyCoverageIsNotMentioned() {
        assertThat(new Losses(covered(11)).html()).contains("Without 'round', at least half of the coverage is lost");
        assertThat(new Losses(covered(10)).html()).doesNotContain("at least half of the coverage is lost");
    }

    /** A summary in which only one sensor covers some of 10,000 cells at each height. */
    private static FieldSummary covered(int cells) {
        FieldSummary summary = found.summary();
        return new FieldSummary(
                summary.coverage(),
                summary.heights().stream()
                        .map(one -> new HeightSummary(
                                one.height(),
                                10_000,
                                10_000,
                                0,
                                cells,
                                one.volume(),
                                one.causes(),
                                one.causesBySensor(),
                                one.counts(),
                                Map.of("round", cells, "short", 0),
                                Map.of("round", cells, "short", 0),
                                one.gap()))
                        .toList());
    }

    /** Without a required response there is no ring; with one, its radius is that of its time. */
    @Test
    void theRoseHasTheNeededResponseAsARing() throws IOException {
        assertThat(text).contains("states no response time").doesNotContain("response time, ");
        assertThat(page.getElementsByTagName("polygon").getLength()).isEqualTo(2);
        InboundWarnings all = found.warnings().orElseThrow();
        InboundWarnings asked =
                new InboundWarnings(all.target(), all.reach(), all.longest(), 8.0, all.isZone(), all.all());
        String rose = new WarningRose(asked).svg();
        double longest = all.all().stream()
                .mapToDouble(one -> one.time().orElse(0))
                .max()
                .orElseThrow();
        assertThat(rose)
                .contains(String.format(Locale.ROOT, "r=\"%.1f\" fill=\"none\" stroke=\"#000\"", 235 * 8.0 / longest))
                .contains("response time, 8 s");
        List<Warning> east = all.all().stream()
                .filter(one -> Math.abs(one.bearing() - 0.5 * Math.PI) < 1e-9)
                .toList();
        for (Warning one : east) {
            assertThat(rose)
                    .contains(String.format(
                            Locale.ROOT, "%.1f,280.0", 280 + 235 * one.time().orElse(0) / longest));
        }
        String words = new WarningWords(asked).html() + new WarningWords(asked).worstInWords();
        long late = all.all().stream().filter(one -> !one.isInTime(8.0)).count();
        assertThat(words).contains("bearings with less than 8 s", "is not given in " + late + " of 72 cases");
        assertThat(ReportPage.parsed("<r>" + words + "</r>")).isNotNull();
    }

    /** Where nothing is detected, and nothing is missed. */
    @Test
    void theExtremesAreWordedToo() throws IOException {
        FieldSummary none = FieldSummary.of(
                FieldSite.in(Files.createDirectory(directory.resolve("none")), FieldSite.ROUND.replace("150", "2"))
                        .field(GRID, 2),
                FieldCoverage.Choice.BEST,
                0.5);
        List<Warning> silent = found.warnings().orElseThrow().all().stream()
                .map(one -> new Warning(
                        one.bearing(),
                        one.height(),
                        one.arrival(),
                        java.util.OptionalDouble.empty(),
                        java.util.OptionalDouble.empty(),
                        false))
                .toList();
        InboundWarnings all = found.warnings().orElseThrow();
        InboundWarnings undetected =
                new InboundWarnings(all.target(), all.reach(), all.longest(), 8.0, all.isZone(), silent);
        String words = new Losses(none).html()
                + new WarningWords(undetected).html()
                + new WarningWords(undetected).worstInWords();
        assertThat(words)
                .contains(
                        "undetected; this happens in 72 of 72 combinations of bearing and height.",
                        "none from any bearing")
                .contains("Nothing is covered, so nothing can be lost.")
                .doesNotContain("NaN", "Infinity", "adds nothing");
        assertThat(none.idleSensors()).isEmpty();
        assertThat(new Losses(none).worstInWords()).isEmpty();
    }

    /** Beyond the edge of the site, the map of warnings has a pattern, which its legend explains; roads are plain. */
    @Test
    void whereTheGroundIsUnknownTheMapOfWarningsSaysSo() {
        CoverageSite there = new CoverageSite(site.settings(), site.stage());
        CoverageInputs inputs = new CoverageInputs(
                "boxes", FieldSite.DRONE, "best", 0.5, FieldTerms.ONE_LOOK, Optional.empty(), Optional.empty());
        for (double side : new double[] {900, 1100}) {
            FieldGrid grid = new FieldGrid(0, 0, side, 20, List.of(60.0));
            int[] ground = MapSheet.ground(site.stage().world(), grid);
            MapSheet sheet = new WarningMap(there, inputs)
                    .sheet(grid, ground, found.warnings().orElseThrow());
            Set<Color> corner = new HashSet<>();
            int patterned = 0;
            for (int v = 1; v < 30; v++) {
                for (int u = 1; u < 30; u++) {
                    corner.add(sheet.colour(u, v));
                }
            }
            for (int v = 0; v < MapSheet.MAP; v++) {
                Set<Color> swatch = new HashSet<>();
                for (int u = 1; u < 20; u++) {
                    swatch.add(sheet.colour(MapSheet.MAP + 24 + u, v));
                }
                patterned += swatch.equals(corner) ? 1 : 0;
            }
            assertThat(corner).as("side %s", side).hasSize(side > 1000 ? 2 : 1);
            assertThat(patterned).as("side %s", side).isEqualTo(side > 1000 ? 15 : 0);
        }
    }

    @Test
    void whatComesFromOutsideIsEscapedAndNothingIsLoaded() {
        assertThat(text).contains("boxes <1>: coverage", "<2>");
        assertThat(page.getElementsByTagName("img").getLength()).isEqualTo(5);
        for (int i = 0; i < 5; i++) {
            assertThat(page.getElementsByTagName("img")
                            .item(i)
                            .getAttributes()
                            .getNamedItem("src")
                            .getNodeValue())
                    .startsWith("data:image/png;base64,");
        }
        assertThat(page.getElementsByTagName("script").getLength()).isZero();
    }
}
