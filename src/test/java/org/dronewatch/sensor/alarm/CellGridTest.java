package org.dronewatch.sensor.alarm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CellGridTest {
    private record Box(double[] low, double[] high) {
        double volume() {
            return (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
        }

        double overlap(Box other) {
            double volume = 1.0;
            for (int i = 0; i < 3; i++) {
                volume *= Math.max(0.0, Math.min(high[i], other.high[i]) - Math.max(low[i], other.low[i]));
            }
            return volume;
        }
    }

    private static Box box(long cell, long cells, int dimensions) {
        double[] low = {0, 0, 0};
        double[] high = {1, 1, 1};
        CellGrid.locate(cell, cells, dimensions, low);
        CellGrid.locate(cell, cells, dimensions, high);
        return new Box(low, high);
    }

    /** A law: equal volumes that do not overlap and lie in the cube fill it. */
    @ParameterizedTest
    @CsvSource({"1,3", "2,1", "3,2", "7,3", "27,3", "97,3", "128,2", "101,1"})
    void cellsAreEqualAndDoNotOverlap(int cells, int dimensions) {
        List<Box> boxes = new ArrayList<>();
        for (int cell = 0; cell < cells; cell++) {
            Box box = box(cell, cells, dimensions);
            assertThat(box.volume()).isCloseTo(1.0 / cells, within(1e-12));
            assertThat(Arrays.stream(box.low()).allMatch(x -> x >= 0.0)).isTrue();
            assertThat(Arrays.stream(box.high()).allMatch(x -> x <= 1.0 + 1e-12))
                    .isTrue();
            assertThat(boxes).allMatch(other -> other.overlap(box) < 1e-15);
            boxes.add(box);
        }
    }

    /** Counted by hand: half of the cells on either side of x, then of y, then of z. */
    @ParameterizedTest
    @CsvSource({
        "0, 2, 3, 0.25, 0.5, 0.5",
        "1, 2, 3, 0.75, 0.5, 0.5",
        "1, 4, 3, 0.25, 0.75, 0.5",
        "2, 4, 2, 0.75, 0.25, 0.5",
        "5, 8, 3, 0.75, 0.25, 0.75",
        "6, 8, 3, 0.75, 0.75, 0.25",
        "2, 8, 2, 0.125, 0.75, 0.5"
    })
    void ofEqualSidesTheFirstIsCut(long cell, long cells, int dimensions, double x, double y, double z) {
        double[] middle = {0.5, 0.5, 0.5};
        CellGrid.locate(cell, cells, dimensions, middle);
        assertThat(middle).containsExactly(x, y, z);
    }

    @Test
    void coordinatesThatAreNotDividedStayAsTheyAre() {
        double[] point = {0.25, 0.5, 0.75};
        CellGrid.locate(5, 8, 0, point);
        assertThat(point).containsExactly(0.25, 0.5, 0.75);
        CellGrid.locate(3, 4, 1, point);
        assertThat(point).containsExactly(0.8125, 0.5, 0.75);
    }

    @Test
    void soManyPlacesThatTheyAreThin() {
        Box last = box(999_999_999_999L, 1_000_000_000_000L, 3);
        assertThat(last.volume()).isCloseTo(1e-12, within(1e-15));
        assertThat(last.high()).containsExactly(new double[] {1, 1, 1}, within(1e-9));
    }
}
