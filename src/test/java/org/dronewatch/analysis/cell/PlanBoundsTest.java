package org.dronewatch.analysis.cell;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.List;
import java.util.NoSuchElementException;
import org.dronewatch.world.GroundPoint;
import org.junit.jupiter.api.Test;

/** Squares around points, by hand. */
class PlanBoundsTest {
    @Test
    void theSideIsTheLongerExtent() {
        assertThat(PlanBounds.of(List.of(new GroundPoint(-10, 2), new GroundPoint(50, 8), new GroundPoint(0, 30))))
                .isEqualTo(new PlanBounds(20, 16, 60));
        assertThat(PlanBounds.of(List.of(new GroundPoint(3, 100), new GroundPoint(5, -20), new GroundPoint(4, 0))))
                .isEqualTo(new PlanBounds(4, 40, 120));
    }

    @Test
    void aPointHasASquareWithoutExtentAndNoPointHasNone() {
        assertThat(PlanBounds.of(List.of(new GroundPoint(-7, 3)))).isEqualTo(new PlanBounds(-7, 3, 0));
        assertThatExceptionOfType(NoSuchElementException.class).isThrownBy(() -> PlanBounds.of(List.of()));
    }
}
