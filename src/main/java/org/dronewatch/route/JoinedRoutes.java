package org.dronewatch.route;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.route.search.WeakestRoutes;

/**
 * Routes each of which may join another one where that is less exposed: the smoothing may end in a local minimum from
 * one sector, but not from another.
 */
final class JoinedRoutes {
    private JoinedRoutes() {}

    /**
     * The routes after they have joined others.
     *
     * @param search in whose exposure they are compared
     * @param routes as found by it
     * @param starts gives the nodes at which a route may begin instead
     * @param isAllowed whether a route may replace the one that has joined another
     * @return as many, in the same order
     */
    static List<WeakestRoute> of(
            WeakestRoutes search,
            List<WeakestRoute> routes,
            Function<WeakestRoute, BitSet> starts,
            Predicate<WeakestRoute> isAllowed) {
        List<WeakestRoute> joined = new ArrayList<>(routes);
        List<WeakestRoute> detours =
                search.withDetours(routes, routes.stream().map(starts).toList());
        for (int i = 0; i < routes.size(); i++) {
            if (isAllowed.test(detours.get(i))) {
                joined.set(i, detours.get(i));
            }
        }
        List<Integer> leastFirst = IntStream.range(0, routes.size())
                .boxed()
                .sorted(Comparator.comparingDouble(i -> joined.get(i).exposure()))
                .toList();
        for (int own : leastFirst) {
            double exposure = joined.get(own).exposure();
            List<WeakestRoute> others =
                    joined.stream().filter(one -> one.exposure() < exposure).toList();
            WeakestRoute better = search.joined(joined.get(own), others);
            if (isAllowed.test(better)) {
                joined.set(own, better);
            }
        }
        return joined;
    }
}
