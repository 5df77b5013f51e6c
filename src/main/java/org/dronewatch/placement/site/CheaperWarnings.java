package org.dronewatch.placement.site;

import java.util.List;
import java.util.Optional;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.PlacementSolver;
import org.dronewatch.placement.SolverLimits;

/** Layouts for less money that give the longest warning times. */
public final class CheaperWarnings implements CheaperLayouts<WarningPlacement> {
    private final WarningPlacement best;
    private final PlacementSolver solver;

    /**
     * The layouts of a plan.
     *
     * @param best the layout for the whole budget
     */
    public CheaperWarnings(WarningPlacement best, PlacementSolver solver) {
        this.best = best;
        this.solver = solver;
    }

    @Override
    public WarningPlacement best() {
        return best;
    }

    @Override
    public Optional<WarningPlacement> within(double budget, SolverLimits limits) {
        return solver.solve(CheaperCoverage.cheaper(best.problem(), budget), limits)
                .map(best::with);
    }

    @Override
    public WarningPlacement bounded(WarningPlacement layout, double bound) {
        PlacementResult result = layout.result();
        boolean isGreatest = layout.problem().objective().isGreatest();
        double none = isGreatest ? Math.max(result.value(), bound) : Math.min(result.value(), bound);
        return layout.with(
                new PlacementResult(result.chosen(), result.value(), none, result.cost(), result.complete()));
    }

    @Override
    public Optional<SectorGain> gain(Optional<WarningPlacement> before, WarningPlacement after) {
        List<Integer> had = before.map(cheaper -> cheaper.result().chosen()).orElseGet(() -> FrontSearch.kept(after));
        return new WarningSectors(after).gain(had, after.result().chosen());
    }
}
