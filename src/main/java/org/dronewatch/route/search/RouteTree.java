package org.dronewatch.route.search;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import org.dronewatch.geometry.Position;

/** The least exposed routes over the nodes of a grid, from every node to the goals. Immutable and thread-safe. */
public final class RouteTree {
    private final RouteProblem problem;

    /** By mode, heading and node. */
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

    /** The least exposure from a node to the goals; infinite where no route leads from the node to a goal. */
    public double cost(int node) {
        return cost[state(node)];
    }

    /** The best state of a route that begins at a node. */
    private int state(int node) {
        int best = node;
        for (int heading = 1; heading < problem.headings(); heading++) {
            int state = heading * problem.grid().size() + node;
            best = cost[state] < cost[best] ? state : best;
        }
        return best;
    }

    /** The ones among some nodes from which the exposure is least, the least first; only nodes that have a route. */
    List<Integer> weakest(BitSet nodes, int count) {
        return nodes.stream()
                .filter(node -> cost(node) < Double.POSITIVE_INFINITY)
                .boxed()
                .sorted(Comparator.comparingDouble(this::cost))
                .limit(count)
                .toList();
    }

    /** The states from a node to the end. */
    List<Integer> states(int node) {
        return from(state(node));
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
            int node = states.get(i) % grid.size();
            boolean isLeft = i + 1 < states.size() && states.get(i + 1) % grid.size() != node;
            if (isLeft || i + 1 == states.size()) {
                points.add(grid.position(node));
            }
            if (isLeft) {
                modes.add(states.get(i) / modeSize);
            }
        }
        return new RoutePath(points, modes);
    }
}
