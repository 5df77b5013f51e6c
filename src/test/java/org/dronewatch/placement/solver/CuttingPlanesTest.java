package org.dronewatch.placement.solver;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.RowOracle;
import org.dronewatch.placement.SolverLimits;
import org.junit.jupiter.api.Test;

class CuttingPlanesTest {
    /** Rows that become known between two searches count in the second, although its layouts were tried before. */
    @Test
    void whatTheOracleLearnsElsewhereCounts() {
        List<double[]> known = new ArrayList<>();
        RowOracle oracle = new RowOracle() {
            @Override
            public List<double[]> weakest(List<Integer> chosen) {
                return List.of(new double[] {3.0, 2.0});
            }

            @Override
            public List<double[]> known() {
                return known;
            }
        };
        CuttingPlanes planes = new CuttingPlanes(
                List.of(new Candidate("A", 1.0), new Candidate("B", 1.0)),
                PlacementConditions.NONE.withBudget(1.0),
                oracle,
                new ExactSolver(),
                10.0);
        CutResult before = planes.solve(SolverLimits.NONE, round -> {}).orElseThrow();
        known.add(new double[] {1.0, 1.5});
        CutResult after = planes.solve(SolverLimits.NONE, round -> {}).orElseThrow();

        assertThat(before.result().chosen()).containsExactly(0);
        assertThat(before.result().value()).isEqualTo(3.0);
        assertThat(after.result().chosen()).containsExactly(1);
        assertThat(after.result().value()).isEqualTo(1.5);
        assertThat(after.result().bound()).isEqualTo(1.5);
        assertThat(after.rounds()).isEqualTo(2);
    }

    /** Past the first layout that is tried, a row remains in which it is worth nothing: then the search is ended. */
    @Test
    void whatGainsNothingIsNotGivenAsTheBestSoFar() {
        List<Candidate> candidates = List.of(new Candidate("A", 1.0), new Candidate("B", 1.0));
        RowOracle oracle = new RowOracle() {
            @Override
            public List<double[]> weakest(List<Integer> chosen) {
                return List.of(chosen.isEmpty() ? new double[] {3.0, 2.0} : new double[] {0.0, 0.0});
            }

            @Override
            public List<double[]> known() {
                return List.of();
            }
        };
        AtomicBoolean isStopped = new AtomicBoolean();
        SolverLimits limits = new SolverLimits(0.0, Double.POSITIVE_INFINITY, isStopped::get);
        CutResult found = new CuttingPlanes(
                        candidates, PlacementConditions.NONE.withBudget(2.0), oracle, new ExactSolver(), 10.0)
                .solve(limits, round -> isStopped.set(true))
                .orElseThrow();

        assertThat(found.rounds()).isEqualTo(1);
        assertThat(found.result().complete()).isFalse();
        assertThat(found.result().chosen()).isEmpty();
        assertThat(found.result().cost()).isZero();
        assertThat(found.result().value()).isZero();
        assertThat(found.result().bound()).isEqualTo(5.0);
    }
}
