package org.dronewatch.route.search;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import org.dronewatch.geometry.Position;

/** The least exposed routes over the posts of a grid, from every post to the goals. Immutable and thread-safe. */
final class RouteTree {
    private final RouteProblem problem;

    /** By mode, heading and post. */
    private final double[] cost;

    /** The state that follows; -1 at the end. */
    private final int[] next;

    RouteTree(RouteProblem problem, double[] cost, int[] next) {
        this.problem = problem;
        this.cost = cost;
        this.next = next;
    }

    /** The least exposure from a state to the goals; infinite where no route leads there. */
    double costOfState(int state) {
        return cost[state];
    }

    /** The least exposure from a post to the goals; infinite where no route leads there. */
    double cost(int post) {
        return cost[state(post)];
    }

    /** The best state of a route that begins at a post. */
    private int state(int post) {
        int best = post;
        for (int heading = 1; heading < problem.headings(); heading++) {
            int state = heading * problem.grid().size() + post;
            best = cost[state] < cost[best] ? state : best;
        }
        return best;
    }

    /** The ones among some posts from which the exposure is least, the least first; only posts that have a route. */
    List<Integer> weakest(BitSet posts, int count) {
        return posts.stream()
                .filter(post -> cost(post) < Double.POSITIVE_INFINITY)
                .boxed()
                .sorted(Comparator.comparingDouble(this::cost))
                .limit(count)
                .toList();
    }

    /** The states from a post to the end. */
    List<Integer> states(int post) {
        return from(state(post));
    }

    /** The states from a state to the end. */
    List<Integer> from(int first) {
        List<Integer> states = new ArrayList<>();
        for (int state = first; state >= 0; state = next[state]) {
            states.add(state);
        }
        return states;
    }

    /** The path through some states, without those in which only the mode changes. */
    RoutePath path(List<Integer> states) {
        RouteGrid grid = problem.grid();
        int modeSize = problem.headings() * grid.size();
        List<Position> points = new ArrayList<>();
        List<Integer> modes = new ArrayList<>();
        for (int i = 0; i < states.size(); i++) {
            int post = states.get(i) % grid.size();
            boolean isLeft = i + 1 < states.size() && states.get(i + 1) % grid.size() != post;
            if (isLeft || i + 1 == states.size()) {
                points.add(grid.position(post));
            }
            if (isLeft) {
                modes.add(states.get(i) / modeSize);
            }
        }
        return new RoutePath(points, modes);
    }
}
