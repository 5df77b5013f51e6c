package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Path2D;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.Gap;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.ProtectedArea;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.world.GroundPoint;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A grid over a protected area against one over everything, with the area as Java's own geometry sees it. */
class FieldAreaTest {
    /** Not convex: its notch holds the building. */
    private static final String ZONES =
            """
            alert:
              protect: {centre: [40, -30, 0], radius: 37}
              zones:
                hook: {area: [[-118.3, 7.1], [31.7, 141.2], [96.4, 12.6], [22.2, 47.9]], height: 50}
            """;

    private static final List<Double> HEIGHTS = List.of(2.0, 26.0);
    private static final double CELL = 7.0;

    @TempDir
    private static Path directory;

    private static FieldSite site;
    private static FieldGrid grid;
    private static FieldCoverage inArea;
    private static Path2D hook;

    @BeforeAll
    static void assess() throws IOException {
        site = FieldSite.in(directory, FieldSite.ROUND + ZONES);
        grid = FieldGrid.over(area("hook"), CELL, HEIGHTS);
        inArea = new FieldCoverage(site.field(grid, 2), FieldCoverage.Choice.BEST, 0.5);
        hook = new Path2D.Double();
        hook.moveTo(-118.3, 7.1);
        hook.lineTo(31.7, 141.2);
        hook.lineTo(96.4, 12.6);
        hook.lineTo(22.2, 47.9);
        hook.closePath();
    }

    private static AreaZone area(String name) {
        return AreaZone.inPlan(name, site.settings().alert()).orElseThrow();
    }

    @Test
    void theGridHoldsTheWholeAreaAndNoMore() {
        assertThat(grid.east()).isCloseTo(0.5 * (96.4 - 118.3), within(1e-9));
        assertThat(grid.north()).isCloseTo(0.5 * (141.2 + 7.1), within(1e-9));
        assertThat(grid.side()).isCloseTo(96.4 + 118.3, within(1e-9));
        int inside = 0;
        for (int cell = 0; cell < grid.cells(); cell++) {
            int column = cell % grid.columns();
            int row = cell / grid.columns();
            boolean isIn = hook.contains(grid.x(column), grid.y(row));
            assertThat(grid.isOutside(column, row)).isNotEqualTo(isIn);
            inside += isIn ? 1 : 0;
        }
        double area = 0.5 * Math.abs(twiceTheArea());
        assertThat(inside * CELL * CELL).isCloseTo(area, within(0.05 * area));
    }

    private static double twiceTheArea() {
        double[][] corners = {{-118.3, 7.1}, {31.7, 141.2}, {96.4, 12.6}, {22.2, 47.9}};
        double sum = 0.0;
        for (int i = 0; i < corners.length; i++) {
            double[] next = corners[(i + 1) % corners.length];
            sum += corners[i][0] * next[1] - next[0] * corners[i][1];
        }
        return sum;
    }

    /** The same grid without an area: its cells outside do not count, and the others are the same. */
    @Test
    void cellsInTheAreaAreThoseOfTheWholeGrid() {
        FieldGrid whole = new FieldGrid(grid.east(), grid.north(), grid.side(), grid.cell(), HEIGHTS);
        FieldCoverage all = new FieldCoverage(site.field(whole, 2), FieldCoverage.Choice.BEST, 0.5);
        FieldSummary summary = FieldSummary.of(inArea.field(), FieldCoverage.Choice.BEST, 0.5);
        for (int height = 0; height < HEIGHTS.size(); height++) {
            int known = 0;
            int covered = 0;
            int inside = 0;
            int cells = 0;
            for (int cell = 0; cell < grid.cells(); cell++) {
                int column = cell % grid.columns();
                int row = cell / grid.columns();
                if (!hook.contains(grid.x(column), grid.y(row))) {
                    assertThat(inArea.isKnown(height, column, row)).isFalse();
                    assertThat(inArea.isUnknown(height, column, row)).isFalse();
                    assertThat(inArea.isCovered(height, column, row)).isFalse();
                    continue;
                }
                assertThat(inArea.isKnown(height, column, row)).isEqualTo(all.isKnown(height, column, row));
                assertThat(inArea.isCovered(height, column, row)).isEqualTo(all.isCovered(height, column, row));
                assertThat(inArea.cause(height, column, row)).isEqualTo(all.cause(height, column, row));
                cells++;
                known += all.isKnown(height, column, row) ? 1 : 0;
                covered += all.isCovered(height, column, row) ? 1 : 0;
                inside += all.field().isInside(height, column, row) ? 1 : 0;
            }
            HeightSummary found = summary.heights().get(height);
            assertThat(found.cells()).isEqualTo(cells);
            assertThat(found.known()).isEqualTo(known);
            assertThat(found.covered()).isEqualTo(covered);
            assertThat(found.inside()).isEqualTo(inside);
            assertThat(found.unknown()).isZero();
        }
        assertThat(inArea.field().columnsWithGround())
                .isEqualTo(summary.heights().get(0).cells());
        try (Workers workers = new Workers(2)) {
            VisibleHeights visible = workers.call(() -> VisibleHeights.of(site.settings(), site.stage(), grid));
            assertThat(visible.columns()).isEqualTo(summary.heights().get(0).cells());
        }
    }

    /** A sensor that reaches nowhere leaves the whole area as one gap, which reaches the rim: that of the area. */
    @Test
    void aGapThatReachesTheRimOfTheAreaMayContinue() throws IOException {
        FieldSite blind = FieldSite.in(
                Files.createDirectory(directory.resolve("blind")),
                FieldSite.ROUND.replace("maxRange: 150", "maxRange: 2") + ZONES);
        FieldGrid round = FieldGrid.over(
                AreaZone.inPlan("protected", blind.settings().alert()).orElseThrow(), 4.0, List.of(60.0));
        FieldCoverage coverage = new FieldCoverage(blind.field(round, 1), FieldCoverage.Choice.BEST, 0.5);
        Gap gap = Gap.largest(coverage, 0).orElseThrow();
        assertThat(gap.area()).isCloseTo(Math.PI * 37 * 37, within(0.03 * Math.PI * 37 * 37));
        assertThat(gap.touchesRim()).isTrue();
        assertThat(gap.x()).isCloseTo(40.0, within(8.0));
        assertThat(gap.y()).isCloseTo(-30.0, within(8.0));
    }

    /** Flights go to the middle of the area, from beyond it. */
    @Test
    void warningsAreThoseOfTheArea() {
        InboundWarnings found;
        try (Workers workers = new Workers(2)) {
            found = workers.call(() -> InboundWarnings.of(
                    site.settings(), site.stage(), FieldSite.DRONE, grid, FieldTerms.ONE_LOOK, 0.5, cells -> {}));
        }
        Position middle = found.target();
        assertThat(middle.x()).isCloseTo((-118.3 + 31.7 + 96.4 + 22.2) / 4, within(1e-9));
        assertThat(middle.y()).isCloseTo((7.1 + 141.2 + 12.6 + 47.9) / 4, within(1e-9));
        double farthest = Math.hypot(-118.3 - middle.x(), 7.1 - middle.y());
        assertThat(found.reach()).isEqualTo(Math.ceil(farthest + 250.0));
        assertThat(found.isZone()).isTrue();
    }

    @Test
    void aZoneThatIsNotThereIsNone() {
        assertThat(AreaZone.inPlan("nowhere", site.settings().alert())).isEmpty();
        assertThat(area("protected").covers(40, -30 + 36.9)).isTrue();
        assertThat(area("protected").covers(40, -30 + 37.1)).isFalse();
        AreaZone circle = new AreaZone("c", ProtectedArea.circle(new GroundPoint(0, 0), 3, 10), 0, 0);
        assertThat(Optional.of(FieldGrid.over(circle, 1.0, HEIGHTS)).map(FieldGrid::columns))
                .contains(6);
    }
}
