package org.dronewatch.route.search;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Map;
import java.util.concurrent.CancellationException;
import org.dronewatch.parallel.Workers;

/**
 * The least exposed routes from all nodes to the goals at once: Dijkstra's algorithm, backwards from the goals. A state
 * is a node with the mode and, if the drone cannot turn on the spot, the heading of the leg that leaves the node. For a
 * single use; not thread-safe.
 */
public final class RouteSearch {
    private static final int NONE = -1;

    /** How many states are settled between two checks of the thread's interrupt status. */
    private static final int PATIENCE = 1 << 16;

    private final RouteProblem problem;
    private final RouteGrid grid;
    private final RouteEdges edges;
    private final int[] climbs;
    private final int headings;
    private final double[] cost;
    private final int[] next;
    private final LegTurns turns;

    /**
     * By mode and node, the directions of the legs that have been tried, a bit for each. What a leg costs does not
     * depend on where the drone turns at its end, and states are settled in the order of their costs: the first state
     * into which a leg can turn is the best.
     */
    private final long[] tried;

    private final RadixHeap queue = new RadixHeap();

    private RouteSearch(RouteProblem problem) {
        this.problem = problem;
        this.grid = problem.grid();
        this.edges = new RouteEdges(problem);
        this.climbs = edges.climbs();
        this.headings = problem.headings();
        this.cost = new double[problem.states()];
        this.next = new int[cost.length];
        this.turns = problem.turns();
        this.tried = new long[headings > 1 ? problem.modes().size() * grid.size() : 0];
        Arrays.fill(cost, Double.POSITIVE_INFINITY);
        Arrays.fill(next, NONE);
    }

    /**
     * Searches for the least exposed routes from all nodes to the goals.
     *
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static RouteTree toGoals(RouteProblem problem) {
        RouteSearch search = new RouteSearch(problem);
        BitSet goals = problem.goals();
        for (int state = 0; state < search.cost.length; state++) {
            if (goals.get(state % search.grid.size())) {
                search.reach(state, 0.0, NONE);
            }
        }
        return search.settleAll();
    }

    /**
     * Searches for routes to states from which other routes lead on; only what comes before them counts.
     *
     * @param onwards those other routes, of a problem with the same states
     * @param within the greatest cost of those that are taken
     */
    static RouteTree toStates(RouteProblem problem, RouteTree onwards, double within) {
        RouteSearch search = new RouteSearch(problem);
        for (int state = 0; state < search.cost.length; state++) {
            if (onwards.costOfState(state) <= within) {
                search.reach(state, 0.0, NONE);
            }
        }
        return search.settleAll();
    }

    /**
     * Searches for routes to states from which what is still to come is known.
     *
     * @param onwards for each such state, the exposure from there on
     */
    static RouteTree toStates(RouteProblem problem, Map<Integer, Double> onwards) {
        RouteSearch search = new RouteSearch(problem);
        onwards.forEach((state, exposure) -> search.reach(state, exposure, NONE));
        return search.settleAll();
    }

    private void reach(int state, double at, int then) {
        if (at < cost[state]) {
            cost[state] = at;
            next[state] = then;
            queue.add(at, state);
        }
    }

    private RouteTree settleAll() {
        int count = 0;
        while (!queue.isEmpty()) {
            int state = queue.poll();
            // A state that was reached again more cheaply is in the queue twice.
            if (queue.key() == cost[state]) {
                settle(state);
            }
            if (++count % PATIENCE == 0) {
                Workers.checkInterrupted();
            }
        }
        return new RouteTree(problem, cost, next);
    }

    private void settle(int state) {
        int node = state % grid.size();
        int heading = state / grid.size() % headings;
        int mode = state / grid.size() / headings;
        for (int earlier = 0; earlier < problem.modes().size(); earlier++) {
            if (earlier != mode && problem.mayChangeFrom(earlier)) {
                reach(state + (earlier - mode) * headings * grid.size(), cost[state], state);
            }
        }
        if (headings == 1) {
            for (int direction = 0; direction < problem.directions().count(); direction++) {
                comeFrom(state, mode, node, direction, 0);
            }
            if (edges.hasVertical()) {
                int plane = grid.columns() * grid.rows();
                comeVertically(state, mode, node, node - plane);
                comeVertically(state, mode, node, node + plane);
            }
        } else {
            int place = mode * grid.size() + node;
            long left = turns.before(heading) & ~tried[place];
            tried[place] |= left;
            for (; left != 0L; left &= left - 1L) {
                int direction = Long.numberOfTrailingZeros(left);
                comeFrom(state, mode, node, direction, direction);
            }
        }
    }

    private boolean isFree(int from, int to) {
        return problem.passage().isFree(grid.x(from), grid.y(from), grid.z(from), grid.x(to), grid.y(to), grid.z(to));
    }

    /** Tries all legs of one mode and direction that lead to a node. */
    private void comeFrom(int state, int mode, int node, int direction, int heading) {
        int column = node % grid.columns();
        int row = node / grid.columns() % grid.rows();
        int level = node / (grid.columns() * grid.rows());
        for (int climb : climbs) {
            int before = level - climb;
            if (before < 0 || before >= grid.levels()) {
                continue;
            }
            int repeats = edges.repeats(mode, direction, before, climb);
            int fromColumn = column - repeats * problem.directions().east(direction);
            int fromRow = row - repeats * problem.directions().north(direction);
            if (fromColumn < 0 || fromRow < 0 || fromColumn >= grid.columns() || fromRow >= grid.rows()) {
                continue;
            }
            int from = grid.node(fromColumn, fromRow, before);
            int earlier = (mode * headings + heading) * grid.size() + from;
            come(state, node, edges.cost(mode, direction, from, repeats, climb), earlier, from);
        }
    }

    /** Tries the vertical leg from the node below or above, if there is one. */
    private void comeVertically(int state, int mode, int node, int from) {
        if (from >= 0 && from < grid.size()) {
            come(state, node, edges.verticalCost(mode, from, node), mode * grid.size() + from, from);
        }
    }

    /** Takes a leg with this exposure if that is the least exposed route so far. */
    private void come(int state, int node, double exposure, int earlier, int from) {
        // Obstacles are looked for only where the leg would be taken.
        if (exposure < Double.POSITIVE_INFINITY && cost[state] + exposure < cost[earlier] && isFree(from, node)) {
            reach(earlier, cost[state] + exposure, state);
        }
    }
}
