package org.dronewatch.analysis.cell;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.DoubleBinaryOperator;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.ProtectedArea;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.world.GroundPoint;
import org.dronewatch.world.SiteModel;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/**
 * Columns on a slope whose height is 2 x + 3 y from (0, 0) to (60, 40), with a hole from (40, 20) on, and with a tower
 * from (20, 0) to (40, 20) whose top is at 300 m.
 */
class FieldColumnsTest {
    private static final World SLOPE = World.of(World.merge(List.of(
                    sheet(0, 0, 40, 40, FieldColumnsTest::slope, true),
                    sheet(40, 0, 60, 20, FieldColumnsTest::slope, true),
                    sheet(20, 0, 40, 20, (x, y) -> -50, false),
                    sheet(20, 0, 40, 20, (x, y) -> 300, true))))
            .withModels(new TreeMap<>(Map.of(
                    0, new SiteModel("slope.obj", ModelRole.TERRAIN),
                    4, new SiteModel("tower.obj", ModelRole.BUILDING))));

    /** Three columns in two rows; in the second row, the middle one does not count, and the last is in the hole. */
    private static final FieldColumns.Plan PLAN = new FieldColumns.Plan() {
        @Override
        public double x(int column, int row) {
            return 11 + 20 * column;
        }

        @Override
        public double y(int column, int row) {
            return 9 + 20 * row;
        }

        @Override
        public double above(int level, int column, int row) {
            boolean isMissing = level == 1 && column == 0 && row == 1;
            return isMissing ? Double.NaN : (level == 0 ? 5 : 400) + column;
        }

        @Override
        public boolean isOutside(int column, int row) {
            return column == 1 && row == 1;
        }
    };

    private final FieldColumns field = new FieldColumns(SLOPE, 3, 2, 2, PLAN);

    private static double slope(double x, double y) {
        return 2 * x + 3 * y;
    }

    /** A rectangle in plan view, as two triangles. */
    private static TriangleMesh sheet(
            float west, float south, float east, float north, DoubleBinaryOperator z, boolean facesUp) {
        float[] vertices = {
            west, south, (float) z.applyAsDouble(west, south),
            east, south, (float) z.applyAsDouble(east, south),
            east, north, (float) z.applyAsDouble(east, north),
            west, north, (float) z.applyAsDouble(west, north)
        };
        return TriangleMesh.of(vertices, facesUp ? new int[] {0, 1, 2, 0, 2, 3} : new int[] {0, 2, 1, 0, 3, 2});
    }

    /** What a cell is, as one word. */
    private static String what(FieldColumns columns, int level, int column, int row) {
        boolean isOpen = columns.isOpen(level, column, row);
        boolean isInside = columns.isInside(level, column, row);
        boolean isOutside = columns.isOutside(level, column, row);
        assertThat((isOpen ? 1 : 0) + (isInside ? 1 : 0) + (isOutside ? 1 : 0)).isLessThanOrEqualTo(1);
        return isOpen ? "open" : isInside ? "inside" : isOutside ? "outside" : "nothing";
    }

    private static List<String> whatAll(FieldColumns columns, int level, int row) {
        return List.of(what(columns, level, 0, row), what(columns, level, 1, row), what(columns, level, 2, row));
    }

    @Test
    void cellsAreOpenInsideOutsideOrNothing() {
        assertThat(whatAll(field, 0, 0)).containsExactly("open", "inside", "open");
        assertThat(whatAll(field, 1, 0)).containsExactly("open", "open", "open");
        assertThat(whatAll(field, 0, 1)).containsExactly("open", "outside", "nothing");
        assertThat(whatAll(field, 1, 1)).containsExactly("nothing", "outside", "nothing");
        assertThat(field.openCount()).isEqualTo(6);
    }

    @Test
    void theGroundIsTheTerrainNotTheRoof() {
        assertThat(field.ground(0, 0)).isCloseTo(slope(11, 9), within(1e-6));
        assertThat(field.ground(1, 0)).isCloseTo(slope(31, 9), within(1e-6));
        assertThat(field.ground(2, 0)).isCloseTo(slope(51, 9), within(1e-6));
        assertThat(field.ground(0, 1)).isCloseTo(slope(11, 29), within(1e-6));
    }

    @Test
    void thereIsNoGroundInAHoleOrOutside() {
        assertThat(field.hasGround(2, 1)).as("hole").isFalse();
        assertThat(field.ground(2, 1)).isNaN();
        assertThat(field.hasGround(1, 1)).as("outside").isFalse();
        assertThat(field.ground(1, 1)).isNaN();
        assertThat(field.hasGround(0, 0)).isTrue();
        assertThat(field.hasGround(0, 1)).isTrue();
        assertThat(field.groundCount()).isEqualTo(4);
    }

    @Test
    void theMiddleOfACellIsAtItsHeightAboveTheGround() {
        assertThat(field.middle(0, 0, 1).distance(new Position(11, 29, slope(11, 29) + 5)))
                .isLessThan(1e-6);
        assertThat(field.middle(1, 2, 0).distance(new Position(51, 9, slope(51, 9) + 402)))
                .isLessThan(1e-6);
    }

    @Test
    void keepsItsNumbersOfColumnsRowsAndLevels() {
        assertThat(field.columns()).isEqualTo(3);
        assertThat(field.rows()).isEqualTo(2);
        assertThat(field.levels()).isEqualTo(2);
    }

    @Test
    void oneOfItsLevelsIsTheSameThere() {
        for (int level = 0; level < 2; level++) {
            FieldColumns one = field.at(level);

            assertThat(one.columns()).isEqualTo(3);
            assertThat(one.rows()).isEqualTo(2);
            assertThat(one.levels()).isEqualTo(1);
            assertThat(one.groundCount()).isEqualTo(4);
            assertThat(one.openCount()).isEqualTo(3);
            for (int row = 0; row < 2; row++) {
                assertThat(whatAll(one, 0, row)).isEqualTo(whatAll(field, level, row));
            }
            assertThat(one.middle(0, 2, 0)).isEqualTo(field.middle(level, 2, 0));
            assertThat(one.middle(0, 0, 0)).isEqualTo(field.middle(level, 0, 0));
        }
    }

    /** Two columns and rows, the first row in the north; the area leaves out the cell in the south-west. */
    @Test
    void theColumnsOfAGridAreThoseInItsArea() {
        AreaZone area = new AreaZone(
                "hook",
                ProtectedArea.polygon(
                        List.of(
                                new GroundPoint(0, 20),
                                new GroundPoint(20, 20),
                                new GroundPoint(20, 0),
                                new GroundPoint(40, 0),
                                new GroundPoint(40, 40),
                                new GroundPoint(0, 40)),
                        100),
                0,
                0);
        FieldGrid grid = new FieldGrid(21, 19, 40, 20, List.of(5.0, 400.0), Optional.of(area));
        FieldColumns columns = FieldColumns.of(SLOPE, grid);

        assertThat(columns.levels()).isEqualTo(2);
        assertThat(columns.openCount()).isEqualTo(5);
        assertThat(what(columns, 0, 0, 0)).isEqualTo("open");
        assertThat(what(columns, 0, 1, 0)).isEqualTo("open");
        assertThat(what(columns, 0, 0, 1)).isEqualTo("outside");
        assertThat(what(columns, 1, 0, 1)).isEqualTo("outside");
        assertThat(what(columns, 0, 1, 1)).isEqualTo("inside");
        assertThat(what(columns, 1, 1, 1)).isEqualTo("open");
        assertThat(columns.middle(1, 0, 0).distance(new Position(11, 29, slope(11, 29) + 400)))
                .isLessThan(1e-6);
        assertThat(columns.middle(0, 1, 0).distance(new Position(31, 29, slope(31, 29) + 5)))
                .isLessThan(1e-6);
    }

    @Test
    void eachColumnOfAGridMayHaveACellAtAHeightOfItsOwn() {
        FieldGrid grid = new FieldGrid(21, 19, 40, 20, List.of(77.0));
        FieldColumns columns = FieldColumns.at(SLOPE, grid, new double[] {1, Double.NaN, 3, 400});

        assertThat(columns.levels()).isEqualTo(1);
        assertThat(columns.middle(0, 0, 0).z()).isCloseTo(slope(11, 29) + 1, within(1e-6));
        assertThat(what(columns, 0, 1, 0)).isEqualTo("nothing");
        assertThat(columns.hasGround(1, 0)).isTrue();
        assertThat(columns.middle(0, 0, 1).z()).isCloseTo(slope(11, 9) + 3, within(1e-6));
        assertThat(columns.middle(0, 1, 1).z()).isCloseTo(slope(31, 9) + 400, within(1e-6));
        assertThat(what(columns, 0, 1, 1)).isEqualTo("open");
    }

    /** A table of 1 m in a room, whose ceiling faces down. */
    @Test
    void withoutTerrainTheLowestSurfaceThatFacesUpIsTheGround() {
        World room = World.of(World.merge(List.of(
                sheet(0, 0, 20, 20, (x, y) -> -1, false),
                sheet(0, 0, 20, 20, (x, y) -> 2, true),
                sheet(0, 0, 20, 20, (x, y) -> 5, false),
                sheet(0, 0, 20, 20, (x, y) -> 6, true),
                sheet(0, 0, 20, 20, (x, y) -> 12, false))));
        FieldGrid grid = new FieldGrid(10, 9, 2, 2, List.of(1.0, 3.5, 7.0, 15.0));
        FieldColumns columns = FieldColumns.of(room, grid);

        assertThat(columns.ground(0, 0)).isCloseTo(2, within(1e-6));
        assertThat(List.of(
                        what(columns, 0, 0, 0), what(columns, 1, 0, 0), what(columns, 2, 0, 0), what(columns, 3, 0, 0)))
                .containsExactly("open", "inside", "open", "open");
    }

    @Test
    void aPlanLeavesNothingOutUnlessItSaysSo() {
        FieldColumns.Plan plan = new FieldColumns.Plan() {
            @Override
            public double x(int column, int row) {
                return 11;
            }

            @Override
            public double y(int column, int row) {
                return 9;
            }

            @Override
            public double above(int level, int column, int row) {
                return 5;
            }
        };

        assertThat(what(new FieldColumns(SLOPE, 1, 1, 1, plan), 0, 0, 0)).isEqualTo("open");
    }
}
