package org.dronewatch.placement.site;

import java.util.List;
import java.util.Optional;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementSolver;
import org.dronewatch.placement.SolverLimits;

/** Layouts for less money that cover the most airspace. */
public final class CheaperCoverage implements CheaperLayouts<SitePlacement> {
    private final SitePlacement best;
    private final AirSectors sectors;
    private final PlacementSolver solver;

    /**
     * The layouts of a plan.
     *
     * @param best the layout for the whole budget
     * @param cells the cells in which the candidates were assessed
     */
    public CheaperCoverage(SitePlacement best, CoveredCells cells, PlacementSolver solver) {
        this.best = best;
        this.sectors = new AirSectors(cells);
        this.solver = solver;
    }

    @Override
    public SitePlacement best() {
        return best;
    }

    @Override
    public Optional<SitePlacement> within(double budget, SolverLimits limits) {
        return solver.solve(cheaper(best.problem(), budget), limits).map(best::with);
    }

    /** A problem with another budget. */
    static PlacementProblem cheaper(PlacementProblem problem, double budget) {
        PlacementConditions conditions = problem.conditions().withBudget(budget);
        return new PlacementProblem(problem.table(), problem.objective(), conditions);
    }

    @Override
    public SitePlacement bounded(SitePlacement layout, double bound) {
        return layout.within(bound);
    }

    @Override
    public Optional<SectorGain> gain(Optional<SitePlacement> before, SitePlacement after) {
        List<Integer> had = before.map(cheaper -> cheaper.result().chosen()).orElseGet(() -> FrontSearch.kept(after));
        return sectors.gain(after.problem(), had, after.result().chosen());
    }
}
