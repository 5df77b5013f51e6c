package org.dronewatch.placement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.CancellationException;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;

class SolverLimitsTest {
    private static final RuntimeException IMPOSSIBLE = new InputException("none");

    /** Only a search that was not stopped can say that no layout complies with the conditions. */
    @Test
    void aStoppedSearchDoesNotBlameTheConditions() {
        SolverLimits stopped = new SolverLimits(0.0, 1.0, () -> true);

        assertThat(stopped.none(() -> IMPOSSIBLE)).isInstanceOf(CancellationException.class);
        assertThat(SolverLimits.NONE.none(() -> IMPOSSIBLE)).isSameAs(IMPOSSIBLE);
    }

    /** Nor can one whose time is over. */
    @Test
    void aSearchOutOfTimeDoesNotKnow() {
        SolverLimits limits = new SolverLimits(0.0, 1e-9, () -> false);

        assertThat(limits.none(() -> IMPOSSIBLE)).isSameAs(IMPOSSIBLE);
        limits.end().begin();
        while (!limits.end().isTimeOver()) {
            Thread.onSpinWait();
        }
        assertThat(limits.none(() -> IMPOSSIBLE))
                .isInstanceOf(InputException.class)
                .hasMessageStartingWith("time limit ")
                .hasMessageContaining("not known")
                .message()
                .doesNotContain("\n");
    }

    /** The time begins with the first search, and copies with another gap share it. */
    @Test
    void copiesShareTheTime() {
        SolverLimits limits = new SolverLimits(0.0, 1e-9, () -> false);
        SolverLimits rough = limits.withGap(0.5);
        assertThat(limits.end().isDue()).isFalse();

        rough.end().begin();
        while (!rough.end().isTimeOver()) {
            Thread.onSpinWait();
        }
        limits.end().begin();
        assertThat(limits.end().isDue()).isTrue();
        assertThat(limits.end().isStopped()).isFalse();
        assertThat(limits.end().isGraceOver()).isFalse();
    }

    @Test
    void refusesWhatIsNoLimit() {
        for (double bad : new double[] {0.0, -1.0, Double.NaN}) {
            assertThatThrownBy(() -> new SolverLimits(0.0, bad, () -> false))
                    .hasMessage("time limit " + bad + " s: must be above 0");
        }
        for (double bad : new double[] {-0.1, 1.1, Double.NaN}) {
            assertThatThrownBy(() -> SolverLimits.NONE.withGap(bad)).hasMessage("gap " + bad + ": must be 0 to 1");
        }
    }
}
