package org.dronewatch.report.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.dronewatch.Thorough;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.algorithm.Orientation;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.operation.valid.IsValidOp;

/** Outlines of cells, by the areas and rules of JTS. */
class CellRingsTest {
    private static final GeometryFactory JTS = new GeometryFactory();

    private static Polygon polygon(List<List<int[]>> rings) {
        List<LinearRing> all = new ArrayList<>();
        for (List<int[]> ring : rings) {
            // North is up: rows count down.
            all.add(JTS.createLinearRing(ring.stream()
                    .map(corner -> new Coordinate(corner[0], -corner[1]))
                    .toArray(Coordinate[]::new)));
        }
        return JTS.createPolygon(all.get(0), all.subList(1, all.size()).toArray(LinearRing[]::new));
    }

    private static void check(Set<Integer> cells, int columns, String what) {
        List<List<int[]>> rings = CellRings.of(
                (column, row) -> column >= 0
                        && row >= 0
                        && column < columns
                        && row < columns
                        && cells.contains(row * columns + column),
                columns);
        Polygon polygon = polygon(rings);
        IsValidOp valid = new IsValidOp(polygon);
        assertThat(valid.isValid())
                .as("%s: %s", what, valid.getValidationError())
                .isTrue();
        assertThat(polygon.getArea()).as(what).isEqualTo(cells.size());
        for (int cell : cells) {
            assertThat(polygon.contains(JTS.createPoint(new Coordinate(cell % columns + 0.5, -(cell / columns) - 0.5))))
                    .as(what)
                    .isTrue();
        }
        assertThat(Orientation.isCCW(polygon.getExteriorRing().getCoordinateSequence()))
                .isTrue();
        for (int i = 0; i < polygon.getNumInteriorRing(); i++) {
            assertThat(Orientation.isCCW(polygon.getInteriorRingN(i).getCoordinateSequence()))
                    .isFalse();
        }
    }

    private static Set<Integer> component(Set<Integer> cells, int start, int columns) {
        Set<Integer> found = new HashSet<>(Set.of(start));
        Deque<Integer> open = new ArrayDeque<>(found);
        while (!open.isEmpty()) {
            int cell = open.pop();
            int column = cell % columns;
            int[] next = {
                column > 0 ? cell - 1 : -1, column < columns - 1 ? cell + 1 : -1, cell - columns, cell + columns
            };
            for (int one : next) {
                if (cells.contains(one) && found.add(one)) {
                    open.push(one);
                }
            }
        }
        return found;
    }

    /** Sets of every density, with corners at which cells or holes touch. */
    @Thorough
    @Test
    void anyConnectedCellsHaveAValidOutline() {
        long seed = 20_261_125L;
        SplittableRandom random = new SplittableRandom(seed);
        int touching = 0;
        for (int i = 0; i < 400; i++) {
            int columns = 1 + random.nextInt(14);
            double density = 0.3 + 0.65 * random.nextDouble();
            Set<Integer> cells = new HashSet<>();
            for (int cell = 0; cell < columns * columns; cell++) {
                if (random.nextDouble() < density) {
                    cells.add(cell);
                }
            }
            Set<Integer> left = new HashSet<>(cells);
            while (!left.isEmpty()) {
                Set<Integer> one = component(cells, left.iterator().next(), columns);
                left.removeAll(one);
                check(one, columns, "seed " + seed + ", set " + i);
                touching += touches(one, columns) ? 1 : 0;
            }
        }
        assertThat(touching).as("sets with cells that touch at corners only").isGreaterThan(100);
    }

    private static boolean touches(Set<Integer> cells, int columns) {
        return cells.stream()
                .anyMatch(cell -> cell % columns < columns - 1
                        && cells.contains(cell + columns + 1)
                        && !cells.contains(cell + 1)
                        && !cells.contains(cell + columns));
    }

    /** A square has a corner after every 64 cells, so that its sides follow the map. */
    @Test
    void longSidesHaveCornersOnThem() {
        int columns = 150;
        List<List<int[]>> rings =
                CellRings.of((column, row) -> column >= 0 && row >= 0 && column < columns && row < columns, columns);
        assertThat(rings).hasSize(1);
        List<int[]> ring = rings.get(0);
        assertThat(ring).hasSizeBetween(4 * 3 + 1, 4 * 3 + 2);
        for (int i = 1; i < ring.size(); i++) {
            int length = Math.abs(ring.get(i)[0] - ring.get(i - 1)[0]) + Math.abs(ring.get(i)[1] - ring.get(i - 1)[1]);
            assertThat(length).isBetween(1, 64);
        }
        assertThat(polygon(rings).getArea()).isEqualTo(150.0 * 150.0);
    }

    @Test
    void noCellsHaveNoOutline() {
        assertThat(CellRings.of((column, row) -> false, 5)).isEmpty();
    }
}
