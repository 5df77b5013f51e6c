package org.dronewatch.report.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.survey.CellExaminer;
import org.dronewatch.analysis.survey.CellExaminer.CellEvidence;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.GapEvidence;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.analysis.survey.RemainingCoverage;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.coverage.table.CellWords;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.coverage.table.CoverageTable;
import org.dronewatch.report.coverage.table.FieldTable;
import org.dronewatch.report.coverage.table.LossWords;
import org.dronewatch.report.coverage.table.Losses;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The coverage over a site and in words, against the field and the summary from which the report is made. */
class CoverageSkinTest {
    private static final FieldGrid GRID = new FieldGrid(10, -5, 420, 12, List.of(2.0, 12.0, 60.0));
    private static final int GREY = 0x808080;
    /** What the skin makes of the grey of the ground. */
    private static final int PALE = 0xb9b9b9;

    private static final long SEED = 20261126;

    private static final String ROUND = FieldSite.ROUND.replace("minSpeed: 3 m/s", "minSpeed: 0 m/s");

    private static final String SENSORS = ROUND
            + ROUND.replace("round", "short").replace("maxRange: 150", "maxRange: 40")
            + ROUND.replace("round", "far").replace("[0, 0, 4]", "[90, -60, 6]");

    @TempDir
    private static Path directory;

    private static FieldSite site;
    private static FieldSummary summary;
    private static FieldCoverage all;

    @BeforeAll
    static void assess() throws IOException {
        site = FieldSite.in(directory, SENSORS);
        summary = FieldSummary.of(site.field(GRID, 2), FieldCoverage.Choice.WORST, 0.5);
        all = summary.coverage();
    }

    private static CoverageSkin skin(Set<String> off, int height) {
        return new CoverageSkin(RemainingCoverage.of(all, all.without(off), height));
    }

    /** The colour between the lines of the patterns. */
    private static int plain(CoverageSkin skin, int column, int row) {
        return skin.colour(GRID.x(column), GRID.y(row), 3, 6, GREY);
    }

    @Test
    void everyCellHasTheColourOfItsCauseAndNothingElseHasOne() {
        for (int height = 0; height < GRID.heights().size(); height++) {
            CoverageSkin skin = skin(Set.of(), height);
            Map<String, Integer> colours = new TreeMap<>();
            for (int cell = 0; cell < GRID.cells(); cell++) {
                int column = cell % GRID.columns();
                int row = cell / GRID.columns();
                String state = all.field().isInside(height, column, row)
                        ? "inside"
                        : String.valueOf(all.cause(height, column, row));
                Integer colour = plain(skin, column, row);
                assertThat(colours.merge(state, colour, (one, other) -> one))
                        .as("%s at %d, %d", state, column, row)
                        .isEqualTo(colour);
            }
            assertThat(colours.values())
                    .as("one colour for each of %s", colours)
                    .doesNotHaveDuplicates();
            assertThat(colours).containsKey("DETECTED").hasSizeGreaterThan(3);
        }
        double edge = 0.5 * GRID.columns() * GRID.cell();
        CoverageSkin skin = skin(Set.of(), 1);
        assertThat(skin.colour(GRID.east() + edge + 0.01, GRID.north(), 3, 6, GREY))
                .isEqualTo(GREY);
        assertThat(skin.colour(GRID.east() + edge - 0.01, GRID.north(), 3, 6, GREY))
                .isNotEqualTo(GREY);
        assertThat(skin.colour(GRID.east(), GRID.north() - edge - 0.01, 3, 6, GREY))
                .isEqualTo(GREY);
        assertThat(skin.cellAt(new Position(GRID.east(), GRID.north() + edge + 0.01, 0)))
                .isEmpty();
    }

    /** With another probability than an even chance, what is painted as detected is what is covered. */
    @Test
    void detectedIsWhatIsCoveredWithTheProbabilityThatIsAskedFor() throws IOException {
        String chance =
                """
                  far: {kind: radar, position: [0, 0, 4], minRange: 1, maxRange: 400, elevationWidth: 90 deg, minSpeed: 0 m/s,
                    budget: {range: 120, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
                """;
        DetectionField field = FieldSite.in(Files.createDirectory(directory.resolve("chance")), chance)
                .field(GRID, 2);
        for (double covered : new double[] {0.1, 0.9}) {
            FieldCoverage asked = new FieldCoverage(field, FieldCoverage.Choice.WORST, covered);
            CoverageSkin skin = new CoverageSkin(RemainingCoverage.of(asked, asked, 1));
            Set<Integer> painted = new HashSet<>();
            Map<Boolean, Integer> counts = new TreeMap<>(Map.of(true, 0, false, 0));
            int less = 0;
            for (int cell = 0; cell < GRID.cells(); cell++) {
                int column = cell % GRID.columns();
                int row = cell / GRID.columns();
                if (!asked.isKnown(1, column, row)) {
                    continue;
                }
                boolean isCovered = field.probability(0, 1, column, row, asked.courseAt(1, column, row)) >= covered;
                counts.merge(isCovered, 1, Integer::sum);
                if (isCovered) {
                    painted.add(corner(skin, column, row));
                }
                less += !isCovered && asked.cause(1, column, row) == Cause.DETECTED ? 1 : 0;
            }
            assertThat(painted).as("one colour of what is covered").hasSize(1);
            assertThat(counts.values()).allMatch(count -> count > 50);
            int all = counts.get(true) + counts.get(false);
            for (int cell = 0; cell < GRID.cells(); cell++) {
                int column = cell % GRID.columns();
                int row = cell / GRID.columns();
                if (asked.isKnown(1, column, row) && !asked.isCovered(1, column, row)) {
                    assertThat(corner(skin, column, row)).isNotIn(painted);
                }
            }
            assertThat(words(skin))
                    .contains(String.format(Locale.ROOT, "detected: %.1f %%", 100.0 * counts.get(true) / all));
            String surely = String.format(Locale.ROOT, "detected, but less reliably: %.1f %%", 100.0 * less / all);
            assertThat(less > 0).isEqualTo(covered == 0.9);
            assertThat(words(skin).contains(surely)).isEqualTo(less > 0);
        }
    }

    /** The colour where the lines of the patterns meet. */
    private static int corner(CoverageSkin skin, int column, int row) {
        return skin.colour(GRID.x(column), GRID.y(row), 0, 0, GREY);
    }

    private static List<String> words(CoverageSkin skin) {
        return skin.legend().stream().map(CoverageSkin.LegendEntry::words).toList();
    }

    /** N-1 of the report, cell by cell and in words. */
    @Test
    void whatIsCrossedOutIsWhatTheReportStatesAsLost() {
        int lostAtAll = 0;
        for (int height = 0; height < GRID.heights().size(); height++) {
            HeightSummary numbers = summary.heights().get(height);
            for (String sensor : all.field().sensors()) {
                RemainingCoverage remaining = RemainingCoverage.of(all, all.without(Set.of(sensor)), height);
                CoverageSkin skin = new CoverageSkin(remaining);
                int crossed = 0;
                for (int cell = 0; cell < GRID.cells(); cell++) {
                    // The middle of a cross is black, which no other pattern is.
                    crossed +=
                            skin.colour(GRID.x(cell % GRID.columns()), GRID.y(cell / GRID.columns()), 8, 8, GREY) == 0
                                    ? 1
                                    : 0;
                }
                int lost = numbers.lost().get(sensor);
                assertThat(remaining.lost()).isEqualTo(lost);
                assertThat(crossed).as("%s at %s m", sensor, numbers.height()).isEqualTo(lost);
                lostAtAll += lost;
                String words = LossWords.sentence(remaining, Set.of(sensor));
                if (lost == 0) {
                    assertThat(words).contains("with or without '" + sensor + "'");
                } else {
                    assertThat(words)
                            .contains("without '" + sensor + "'")
                            .endsWith(String.format(Locale.ROOT, " (%.1f).", -100.0 * lost / numbers.known()));
                }
            }
        }
        assertThat(lostAtAll).isGreaterThan(100);
    }

    /** As in a scene without them, assessed anew. */
    @Test
    void withoutTwoSensorsItIsTheCoverageOfTheOthers() throws IOException {
        FieldSite others = FieldSite.in(java.nio.file.Files.createDirectory(directory.resolve("others")), ROUND);
        FieldCoverage expected = new FieldCoverage(others.field(GRID, 2), FieldCoverage.Choice.WORST, 0.5);
        FieldCoverage rest = all.without(List.of("far", "short"));
        for (int height = 0; height < GRID.heights().size(); height++) {
            for (int cell = 0; cell < GRID.cells(); cell++) {
                int column = cell % GRID.columns();
                int row = cell / GRID.columns();
                assertThat(rest.count(height, column, row)).isEqualTo(expected.count(height, column, row));
                assertThat(rest.cause(height, column, row)).isEqualTo(expected.cause(height, column, row));
            }
        }
        assertThat(all.without(List.of())).isSameAs(all);
    }

    @Test
    void theLegendStatesTheFractionsOfTheReport() {
        for (int height = 0; height < GRID.heights().size(); height++) {
            HeightSummary numbers = summary.heights().get(height);
            List<String> words = skin(Set.of(), height).legend().stream()
                    .map(CoverageSkin.LegendEntry::words)
                    .toList();
            numbers.causes().forEach((cause, cells) -> assertThat(words)
                    .contains(CoverageTable.name(cause) + ": " + CoverageTable.percent(cells, numbers.known()) + " %"));
            assertThat(words.contains("inside something solid")).isEqualTo(numbers.inside() > 0);
        }
        assertThat(skin(Set.of("round"), 1).legend().stream().map(CoverageSkin.LegendEntry::words))
                .anyMatch(words -> words.startsWith("no longer covered: "));
    }

    /** Nothing is known about a cause, but it is not the ground that is unknown. */
    @Test
    void withoutAnySensorNoCauseIsStated() {
        Set<String> everyOne = Set.copyOf(all.field().sensors());
        for (int height = 0; height < GRID.heights().size(); height++) {
            HeightSummary numbers = summary.heights().get(height);
            CoverageSkin skin = skin(everyOne, height);
            List<String> words =
                    skin.legend().stream().map(CoverageSkin.LegendEntry::words).toList();
            int rest = numbers.known() - numbers.covered();
            assertThat(words)
                    .contains("detected: nowhere")
                    .contains("no longer covered: " + CoverageTable.percent(numbers.covered(), numbers.known()) + " %")
                    .contains("no sensor: " + CoverageTable.percent(rest, numbers.known()) + " %")
                    .noneMatch(word -> word.startsWith("unknown"));
            for (int cell = 0; cell < GRID.cells(); cell++) {
                int column = cell % GRID.columns();
                int row = cell / GRID.columns();
                if (all.isKnown(height, column, row) && !all.isCovered(height, column, row)) {
                    assertThat(skin.colour(GRID.x(column), GRID.y(row), 3, 6, GREY))
                            .isEqualTo(CauseFills.NO_SENSOR.at(3, 6, PALE) & 0xffffff)
                            .isNotEqualTo(CauseFills.of(Cause.UNKNOWN).at(3, 6, PALE) & 0xffffff);
                }
            }
        }
    }

    /** A camera that turns its back has 0 of 12 pixels: not 12 pixels too few, but nothing. */
    @Test
    void whereNothingReachesASensorItHasNoMargin() throws IOException {
        FieldSite back = FieldSite.in(
                java.nio.file.Files.createDirectory(directory.resolve("back")),
                "  eye: {kind: camera, position: [0, 0, 4], fov: 40 deg, width: 800, height: 600}\n");
        FieldCoverage seen = new FieldCoverage(back.field(GRID, 2), FieldCoverage.Choice.WORST, 0.5);
        CellExaminer examiner = new CellExaminer(seen, back.stage());
        int out = 0;
        for (int row = 0; row < GRID.columns(); row++) {
            CellEvidence evidence = examiner.examine(1, 2, row).orElseThrow();
            if (seen.cause(1, 2, row) == Cause.OUT_OF_VIEW) {
                out++;
                assertThat(new CellWords(seen, back.settings(), 1, 2, row).deciding(evidence))
                        .isEqualTo(
                                "12 m above the ground: out of view. 'eye' determines the cause: probability 0, no signal.")
                        .isEqualTo(new CellWords(seen, back.settings(), 1, 2, row).deciding());
            }
        }
        assertThat(out).isPositive();
    }

    /** One and the same thing is said from the field alone, with the evidence, and of the gap in the report. */
    @Test
    void whatIsDetectedTooRarelyIsNotCalledDetected() throws IOException {
        String chance = ROUND.replace("range: 5000", "range: 120")
                .replace("0.01}}", "0.01}, detection: {kind: chance, pulses: 8}}");
        FieldSite unsure = FieldSite.in(java.nio.file.Files.createDirectory(directory.resolve("unsure")), chance);
        FieldCoverage some = new FieldCoverage(unsure.field(GRID, 2), FieldCoverage.Choice.WORST, 0.95);
        CellExaminer examiner = new CellExaminer(some, unsure.stage());
        int tooRarely = 0;
        int detected = 0;
        for (int cell = 0; cell < GRID.cells(); cell++) {
            int column = cell % GRID.columns();
            int row = cell / GRID.columns();
            if (some.isKnown(1, column, row) && some.cause(1, column, row) == Cause.DETECTED) {
                boolean isCovered = some.isCovered(1, column, row);
                String expected = isCovered ? "detected" : "detected, but with too low a probability";
                CellWords words = new CellWords(some, unsure.settings(), 1, column, row);
                CellEvidence evidence = examiner.examine(1, column, row).orElseThrow();
                assertThat(words.summary()).isEqualTo("12 m above the ground: " + expected);
                assertThat(words.cause(0)).isEqualTo(expected);
                assertThat(words.reason(0, evidence.sensors().get(0))).isEqualTo(expected);
                detected += isCovered ? 1 : 0;
                tooRarely += isCovered ? 0 : 1;
            }
        }
        assertThat(detected).isPositive();
        assertThat(tooRarely).isPositive();
    }

    /** Gains may cancel losses: then it is not said that nothing changes. */
    @Test
    void whatIsGainedIsSaidBesideWhatIsLost() {
        RemainingCoverage cancelled = new RemainingCoverage(all, all.without(Set.of("far")), 1, 1000, 100, 100, 5);
        assertThat(LossWords.sentence(cancelled, Set.of("far")))
                .isEqualTo("At 12 m, 10.0 % of the known area is covered, with or without 'far'."
                        + " 0.5 % is lost and 0.5 % is gained, where a different heading becomes the worst.");
        RemainingCoverage more = new RemainingCoverage(all, all.without(Set.of("far")), 1, 1000, 100, 120, 0);
        assertThat(LossWords.sentence(more, Set.of("far")))
                .isEqualTo("At 12 m, 12.0 % of the known area is covered without 'far', instead of 10.0 % (+2.0)."
                        + " Nothing is lost and 2.0 % is gained, where a different heading becomes the worst.");

        HeightSummary height = new HeightSummary(
                12,
                1000,
                1000,
                0,
                100,
                1,
                Map.of(),
                Map.of(),
                new int[] {900, 100},
                Map.of("round", -20, "short", 0, "far", 0),
                Map.of("round", 20, "short", 10, "far", 0),
                Optional.empty());
        FieldSummary one = new FieldSummary(all, List.of(height));
        CoverageInputs inputs = new CoverageInputs(
                "boxes", FieldSite.DRONE, "worst", 0.5, FieldTerms.ONE_LOOK, Optional.empty(), Optional.empty());
        assertThat(FieldTable.losses(one, inputs).stream().map(line -> line.replaceAll(" +", " ")))
                .containsExactly(
                        "coverage lost if one sensor is removed (lost minus gained), in % of the known cells:",
                        "sensor 12 m",
                        "round -2.0",
                        "short 0.0",
                        "far -",
                        "the same cells are covered (on the worst heading) without far");
        assertThat(new Losses(one).html())
                .contains("12.0 (+2.0)", "10.0 (different cells)", "'far' adds nothing to this coverage");
    }

    /** The sensor that decides has the highest probability; what it lacks is the difference of its two values. */
    @Test
    void theCellUnderThePointerIsDescribedByTheSensorThatDecides() {
        DetectionField field = all.field();
        CellExaminer examiner = new CellExaminer(all, site.stage());
        Random random = new Random(SEED);
        for (int i = 0; i < 300; i++) {
            int column = random.nextInt(GRID.columns());
            int row = random.nextInt(GRID.columns());
            int height = random.nextInt(GRID.heights().size());
            CellWords words = new CellWords(all, site.settings(), height, column, row);
            if (!field.isOpen(height, column, row)) {
                assertThat(examiner.examine(height, column, row)).isEmpty();
                assertThat(words.summary()).endsWith("m above the ground: inside something solid");
                continue;
            }
            CellEvidence evidence = examiner.examine(height, column, row).orElseThrow();
            int course = all.courseAt(height, column, row);
            double most = 0.0;
            for (int sensor = 0; sensor < field.sensors().size(); sensor++) {
                most = Math.max(most, field.probability(sensor, height, column, row, course));
            }
            int deciding = evidence.deciding();
            assertThat(field.probability(deciding, height, column, row, course))
                    .as("seed %d", SEED)
                    .isEqualTo(most);
            Cause cause = all.cause(height, column, row);
            assertThat(field.cause(deciding, height, column, row, course)).isEqualTo(cause);
            assertThat(words.summary()).endsWith(CoverageTable.name(cause));
            assertThat(words.deciding(evidence))
                    .contains(". '" + field.sensors().get(deciding) + "' determines the cause: probability ");
            OptionalInt kept = all.deciding(height, column, row);
            assertThat(words.deciding())
                    .startsWith(words.summary())
                    .contains(
                            kept.isEmpty()
                                    ? "."
                                    : ". '" + field.sensors().get(deciding) + "' determines the cause: probability ");
            assertIsSameMargin(words.margin(deciding), evidence.sensors().get(deciding));
            if (cause == Cause.HIDDEN_BY_BUILDING) {
                assertThat(words.deciding(evidence)).contains("hidden by a building (building.obj)");
            }
            if (cause == Cause.DETECTED) {
                assertThat(words.deciding(evidence))
                        .contains(": detected. ", "determines the cause: probability 1, ", " above its threshold of ");
                assertThat(CellWords.margin(evidence.sensors().get(deciding))).startsWith("+");
            }
        }
    }

    /** What is said at once against what is said with the evidence. */
    private static void assertIsSameMargin(String kept, GapEvidence.Examined examined) {
        double exact = examined.assessment().marginDb();
        if (kept.isEmpty() || kept.equals("no signal")) {
            assertThat(kept.isEmpty()).isNotEqualTo(exact == Double.NEGATIVE_INFINITY);
            return;
        }
        double shown = Double.parseDouble(kept.replaceAll("[<>=]+ |,| dB", ""));
        if (kept.startsWith("<")) {
            assertThat(exact).isLessThanOrEqualTo(shown);
        } else if (kept.startsWith(">")) {
            assertThat(exact).isGreaterThanOrEqualTo(shown);
        } else {
            assertThat(exact).isCloseTo(shown, within(0.11));
        }
    }

    @Test
    void aSensorThatIsTooFarNamesItsLimit() {
        int column = 30;
        int row = 5;
        CellEvidence evidence =
                new CellExaminer(all, site.stage()).examine(2, column, row).orElseThrow();
        CellWords words = new CellWords(all, site.settings(), 2, column, row);
        assertThat(words.reason(1, evidence.sensors().get(1))).isEqualTo("out of range (beyond 40 m)");
        assertThat(words.probability(1)).isEqualTo("0");
        assertThat(words.cause(1)).isEqualTo("out of range");
    }
}
