package org.dronewatch.placement;

import java.util.Optional;

/** Finds the best layout of a problem. */
@FunctionalInterface
public interface PlacementSolver {
    /**
     * The best layout that the solver finds within the limits; empty if no layout complies with the conditions, or none
     * was found before the search ended.
     */
    Optional<PlacementResult> solve(PlacementProblem problem, SolverLimits limits);
}
