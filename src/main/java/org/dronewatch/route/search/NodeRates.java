package org.dronewatch.route.search;

import java.util.Arrays;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.exposure.LegMotion;

/** The rates of a field at all nodes, in all modes and directions: infinite at blocked nodes. Immutable. */
final class NodeRates {
    private final int directions;

    /** By mode and direction, then node. */
    private final float[][] rates;

    /** Evaluates the field on the {@link Workers} of the calling thread. */
    NodeRates(RouteProblem problem) {
        this.directions = problem.directions().count();
        this.rates =
                new float[problem.modes().size() * directions][problem.grid().size()];
        RouteGrid grid = problem.grid();
        LegMotion[] motions = new LegMotion[rates.length];
        Arrays.setAll(motions, i -> problem.modes()
                .get(i / directions)
                .motion(problem.directions().heading(i % directions)));
        Workers.forEach(grid.rows() * grid.levels(), row -> {
            for (int node = row * grid.columns(); node < (row + 1) * grid.columns(); node++) {
                set(problem, node, motions);
            }
        });
    }

    private void set(RouteProblem problem, int node, LegMotion... motions) {
        RouteGrid grid = problem.grid();
        if (!grid.isOpen(node)) {
            for (float[] one : rates) {
                one[node] = Float.POSITIVE_INFINITY;
            }
            return;
        }
        double x = grid.x(node);
        double y = grid.y(node);
        double z = grid.z(node);
        for (int i = 0; i < rates.length; i++) {
            double rate = problem.field().rate(x, y, z, motions[i], i / directions);
            // A node may coincide with a sensor; no leg through it is worth its price.
            rates[i][node] = rate < Float.MAX_VALUE ? (float) rate : Float.MAX_VALUE;
        }
    }

    /** The rates of all nodes in one mode and direction, 1/s, infinite where a node is closed; not to be changed. */
    float[] of(int mode, int direction) {
        return rates[mode * directions + direction];
    }
}
