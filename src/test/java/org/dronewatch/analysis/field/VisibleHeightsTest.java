package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Lowest visible heights over the boxes of a site, against segments at all heights. */
class VisibleHeightsTest {
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 380, 20, List.of(2.0, 60.0));

    @TempDir
    private Path directory;

    @Test
    void heightsAreThoseAtWhichTheBoxesEnd() throws IOException {
        FieldSite site = FieldSite.in(
                directory,
                FieldSite.ROUND + FieldSite.ROUND.replace("round", "high").replace("0, 4]", "0, 40]"));
        VisibleHeights visible = heights(site, 1);
        VisibleHeights same = heights(site, 8);
        Position low = new Position(0, 0, 4);
        Position high = new Position(0, 0, 40);
        int raised = 0;
        int never = 0;
        for (int cell = 0; cell < GRID.cells(); cell++) {
            int column = cell % GRID.columns();
            int row = cell / GRID.columns();
            boolean onHill = FieldSite.BOXES.get("terrain").contains(GRID.x(column), GRID.y(row));
            for (int sensor = 0; sensor < 2; sensor++) {
                double found = visible.height(sensor, column, row);
                assertThat(Double.compare(same.height(sensor, column, row), found))
                        .isZero();
                double ground = onHill ? 15.0 : 0.0;
                double end = Double.isNaN(found) ? 60.0 : found;
                for (double above = 0.05; above < end - 1e-3; above += 0.25) {
                    assertHidden(true, sensor == 0 ? low : high, column, row, ground + above);
                }
                if (!Double.isNaN(found)) {
                    assertHidden(false, sensor == 0 ? low : high, column, row, ground + found + 1e-3);
                    if (found > 0.01) {
                        assertHidden(true, sensor == 0 ? low : high, column, row, ground + found - 2e-3);
                    }
                }
                raised += found > 1.0 ? 1 : 0;
                never += Double.isNaN(found) ? 1 : 0;
            }
            double least = Math.min(
                    Double.isNaN(visible.height(0, column, row)) ? 99 : visible.height(0, column, row),
                    Double.isNaN(visible.height(1, column, row)) ? 99 : visible.height(1, column, row));
            assertThat(Double.compare(visible.height(column, row), least == 99 ? Double.NaN : least))
                    .isZero();
        }
        assertThat(raised).isGreaterThan(50);
        assertThat(never).as("behind the building").isPositive();
        assertThat(visible.columns()).isEqualTo(GRID.cells());
        assertThat(visible.count(0, 60.0) + visible.count(1, 60.0)).isEqualTo(2 * GRID.cells() - never);
        assertThat(visible.count(0, 2.0)).isLessThan(visible.count(1, 2.0)).isLessThan(visible.count(2.0) + 1);
    }

    private static void assertHidden(boolean expected, Position eye, int column, int row, double z) {
        Position at = new Position(GRID.x(column), GRID.y(row), z);
        boolean hidden = FieldSite.hidden(eye, at).isPresent() || z < 0.0;
        assertThat(hidden).as("%s from %s", at, eye).isEqualTo(expected);
    }

    private static VisibleHeights heights(FieldSite site, int threads) {
        try (Workers workers = new Workers(threads)) {
            return workers.call(() -> VisibleHeights.of(site.settings(), site.stage(), GRID));
        }
    }
}
