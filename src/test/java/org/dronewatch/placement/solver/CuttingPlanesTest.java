package org.dronewatch.placement.solver;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
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
}
