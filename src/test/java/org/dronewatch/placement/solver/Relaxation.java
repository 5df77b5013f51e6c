package org.dronewatch.placement.solver;

import java.util.OptionalDouble;
import org.dronewatch.placement.PlacementProblem;

/** The bound of the relaxation of a problem, in which candidates may be chosen in part. */
public final class Relaxation {
    private static final int STEPS = 2000;

    private Relaxation() {}

    /** The bound before anything is decided. */
    public static double of(PlacementProblem problem) {
        Gains gains = new Gains(problem);
        Rules rules = new Rules(problem);
        Incumbent none = new Incumbent(gains, rules, OptionalDouble.empty());
        Dual dual = Dual.of(gains, rules);
        return new Subgradient(dual, none, new Cutoff(gains, none, 0.0), chosen -> {}, () -> false)
                .lowest(dual.start(new int[0]), new byte[rules.size], STEPS);
    }
}
