package org.dronewatch.analysis.cell;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.ProtectedArea;
import org.dronewatch.world.GroundPoint;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Where the cells of a grid are, and which grids there may be. */
class FieldGridTest {
    private static final List<Double> HEIGHTS = List.of(10.0, 30.0, 60.0, 120.0, 150.0);

    /** Four columns of 10 m. */
    private static final FieldGrid GRID = new FieldGrid(100, -50, 40, 10, HEIGHTS);

    private static List<Double> heights(String list) {
        return Arrays.stream(list.split(" ")).map(Double::valueOf).toList();
    }

    private static List<Double> millimetres(int count) {
        return IntStream.rangeClosed(1, count).mapToObj(i -> i / 1000.0).toList();
    }

    private static AreaZone zone(ProtectedArea area) {
        return new AreaZone("a", area, 0.0, 0.0);
    }

    @ParameterizedTest
    @CsvSource({"0, 85, -35", "1, 95, -45", "2, 105, -55", "3, 115, -65"})
    void columnsAreCountedFromTheWestAndRowsFromTheNorth(int number, double x, double y) {
        assertThat(GRID.x(number)).isEqualTo(x);
        assertThat(GRID.y(number)).isEqualTo(y);
    }

    @Test
    void theMiddleOfAnOddNumberOfCellsIsThatOfACell() {
        FieldGrid grid = new FieldGrid(7, -3, 30, 10, HEIGHTS);

        assertThat(grid.x(1)).isEqualTo(7);
        assertThat(grid.y(1)).isEqualTo(-3);
    }

    @Test
    void allCellsAreVisitedRowByRowFromTheNorthWest() {
        List<Integer> visited = new ArrayList<>();
        GRID.forEachCell((column, row) -> {
            int cell = GRID.cell(column, row);
            assertThat(GRID.column(cell)).isEqualTo(column);
            assertThat(GRID.row(cell)).isEqualTo(row);
            assertThat(cell).isEqualTo(4 * row + column);
            visited.add(cell);
        });

        assertThat(visited)
                .containsExactlyElementsOf(IntStream.range(0, 16).boxed().toList());
        assertThat(GRID.cells()).isEqualTo(16);
    }

    @Test
    void cellsWithAPropertyAreCounted() {
        assertThat(GRID.count((column, row) -> column > row)).isEqualTo(6);
        assertThat(GRID.count((column, row) -> true)).isEqualTo(16);
        assertThat(GRID.count((column, row) -> false)).isZero();
    }

    @ParameterizedTest
    @CsvSource({"40, 10, 4", "44.9, 10, 4", "45.1, 10, 5", "1, 10, 1", "0.001, 100000, 1", "2000.4, 1, 2000"})
    void theSideIsRoundedToWholeCellsAndAtLeastOne(double side, double cell, int columns) {
        assertThat(new FieldGrid(0, 0, side, cell, HEIGHTS).columns()).isEqualTo(columns);
    }

    @Test
    void moreThan2000CellsAreTooMany() {
        assertThat(new FieldGrid(0, 0, 2000, 1, HEIGHTS).columns()).isEqualTo(2000);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new FieldGrid(0, 0, 2001, 1, HEIGHTS))
                .withMessage("side 2001.0 m with cells of 1.0 m gives 2001 cells along each side:"
                        + " there must be at most 2000");
    }

    @Test
    void aCellOfASquareMayBeAsLongAsItsSide() {
        assertThat(FieldGrid.square(1, 2, 10, 10, HEIGHTS)).isEqualTo(new FieldGrid(1, 2, 10, 10, HEIGHTS));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> FieldGrid.square(1, 2, 10, Math.nextUp(10.0), HEIGHTS))
                .withMessageContaining("longer than the side of the area, 10.0 m");
    }

    @Test
    void theAreaOfACellIsThatOfASquare() {
        assertThat(GRID.cellArea()).isEqualTo(100.0);
        assertThat(new FieldGrid(0, 0, 2, 0.5, HEIGHTS).cellArea()).isEqualTo(0.25);
    }

    @ParameterizedTest
    @ValueSource(strings = {"0.001", "10000", "0.001 0.002 0.003", "1000 1000.001", "9999.999 10000"})
    void heightsMayBeAMillimetreApartAndUpToTheGreatest(String list) {
        assertThat(FieldGrid.checkedHeights(heights(list))).isEqualTo(heights(list));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "0",
                "-10",
                "0.000999",
                "NaN",
                "10 10",
                "10 10.000999",
                "30 10",
                "10 30 20",
                "10000.000000000002",
                "10 20000",
                "Infinity"
            })
    void heightsThatDoNotAscendOrAreTooGreatAreRefused(String list) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> FieldGrid.checkedHeights(heights(list)))
                .withMessageContaining("heights must be in ascending order");
    }

    @Test
    void oneToFiftyHeightsAreAllowed() {
        assertThat(FieldGrid.checkedHeights(millimetres(1))).hasSize(1);
        assertThat(FieldGrid.checkedHeights(millimetres(50))).hasSize(50);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> FieldGrid.checkedHeights(millimetres(51)))
                .withMessage("51 heights: there must be 1 to 50");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> FieldGrid.checkedHeights(List.of()))
                .withMessage("0 heights: there must be 1 to 50");
    }

    @Test
    void theLowestHeightsAreKeptWithEverythingElse() {
        FieldGrid grid = FieldGrid.over(zone(ProtectedArea.circle(new GroundPoint(3, 4), 20, 50)), 5, HEIGHTS);

        assertThat(grid.lowest(2))
                .isEqualTo(new FieldGrid(
                        grid.east(), grid.north(), grid.side(), grid.cell(), List.of(10.0, 30.0), grid.area()));
        assertThat(grid.lowest(5)).isEqualTo(grid);
        assertThatIllegalArgumentException().isThrownBy(() -> grid.lowest(0));
    }

    /** From the ground to 20, 45, 90, 135 and 150 m. */
    @ParameterizedTest
    @CsvSource({"0, 20", "1, 25", "2, 45", "3, 45", "4, 15"})
    void layersMeetHalfwayBetweenHeights(int height, double depth) {
        assertThat(GRID.depth(height)).isEqualTo(depth);
    }

    @Test
    void theLayerOfASingleHeightReachesFromTheGroundToIt() {
        assertThat(new FieldGrid(0, 0, 40, 10, List.of(25.0)).depth(0)).isEqualTo(25.0);
    }

    @Test
    void aGridOverAnAreaLeavesOutCellsBesideIt() {
        AreaZone corner = zone(ProtectedArea.polygon(
                List.of(new GroundPoint(0, 0), new GroundPoint(40, 0), new GroundPoint(40, 30)), 50));
        FieldGrid grid = FieldGrid.over(corner, 10, HEIGHTS);

        assertThat(grid).isEqualTo(new FieldGrid(20, 15, 40, 10, HEIGHTS, Optional.of(corner)));
        // Up to y = 0.75 x: the middles are at x 5 to 35 and, from the north, at y 30 to 0, on the southern side.
        assertThat(grid.count((column, row) -> !grid.isOutside(column, row))).isEqualTo(0 + 1 + 3 + 4);
        assertThat(grid.isOutside(3, 0)).isTrue();
        assertThat(grid.isOutside(3, 1)).isFalse();
        assertThat(grid.isOutside(2, 1)).isTrue();
    }

    @Test
    void aGridOverACircleIsAsWideAsTheCircle() {
        FieldGrid grid = FieldGrid.over(zone(ProtectedArea.circle(new GroundPoint(-30, 70), 25, 50)), 1, HEIGHTS);

        assertThat(grid.east()).isCloseTo(-30, within(1e-9));
        assertThat(grid.north()).isCloseTo(70, within(1e-9));
        assertThat(grid.side()).isCloseTo(50, within(1e-9));
        assertThat(grid.count((column, row) -> !grid.isOutside(column, row)))
                .isCloseTo((int) (Math.PI * 25 * 25), within(40));
    }

    @Test
    void withoutAnAreaNoCellIsOutside() {
        assertThat(GRID.count(GRID::isOutside)).isZero();
    }
}
