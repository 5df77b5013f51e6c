package org.dronewatch.report.coverage;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.report.sheet.MapSheet;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What one layout covers and the other does not, counted cell by cell. */
class ChangeMapTest {
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 380, 20, List.of(2.0));
    private static final int GROUND = 0xb9b9b9;

    private static final String WEST =
            """
              west: {kind: radar, position: [-150, 0, 4], minRange: 1, maxRange: 90, elevationWidth: 90 deg, minSpeed: 0 m/s,
                budget: {range: 5000, crossSection: 0.01}}
            """;

    @TempDir
    private static Path directory;

    private static FieldCoverage first;
    private static FieldCoverage second;

    @BeforeAll
    static void assess() throws IOException {
        FieldCoverage both = new FieldCoverage(
                FieldSite.in(directory, FieldSite.ROUND + WEST).field(GRID, 2), FieldCoverage.Choice.BEST, 0.5);
        first = both.without(List.of("west"));
        second = both.without(List.of("round"));
    }

    /** The words of the legend by what is true of a cell. */
    private static String state(int column, int row) {
        boolean had = first.isCovered(0, column, row);
        boolean has = second.isCovered(0, column, row);
        if (!first.isKnown(0, column, row)) {
            return "inside, outside or unknown";
        }
        return had && has ? "covered before and after" : had ? "lost" : has ? "gained" : "covered by neither";
    }

    /** The colours and patterns of a period of 8 by 8 pixels. */
    private static List<Color> pixels(MapSheet.Fill fill) {
        return java.util.stream.IntStream.range(0, 64)
                .mapToObj(i -> new Color(fill.at(i % 8, i / 8, GROUND)))
                .toList();
    }

    @Test
    void cellsInOneStateLookAlikeAndOthersDoNot() {
        ChangeMap map = new ChangeMap(first, second, 0);
        Map<String, List<Color>> looks = new LinkedHashMap<>();
        for (int row = 0; row < GRID.columns(); row++) {
            for (int column = 0; column < GRID.columns(); column++) {
                List<Color> its = pixels(map.fill(column, row));
                assertThat(looks.computeIfAbsent(state(column, row), state -> its))
                        .isEqualTo(its);
            }
        }
        assertThat(looks).hasSize(5);
        assertThat(looks.values()).doesNotHaveDuplicates();
        assertThat(looks.get("covered before and after"))
                .as("as on the map of causes")
                .isEqualTo(pixels(CellState.COVERED.fill()));
        assertThat(looks.get("lost")).isEqualTo(pixels(CellState.LOST.fill()));
    }

    @Test
    void fractionsAreThoseOfTheKnownCells() {
        Map<String, Integer> counts = new LinkedHashMap<>();
        for (int cell = 0; cell < GRID.cells(); cell++) {
            counts.merge(state(cell % GRID.columns(), cell / GRID.columns()), 1, Integer::sum);
        }
        double known = GRID.cells() - counts.get("inside, outside or unknown");
        assertThat(new ChangeMap(first, second, 0).inWords())
                .isEqualTo(String.format(
                        Locale.ROOT,
                        "gained in %.1f %% of the known cells, lost in %.1f %%",
                        100 * counts.get("gained") / known,
                        100 * counts.get("lost") / known));
        assertThat(new ChangeMap(second, first, 0).inWords())
                .startsWith(String.format(Locale.ROOT, "gained in %.1f %%", 100 * counts.get("lost") / known));
        assertThat(new ChangeMap(first, first, 0).inWords())
                .isEqualTo("gained in 0.0 % of the known cells, lost in 0.0 %");
    }
}
