package org.dronewatch.placement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CancellationException;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;

class SolverLimitsTest {
    /** Only a search that was not stopped can say that no layout complies with the conditions. */
    @Test
    void aStoppedSearchDoesNotBlameTheConditions() {
        SolverLimits stopped = new SolverLimits(0.0, 1.0, () -> true);

        assertThat(stopped.none(() -> new InputException("none"))).isInstanceOf(CancellationException.class);
        assertThat(SolverLimits.NONE.none(() -> new InputException("none")))
                .isInstanceOf(InputException.class)
                .hasMessage("none");
    }
}
