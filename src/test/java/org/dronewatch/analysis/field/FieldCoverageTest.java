package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.Gap;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.analysis.survey.RemainingCoverage;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Coverage, gaps and losses, each computed a second time from the field alone. */
class FieldCoverageTest {
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 380, 20, List.of(2.0, 12.0, 60.0));

    /** Two radars with chance in the west and in the east, and one that sees little. */
    private static final String WEST_AND_EAST =
            """
              west: {kind: radar, position: [-120, 40, 6], minRange: 1, maxRange: 400, elevationWidth: 90 deg,
                budget: {range: 120, crossSection: 0.01}, minSpeed: 3 m/s, detection: {kind: chance, pulses: 8}}
              east: {kind: radar, position: [120, -40, 6], minRange: 1, maxRange: 400, elevationWidth: 90 deg,
                budget: {range: 140, crossSection: 0.01}, notch: {kind: high-pass, halfPowerSpeed: 4 m/s},
                detection: {kind: chance, pulses: 8}}
            """;

    private static final String NEAR =
            """
              near: {kind: radar, position: [-120, 40, 6], minRange: 1, maxRange: 25, elevationWidth: 90 deg,
                budget: {range: 120, crossSection: 0.01}, minSpeed: 0 m/s}
            """;

    @TempDir
    private static Path directory;

    private static FieldSite site;
    private static DetectionField field;

    @BeforeAll
    static void assess() throws IOException {
        site = FieldSite.in(Files.createDirectory(directory.resolve("all")), WEST_AND_EAST + NEAR);
        field = site.field(GRID, 2);
    }

    private static double joint(DetectionField of, int height, int column, int row, int course) {
        double missed = 1.0;
        for (int sensor = 0; sensor < of.sensors().size(); sensor++) {
            missed *= 1.0 - of.probability(sensor, height, column, row, course);
        }
        return 1.0 - missed;
    }

    /** Radars that reject slow targets add two courses each: more than a byte can number. */
    @Test
    void aSiteMayHaveHundredsOfCourses() throws IOException {
        StringBuilder radars = new StringBuilder();
        for (int i = 0; i < 62; i++) {
            radars.append(String.format(
                    Locale.ROOT,
                    "  round-%d: {use: spotterrf-c550, position: [%d, 0, 130], aim: {azimuth: %d deg, elevation: 0 deg}}%n",
                    i,
                    i - 30,
                    6 * i));
        }
        FieldGrid grid = new FieldGrid(0.0, 0.0, 100.0, 20.0, List.of(130.0));
        DetectionField many = FieldSite.in(Files.createDirectory(directory.resolve("many")), radars.toString())
                .field(grid, 2);
        FieldCoverage worst = new FieldCoverage(many, FieldCoverage.Choice.WORST, 0.5);
        int high = 0;
        for (int cell = 0; cell < grid.cells(); cell++) {
            int column = cell % grid.columns();
            int row = cell / grid.columns();
            int course = worst.courseAt(0, column, row);
            high += course > Byte.MAX_VALUE ? 1 : 0;
            double least = IntStream.range(0, many.courses().size())
                    .mapToDouble(other -> joint(many, 0, column, row, other))
                    .min()
                    .orElseThrow();
            assertThat(joint(many, 0, column, row, course)).isEqualTo(least);
        }
        assertThat(high).isPositive();
    }

    /**
     * Where a radar misses a drone on all courses, it is too weak in all directions from the radar, not too slow in
     * some; where it detects it on others, it is too slow on the worst.
     */
    @Test
    void amongEqualCoursesTheCauseThatIsNearestToADetectionCounts() throws IOException {
        String blind =
                """
                  round: {kind: radar, position: [0, 0, 30], minRange: 1, maxRange: 900, elevationWidth: 180 deg,
                    budget: {range: 120, crossSection: 0.01}, minSpeed: 3 m/s}
                """;
        FieldGrid grid = new FieldGrid(0.0, 0.0, 500.0, 20.0, List.of(60.0));
        DetectionField all = FieldSite.in(Files.createDirectory(directory.resolve("round")), blind)
                .field(grid, 2);
        FieldCoverage worst = new FieldCoverage(all, FieldCoverage.Choice.WORST, 0.5);
        FieldCoverage best = new FieldCoverage(all, FieldCoverage.Choice.BEST, 0.5);
        for (int cell = 0; cell < grid.cells(); cell++) {
            int column = cell % grid.columns();
            int row = cell / grid.columns();
            String as = "%s, %s".formatted(grid.x(column), grid.y(row));
            if (Math.hypot(grid.x(column), grid.y(row)) < 10.0) {
                // Straight above the radar, every level flight crosses its line of sight.
                continue;
            }
            double range = Math.hypot(Math.hypot(grid.x(column), grid.y(row)), 30.0);
            if (range < 80.0) {
                assertThat(worst.cause(0, column, row)).as(as).isEqualTo(Cause.TOO_SLOW);
                assertThat(best.cause(0, column, row)).as(as).isEqualTo(Cause.DETECTED);
            } else if (range > 200.0) {
                assertThat(worst.cause(0, column, row)).as(as).isEqualTo(Cause.TOO_WEAK);
                assertThat(best.cause(0, column, row)).as(as).isEqualTo(Cause.TOO_WEAK);
            }
        }
    }

    @Test
    void theCourseThatCountsHasTheLeastOrTheGreatestJointProbability() {
        FieldCoverage worst = new FieldCoverage(field, FieldCoverage.Choice.WORST, 0.5);
        FieldCoverage best = new FieldCoverage(field, FieldCoverage.Choice.BEST, 0.5);
        int covered = 0;
        int better = 0;
        for (int cell = 0; cell < GRID.cells(); cell++) {
            int column = cell % GRID.columns();
            int row = cell / GRID.columns();
            double[] joint = IntStream.range(0, field.courses().size())
                    .mapToDouble(course -> joint(field, 1, column, row, course))
                    .toArray();
            double least = IntStream.range(0, joint.length)
                    .mapToDouble(i -> joint[i])
                    .min()
                    .orElseThrow();
            double most = IntStream.range(0, joint.length)
                    .mapToDouble(i -> joint[i])
                    .max()
                    .orElseThrow();
            assertThat(joint[worst.courseAt(1, column, row)]).isCloseTo(least, within(1e-12));
            assertThat(joint[best.courseAt(1, column, row)]).isCloseTo(most, within(1e-12));
            covered += worst.isCovered(1, column, row) ? 1 : 0;
            better += best.isCovered(1, column, row) ? 1 : 0;
        }
        assertThat(covered).isBetween(1, better - 20);
    }

    /** Against probabilities that are computed anew and not rounded; none is asked for that steps cannot tell apart. */
    @Test
    void theProbabilityAskedForHoldsToAStep() {
        int covered = 0;
        for (double asked : new double[] {0.008, 0.1, 0.5, 0.9, 0.996, 1.0}) {
            FieldCoverage coverage = new FieldCoverage(field, FieldCoverage.Choice.BEST, asked);
            for (int cell = 0; cell < GRID.cells(); cell++) {
                int column = GRID.column(cell);
                int row = GRID.row(cell);
                for (int sensor = 0; sensor < 3; sensor++) {
                    double exact = field.assess(sensor, 2, column, row, coverage.courseAt(2, column, row))
                            .orElseThrow()
                            .probability();
                    if (coverage.covers(sensor, 2, column, row)) {
                        assertThat(exact).isGreaterThanOrEqualTo(asked == 1.0 ? 1.0 : asked - 0.002);
                        covered++;
                    } else {
                        assertThat(exact).isLessThan(asked == 1.0 ? 1.0 : asked + 0.004);
                    }
                }
            }
        }
        assertThat(covered).isBetween(100, 3 * 6 * GRID.cells() - 100);
        for (double asked : new double[] {-1, 0, 0.001, 0.0079, 0.9961, 0.999, 1.001, Double.NaN}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> new FieldCoverage(field, FieldCoverage.Choice.WORST, asked))
                    .withMessageContaining("must be 0.008 to 0.996, or 1");
        }
    }

    /** Row by row from the north-west, each cell once. */
    @Test
    void cellsAreVisitedInTheOrderOfTheirNumbers() {
        FieldGrid grid = new FieldGrid(0, 0, 50, 10, List.of(10.0));
        List<Integer> numbers = new ArrayList<>();
        grid.forEachCell((column, row) -> {
            int cell = grid.cell(column, row);
            assertThat(grid.column(cell)).isEqualTo(column);
            assertThat(grid.row(cell)).isEqualTo(row);
            numbers.add(cell);
        });
        assertThat(numbers)
                .containsExactlyElementsOf(
                        IntStream.range(0, grid.cells()).boxed().toList());
        assertThat(grid.count((column, row) -> column == 2 || row == 4)).isEqualTo(9);
    }

    /** Highest probability, then the cause nearest to a detection; a sensor covers from its own probability on. */
    @Test
    void causeAndCountAreThoseOfTheSensorsOnThatCourse() {
        FieldCoverage coverage = new FieldCoverage(field, FieldCoverage.Choice.WORST, 0.3);
        for (int height = 0; height < GRID.heights().size(); height++) {
            for (int cell = 0; cell < GRID.cells(); cell++) {
                int at = height;
                int column = cell % GRID.columns();
                int row = cell / GRID.columns();
                if (!field.isOpen(height, column, row)) {
                    assertThat(coverage.isKnown(height, column, row)).isFalse();
                    continue;
                }
                int course = coverage.courseAt(height, column, row);
                int dominant = IntStream.range(0, 3)
                        .boxed()
                        .max(Comparator.comparing(
                                        (Integer sensor) -> field.probability(sensor, at, column, row, course))
                                .thenComparing(sensor -> field.cause(sensor, at, column, row, course)))
                        .orElseThrow();
                assertThat(coverage.cause(height, column, row))
                        .isEqualTo(field.cause(dominant, height, column, row, course));
                assertThat(coverage.count(height, column, row)).isEqualTo((int) IntStream.range(0, 3)
                        .filter(sensor -> field.probability(sensor, at, column, row, course) >= 0.3)
                        .count());
            }
        }
    }

    /** Cells, shares and losses against the scenes without one of the sensors, computed anew. */
    @Test
    void whatIsLostWithoutASensorIsTheDifferenceToASceneWithoutIt() throws IOException {
        FieldSummary all = FieldSummary.of(field, FieldCoverage.Choice.WORST, 0.5);
        FieldSite rest = FieldSite.in(Files.createDirectory(directory.resolve("rest")), WEST_AND_EAST);
        FieldSummary without = FieldSummary.of(rest.field(GRID, 2), FieldCoverage.Choice.WORST, 0.5);
        for (int height = 0; height < GRID.heights().size(); height++) {
            HeightSummary one = all.heights().get(height);
            assertThat(one.lost().get("near"))
                    .isEqualTo(one.covered() - without.heights().get(height).covered());
            assertThat(one.causes().values().stream()
                            .mapToInt(Integer::intValue)
                            .sum())
                    .isEqualTo(one.known());
            assertThat(IntStream.of(one.counts()).sum()).isEqualTo(one.known());
            assertThat(one.known() - one.counts()[0]).isEqualTo(one.covered());
            assertThat(one.known() + one.inside()).as("all ground is known").isEqualTo(GRID.cells());
        }
        assertThat(all.heights().get(0).lost().get("near")).isPositive();
        assertThat(all.heights().get(0).inside()).isPositive();
        assertThat(FieldSummary.of(field, FieldCoverage.Choice.BEST, 0.5).idleSensors())
                .as("it sees only what the western radar sees, too")
                .containsExactly("near");
        double volume =
                all.heights().stream().mapToDouble(HeightSummary::volume).sum();
        assertThat(volume).isLessThan(380 * 380 * 60).isPositive();
    }

    /** A second sensor at the same place with the same range adds nothing. */
    @Test
    void aSensorThatAddsNothingIsIdle() throws IOException {
        String twice = NEAR + NEAR.replace("near", "again");
        FieldSite two = FieldSite.in(Files.createDirectory(directory.resolve("twice")), twice);
        FieldSummary summary = FieldSummary.of(two.field(GRID, 2), FieldCoverage.Choice.WORST, 0.5);
        assertThat(summary.heights().get(0).covered()).isPositive();
        assertThat(summary.idleSensors()).containsExactly("near", "again");
    }

    /**
     * Four weak radars in the south decide on the worst course of a cell; without one of the two in the west, it is the
     * course across the south, on which the other one covers the cell. What is gained cancels what is lost elsewhere.
     */
    @Test
    void aSensorWithoutWhichOtherCellsAreCoveredIsNotIdle() throws IOException {
        String radar =
                """
                  %s: {kind: radar, position: [%d, %d, 6], minRange: 1, maxRange: 400, elevationWidth: 90 deg, minSpeed: 3 m/s,
                    budget: {range: %d, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
                """;
        StringBuilder radars = new StringBuilder();
        for (int i = 1; i <= 4; i++) {
            radars.append(radar.formatted("south" + i, 0, -120, 120));
        }
        radars.append(radar.formatted("west", -120, 0, 120)).append(radar.formatted("stronger", -121, 0, 160));
        FieldSite two = FieldSite.in(Files.createDirectory(directory.resolve("cancel")), radars.toString());
        FieldGrid fine = new FieldGrid(0.7, 0.3, 380, 10, List.of(60.0));
        List<Course> moving =
                Course.all(two.settings().enabledSensors(), DetectionField.droneOf(two.stage(), FieldSite.DRONE))
                        .stream()
                        .filter(course -> course.kind() != Course.Kind.HOVER)
                        .toList();
        DetectionField its =
                FieldAssessment.of(two.settings(), two.stage(), FieldSite.DRONE, fine, moving, cells -> {});
        FieldSummary summary = FieldSummary.of(its, FieldCoverage.Choice.WORST, 0.5);
        FieldCoverage rest = summary.coverage().without(List.of("west"));
        int gone = 0;
        int gained = 0;
        for (int cell = 0; cell < fine.cells(); cell++) {
            boolean isCovered = summary.coverage().isCovered(0, cell % fine.columns(), cell / fine.columns());
            boolean isStill = rest.isCovered(0, cell % fine.columns(), cell / fine.columns());
            gone += isCovered && !isStill ? 1 : 0;
            gained += !isCovered && isStill ? 1 : 0;
        }
        assertThat(gained).isPositive().isEqualTo(gone);
        RemainingCoverage remaining = RemainingCoverage.of(summary.coverage(), rest, 0);
        assertThat(remaining.gone()).isEqualTo(gone);
        assertThat(remaining.gained()).isEqualTo(gained);
        HeightSummary height = summary.heights().get(0);
        assertThat(height.lost().get("west")).isZero();
        assertThat(height.changed().get("west")).isEqualTo(gone + gained);
        assertThat(summary.idleSensors()).doesNotContain("west");
    }

    @Test
    void whereNothingIsCoveredNoSensorIsCalledIdle() throws IOException {
        FieldSite blind = FieldSite.in(
                Files.createDirectory(directory.resolve("blind")), NEAR.replace("maxRange: 25", "maxRange: 2"));
        FieldSummary summary = FieldSummary.of(blind.field(GRID, 2), FieldCoverage.Choice.WORST, 0.5);
        assertThat(summary.heights()).allMatch(height -> height.covered() == 0);
        assertThat(summary.idleSensors()).isEmpty();
    }

    /** The largest gap by another flood. */
    @Test
    void theLargestGapIsThatOfAFlood() {
        for (FieldCoverage.Choice choice : FieldCoverage.Choice.values()) {
            FieldCoverage coverage = new FieldCoverage(field, choice, 0.5);
            for (int height = 0; height < GRID.heights().size(); height++) {
                Set<Integer> expected = largest(coverage, height);
                Optional<Gap> gap = Gap.largest(coverage, height);
                assertThat(gap.map(Gap::cells).orElse(0)).isEqualTo(expected.size());
                if (gap.isPresent()) {
                    int column = (int) Math.round((gap.get().x() - GRID.x(0)) / GRID.cell());
                    int row = (int) Math.round((GRID.y(0) - gap.get().y()) / GRID.cell());
                    assertThat(expected).contains(row * GRID.columns() + column);
                    assertThat(gap.get().touchesRim())
                            .isEqualTo(expected.stream().anyMatch(FieldCoverageTest::isRim));
                    assertThat(gap.get().area()).isEqualTo(400.0 * expected.size());
                    assertThat(gap.get().cause()).isNotEqualTo(Cause.DETECTED);
                }
            }
        }
    }

    private static Set<Integer> largest(FieldCoverage coverage, int height) {
        Set<Integer> bare = new HashSet<>();
        for (int cell = 0; cell < GRID.cells(); cell++) {
            int column = cell % GRID.columns();
            int row = cell / GRID.columns();
            if (coverage.isKnown(height, column, row) && !coverage.isCovered(height, column, row)) {
                bare.add(cell);
            }
        }
        Set<Integer> largest = Set.of();
        while (!bare.isEmpty()) {
            Set<Integer> one = new HashSet<>();
            Deque<Integer> open =
                    new ArrayDeque<>(List.of(bare.stream().min(Integer::compare).orElseThrow()));
            while (!open.isEmpty()) {
                int cell = open.pop();
                if (bare.remove(cell)) {
                    one.add(cell);
                    if (cell % GRID.columns() > 0) {
                        open.push(cell - 1);
                    }
                    if (cell % GRID.columns() < GRID.columns() - 1) {
                        open.push(cell + 1);
                    }
                    open.push(cell - GRID.columns());
                    open.push(cell + GRID.columns());
                }
            }
            largest = one.size() > largest.size() ? one : largest;
        }
        return largest;
    }

    private static boolean isRim(int cell) {
        int column = cell % GRID.columns();
        int row = cell / GRID.columns();
        return column == 0 || row == 0 || column == GRID.columns() - 1 || row == GRID.columns() - 1;
    }

    @Test
    void theGridChecksItsLimits() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new FieldGrid(0, 0, 100, 10, List.of()))
                .withMessageContaining("1 to 50");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new FieldGrid(0, 0, 100, 10, List.of(10.0, 10.0)))
                .withMessageContaining("ascending");
        assertThatIllegalArgumentException()
                .as("maps of both would have the same name")
                .isThrownBy(() -> new FieldGrid(0, 0, 100, 10, List.of(10.0, 10.0000001)))
                .withMessageContaining("1 mm");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new FieldGrid(0, 0, 100, 10, List.of(1e-7)))
                .withMessageContaining("1 mm");
        assertThat(new FieldGrid(0, 0, 100, 10, List.of(0.001, 0.002, 10.0, 10.001)).heights())
                .hasSize(4);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> FieldGrid.square(0, 0, 10, 100, List.of(10.0)))
                .withMessage("a cell of 100.0 m is longer than the side of the area, 10.0 m");
        assertThat(FieldGrid.square(0, 0, 10, 10, List.of(10.0)).columns()).isOne();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new FieldGrid(0, 0, 100, 10, List.of(Double.NaN)))
                .withMessageContaining("NaN");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new FieldGrid(0, 0, 10_000, 1, List.of(10.0)))
                .withMessageContaining("10000 cells");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new FieldCoverage(field, FieldCoverage.Choice.WORST, 0.0))
                .withMessageContaining("must be 0.008 to 0.996, or 1");
        FieldGrid one = new FieldGrid(5, 6, 1, 10, List.of(10.0, 30.0, 60.0));
        assertThat(one.columns()).isEqualTo(1);
        assertThat(one.x(0)).isEqualTo(5);
        assertThat(one.y(0)).isEqualTo(6);
        assertThat(new double[] {one.depth(0), one.depth(1), one.depth(2)}).containsExactly(20, 25, 15);
    }
}
