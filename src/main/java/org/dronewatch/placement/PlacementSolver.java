package org.dronewatch.placement;

import java.util.Optional;

/** Finds the best layout of a problem. */
@FunctionalInterface
public interface PlacementSolver {
    /**
     * The best layout that it finds within its limits; empty if no layout complies with the conditions, or none was
     * found before the search was ended.
     */
    Optional<PlacementResult> solve(PlacementProblem problem, SolverLimits limits);
}
