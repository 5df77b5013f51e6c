package org.dronewatch.report.coverage;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.survey.RemainingCoverage;
import org.dronewatch.report.coverage.table.CoverageTable;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A radar that rejects low radial speeds is blind to a drone that crosses its line of sight: as a map. */
class CrossingMapTest {
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 380, 20, List.of(40.0));
    private static final int GREY = 0x808080;
    private static final int PALE = 0xb9b9b9;

    @TempDir
    private Path directory;

    @Test
    void whatIsDetectedOnTheBestHeadingIsTooSlowOnTheWorst() throws IOException {
        FieldSite site = FieldSite.in(directory, FieldSite.ROUND);
        FieldCoverage worst = new FieldCoverage(site.field(GRID, 2), FieldCoverage.Choice.WORST, 0.5);
        FieldCoverage best = new FieldCoverage(worst.field(), FieldCoverage.Choice.BEST, 0.5);
        CoverageSkin crossing = new CoverageSkin(RemainingCoverage.of(worst, worst, 0));
        CoverageSkin approaching = new CoverageSkin(RemainingCoverage.of(best, best, 0));
        int seen = 0;
        int slow = 0;
        for (int cell = 0; cell < GRID.cells(); cell++) {
            int column = cell % GRID.columns();
            int row = cell / GRID.columns();
            boolean isCovered = best.isCovered(0, column, row);
            assertThat(worst.isCovered(0, column, row)).isFalse();
            boolean isSlow = CellState.of(worst, 0, column, row).cause() == Cause.TOO_SLOW;
            slow += isSlow ? 1 : 0;
            if (isCovered) {
                assertThat(isSlow).as("%d, %d", column, row).isTrue();
                seen++;
                assertThat(colour(crossing, column, row)).isEqualTo(fill(Cause.TOO_SLOW));
                assertThat(colour(approaching, column, row)).isEqualTo(fill(Cause.DETECTED));
            }
        }
        assertThat(seen).isGreaterThan(100);
        assertThat(crossing.legend())
                .extracting(CoverageSkin.LegendEntry::words)
                .contains("detected: nowhere", "too slow: " + CoverageTable.percent(slow, GRID.cells()) + " %");
        assertThat(approaching.legend())
                .extracting(CoverageSkin.LegendEntry::words)
                .contains("detected: " + CoverageTable.percent(seen, GRID.cells()) + " %");
    }

    private static int colour(CoverageSkin skin, int column, int row) {
        return skin.colour(GRID.x(column), GRID.y(row), 0, 0, GREY);
    }

    private static int fill(Cause cause) {
        return CauseFills.of(cause).at(0, 0, PALE) & 0xffffff;
    }
}
