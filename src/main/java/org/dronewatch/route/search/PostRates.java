package org.dronewatch.route.search;

import java.util.Arrays;
import org.dronewatch.parallel.Workers;

/** The rates of a field at all posts, in all modes and directions: infinite at closed posts. Immutable. */
final class PostRates {
    private final int directions;

    /** By mode and direction, then post. */
    private final float[][] rates;

    /** Evaluates the field on the threads of the {@link Workers} that call. */
    PostRates(RouteProblem problem) {
        this.directions = problem.directions().count();
        this.rates =
                new float[problem.modes().size() * directions][problem.grid().size()];
        RouteGrid grid = problem.grid();
        LegMotion[] motions = new LegMotion[rates.length];
        Arrays.setAll(motions, i -> problem.modes()
                .get(i / directions)
                .motion(problem.directions().heading(i % directions)));
        Workers.forEach(grid.rows() * grid.levels(), row -> {
            for (int post = row * grid.columns(); post < (row + 1) * grid.columns(); post++) {
                set(problem, post, motions);
            }
        });
    }

    private void set(RouteProblem problem, int post, LegMotion... motions) {
        RouteGrid grid = problem.grid();
        if (!grid.isOpen(post)) {
            for (float[] one : rates) {
                one[post] = Float.POSITIVE_INFINITY;
            }
            return;
        }
        double x = grid.x(post);
        double y = grid.y(post);
        double z = grid.z(post);
        for (int i = 0; i < rates.length; i++) {
            double rate = problem.field().rate(x, y, z, motions[i], i / directions);
            // A post may coincide with a sensor; no leg through it is worth its price.
            rates[i][post] = rate < Float.MAX_VALUE ? (float) rate : Float.MAX_VALUE;
        }
    }

    /** The rates of all posts in one mode and direction, 1/s, infinite where a post is closed; not to be changed. */
    float[] of(int mode, int direction) {
        return rates[mode * directions + direction];
    }
}
