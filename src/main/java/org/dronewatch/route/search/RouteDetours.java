package org.dronewatch.route.search;

import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import org.dronewatch.geometry.Position;

/**
 * The least exposed paths over the nodes, from anywhere, to routes that are known already and are then followed. The
 * exposure of legs over the nodes is not quite that of a smoothed route, and smoothing improves a route only bit by
 * bit: therefore the weakest route may begin with a long detour to a route from another side, and may not be found in
 * any other way. Immutable and thread-safe.
 */
final class RouteDetours {
    private final Map<Integer, Entry> entries = new TreeMap<>();
    private final RouteTree tree;

    /**
     * Where a path joins a known route.
     *
     * @param route which of them
     * @param exposure exposure from there on
     */
    private record Entry(int route, double exposure) {}

    /**
     * A path to a known route.
     *
     * @param way over the nodes, to a node near a corner of the route
     * @param route which of the known routes
     */
    record Detour(RoutePath way, int route) {}

    /**
     * Searches.
     *
     * @param known the parts of the known routes on which exposure counts
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    RouteDetours(RouteProblem problem, List<RoutePath> known) {
        for (int route = 0; route < known.size(); route++) {
            enter(problem, route, known.get(route));
        }
        Map<Integer, Double> onwards = new TreeMap<>();
        entries.forEach((state, entry) -> onwards.put(state, entry.exposure()));
        this.tree = RouteSearch.toStates(problem, onwards);
    }

    /** Lets paths lead to the nodes nearest to the corners of a route, whatever the drone's heading is there. */
    private void enter(RouteProblem problem, int route, RoutePath path) {
        RouteExposure exposure = new RouteExposure(problem);
        int size = problem.grid().size();
        double rest = 0.0;
        for (int leg = path.modes().size() - 1; leg >= 0; leg--) {
            Position corner = path.points().get(leg);
            int mode = path.modes().get(leg);
            rest += exposure.leg(corner, path.points().get(leg + 1), mode);
            for (int heading = 0; heading < problem.headings(); heading++) {
                int state = (mode * problem.headings() + heading) * size
                        + problem.grid().nearest(corner);
                entries.merge(
                        state, new Entry(route, rest), (one, other) -> other.exposure() < one.exposure() ? other : one);
            }
        }
    }

    /** The least exposed path from some nodes to a known route; empty if there is none, or if one begins there. */
    Optional<Detour> from(BitSet starts) {
        return tree.weakest(starts, 1).stream()
                .map(tree::states)
                .filter(states -> states.size() > 1)
                .map(this::detour)
                .findFirst();
    }

    private Detour detour(List<Integer> states) {
        Entry entry = entries.get(states.get(states.size() - 1));
        return new Detour(tree.path(states), entry.route());
    }
}
