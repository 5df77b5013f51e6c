package org.dronewatch.analysis.survey;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** All gaps of a coverage, over all heights, and the evidence for their causes. */
class GapSpanTest {
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 340, 20, List.of(2.0, 12.0, 28.0, 60.0));

    @TempDir
    private static Path directory;

    private static FieldSite site;
    private static FieldCoverage coverage;

    @BeforeAll
    static void assess() throws IOException {
        site = FieldSite.in(directory, FieldSite.ROUND);
        coverage = new FieldCoverage(site.field(GRID, 2), FieldCoverage.Choice.BEST, 0.5);
    }

    private static boolean isBare(int height, int cell) {
        int column = cell % GRID.columns();
        int row = cell / GRID.columns();
        return coverage.isKnown(height, column, row) && !coverage.isCovered(height, column, row);
    }

    /** Every bare cell belongs to exactly one gap, and the numbers of a gap are those of its cells. */
    @Test
    void theGapsAreTheBareCells() {
        for (int height = 0; height < GRID.heights().size(); height++) {
            GapMap map = GapMap.of(coverage, height);
            Set<Integer> seen = new HashSet<>();
            for (int gap = 0; gap < map.gaps().size(); gap++) {
                int[] cells = map.cells(gap);
                assertThat(map.gaps().get(gap).cells()).isEqualTo(cells.length);
                Map<Cause, Integer> causes = new HashMap<>();
                for (int cell : cells) {
                    assertThat(isBare(height, cell)).isTrue();
                    assertThat(seen.add(cell)).as("in one gap only").isTrue();
                    causes.merge(coverage.cause(height, cell % GRID.columns(), cell / GRID.columns()), 1, Integer::sum);
                }
                assertThat(map.gaps().get(gap).causes()).isEqualTo(causes);
                assertThat(causes.get(map.gaps().get(gap).cause()))
                        .isEqualTo(causes.values().stream()
                                .max(Comparator.naturalOrder())
                                .orElseThrow());
            }
            int bare = 0;
            for (int cell = 0; cell < GRID.cells(); cell++) {
                bare += isBare(height, cell) ? 1 : 0;
            }
            assertThat(seen).hasSize(bare);
            assertThat(map.gaps()).isSortedAccordingTo(Comparator.comparingInt((Gap gap) -> -gap.cells()));
            assertThat(map.contains(0, -1, 0)).isFalse();
            assertThat(map.contains(0, GRID.columns(), 0)).isFalse();
        }
    }

    /** Joined by a search over sets of cells: there are fewer than eight gaps at each height here. */
    @Test
    void gapsAboveOneAnotherAreOne() {
        List<Set<Integer>> parts = new ArrayList<>();
        for (int height = 0; height < GRID.heights().size(); height++) {
            GapMap map = GapMap.of(coverage, height);
            assertThat(map.gaps()).hasSizeLessThan(8);
            for (int gap = 0; gap < map.gaps().size(); gap++) {
                Set<Integer> cells = new HashSet<>();
                for (int cell : map.cells(gap)) {
                    cells.add(height * GRID.cells() + cell);
                }
                parts.add(cells);
            }
        }
        int[] groups = groups(parts);
        List<GapSpan> spans = GapSpan.of(coverage);
        assertThat(spans)
                .hasSize((int) java.util.Arrays.stream(groups).distinct().count());
        assertThat(spans.size()).as("several, and some of several heights").isBetween(2, parts.size() - 1);
        for (GapSpan span : spans) {
            int part = part(parts, span);
            int lowest = Integer.MAX_VALUE;
            int highest = -1;
            int most = 0;
            for (int i = 0; i < parts.size(); i++) {
                if (groups[i] == groups[part]) {
                    int height = parts.get(i).iterator().next() / GRID.cells();
                    lowest = Math.min(lowest, height);
                    highest = Math.max(highest, height);
                    most = Math.max(most, parts.get(i).size());
                }
            }
            assertThat(span.lowest()).isEqualTo(lowest);
            assertThat(span.highest()).isEqualTo(highest);
            assertThat(span.gap().cells()).isEqualTo(most);
        }
        assertThat(spans).isSortedAccordingTo(Comparator.comparingInt((GapSpan span) -> -span.gap()
                .cells()));
    }

    private static int part(List<Set<Integer>> parts, GapSpan span) {
        int cell = GapMap.of(coverage, span.height()).cells(span.number())[0];
        for (int i = 0; i < parts.size(); i++) {
            if (parts.get(i).contains(span.height() * GRID.cells() + cell)) {
                return i;
            }
        }
        throw new AssertionError("no part");
    }

    /** Labels are spread until nothing changes. */
    private static int[] groups(List<Set<Integer>> parts) {
        int[] groups = new int[parts.size()];
        for (int i = 0; i < groups.length; i++) {
            groups[i] = i;
        }
        for (boolean changed = true; changed; ) {
            changed = false;
            for (int i = 0; i < groups.length; i++) {
                for (int k = 0; k < groups.length; k++) {
                    if (groups[k] > groups[i] && areOne(parts.get(i), parts.get(k))) {
                        groups[k] = groups[i];
                        changed = true;
                    }
                }
            }
        }
        return groups;
    }

    private static boolean areOne(Set<Integer> one, Set<Integer> other) {
        int apart =
                Math.abs(one.iterator().next() / GRID.cells() - other.iterator().next() / GRID.cells());
        if (apart != 1) {
            return false;
        }
        Set<Integer> columns = new HashSet<>();
        one.forEach(cell -> columns.add(cell % GRID.cells()));
        long shared = other.stream()
                .filter(cell -> columns.contains(cell % GRID.cells()))
                .count();
        return 2 * shared >= Math.min(one.size(), other.size());
    }

    /** Behind each box, its file is named, for any number of threads; beyond the range of the radar, its limit. */
    @Test
    void theEvidenceNamesWhatHidesTheDrone() {
        GapMap map = GapMap.of(coverage, 0);
        Set<String> named = new HashSet<>();
        for (int gap = 0; gap < map.gaps().size(); gap++) {
            List<GapEvidence> evidence = evidence(map, gap, 1);
            assertThat(evidence(map, gap, 8)).hasToString(evidence.toString());
            GapEvidence round = evidence.get(0);
            assertThat(round.sensor()).isEqualTo("round");
            assertThat(round.causes()).isEqualTo(map.gaps().get(gap).causes());
            round.causes().forEach((cause, cells) -> assertThat(round.examined())
                    .filteredOn(one -> one.assessment().cause() == cause)
                    .hasSize(Math.min(GapEvidence.MOST_SPREAD, cells)));
            for (GapEvidence.Examined one : round.examined()) {
                Cause cause = one.assessment().cause();
                assertThat(round.causes()).containsKey(cause);
                assertThat(one.blocker().isPresent()).isEqualTo(cause.isHidden());
                one.blocker().ifPresent(blocker -> {
                    assertThat("HIDDEN_BY_" + blocker.obstacle().model().role()).isEqualTo(cause.name());
                    named.add(blocker.obstacle().model().file());
                });
                if (cause == Cause.OUT_OF_RANGE) {
                    assertThat(one.assessment().limit()).hasValue(150.0);
                }
            }
        }
        assertThat(named).containsExactlyInAnyOrder("building.obj", "vegetation.obj", "other.obj", "terrain.obj");
    }

    /** The strongest and the weakest signal that the examined cells have are those of all cells of the gap. */
    @Test
    void theExtremesOfASignalThatIsTooWeakAreThoseOfTheGap() throws IOException {
        String weak =
                """
                  weak: {kind: radar, position: [20, 10, 4], minRange: 1, maxRange: 900, elevationWidth: 180 deg,
                    budget: {range: 60, crossSection: 0.01}, minSpeed: 0 m/s}
                """;
        FieldSite other = FieldSite.in(Files.createDirectory(directory.resolve("weak")), weak);
        DetectionField all = other.field(GRID, 2);
        FieldCoverage missed = new FieldCoverage(all, FieldCoverage.Choice.WORST, 0.5);
        GapMap map = GapMap.of(missed, 0);
        double[] margins = IntStream.of(map.cells(0))
                .filter(cell -> missed.cause(0, GRID.column(cell), GRID.row(cell)) == Cause.TOO_WEAK)
                .mapToDouble(cell -> all.assess(
                                0,
                                0,
                                GRID.column(cell),
                                GRID.row(cell),
                                missed.courseAt(0, GRID.column(cell), GRID.row(cell)))
                        .orElseThrow()
                        .marginDb())
                .sorted()
                .toArray();
        double[] examined;
        try (Workers workers = new Workers(2)) {
            examined = workers.call(() -> GapEvidence.of(map, 0, other.stage())).get(0).examined().stream()
                    .map(GapEvidence.Examined::assessment)
                    .filter(one -> one.cause() == Cause.TOO_WEAK)
                    .mapToDouble(Assessment::marginDb)
                    .sorted()
                    .toArray();
        }
        assertThat(margins).hasSizeGreaterThan(50);
        assertThat(examined[0]).isCloseTo(margins[0], within(0.1));
        assertThat(examined[examined.length - 1]).isCloseTo(margins[margins.length - 1], within(0.1));
    }

    /** By the slabs between the faces of the boxes; the order of causes puts too slow before hidden. */
    @Test
    void hiddenCellsAreThoseBehindTheBoxes() {
        Position radar = coverage.field().position(0);
        int checked = 0;
        for (int cell : GapMap.of(coverage, 0).cells(0)) {
            Position drone = coverage.field().middle(0, cell % GRID.columns(), cell / GRID.columns());
            Optional<Cause> hidden = FieldSite.hidden(radar, drone);
            Cause cause = coverage.cause(0, cell % GRID.columns(), cell / GRID.columns());
            if (cause.isHidden()) {
                assertThat(hidden).contains(cause);
                checked++;
            } else if (drone.distance(radar) < 145) {
                assertThat(hidden.isEmpty() || cause == Cause.TOO_SLOW).isTrue();
            }
        }
        assertThat(checked).isPositive();
    }

    private static List<GapEvidence> evidence(GapMap map, int gap, int threads) {
        try (Workers workers = new Workers(threads)) {
            return workers.call(() -> GapEvidence.of(map, gap, site.stage()));
        }
    }
}
