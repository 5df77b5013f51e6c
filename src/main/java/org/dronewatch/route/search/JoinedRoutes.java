package org.dronewatch.route.search;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.dronewatch.parallel.Workers;

/**
 * Routes from several sides, each of which may join another one where this lowers its exposure, since smoothing may end
 * in a local minimum for the route from one side, but not for that from another. Not thread-safe.
 */
public final class JoinedRoutes {
    private final WeakestRoutes search;
    private final RouteJunction junction;
    private final List<WeakestRoute> routes;

    private JoinedRoutes(WeakestRoutes search, List<WeakestRoute> routes) {
        this.search = search;
        this.junction = new RouteJunction(search.priced());
        this.routes = new ArrayList<>(routes);
    }

    /**
     * The routes after they have joined others.
     *
     * @param search the search whose exposure is used to compare the routes
     * @param routes the routes that this search has found
     * @param starts for each route, the nodes at which it may begin instead
     * @param isAllowed whether a route that has joined another may replace the original one
     * @return one route for each given route, in the same order
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static List<WeakestRoute> of(
            WeakestRoutes search, List<WeakestRoute> routes, List<BitSet> starts, Predicate<WeakestRoute> isAllowed) {
        JoinedRoutes joined = new JoinedRoutes(search, routes);
        joined.takeDetours(starts, isAllowed);
        joined.joinNearby(isAllowed);
        return List.copyOf(joined.routes);
    }

    /** Replaces each route with a detour to any of the routes, however far away, where that is less exposed. */
    private void takeDetours(List<BitSet> starts, Predicate<WeakestRoute> isAllowed) {
        List<RoutePath> counted =
                routes.stream().map(route -> search.counted(route.path())).toList();
        RouteDetours detours = new RouteDetours(search.priced(), counted);
        WeakestRoute[] better = new WeakestRoute[routes.size()];
        Workers.forEach(better.length, i -> {
            WeakestRoute own = routes.get(i);
            better[i] = detours.from(starts.get(i))
                    .flatMap(detour -> along(detour.way(), counted.get(detour.route()), routes.get(detour.route())))
                    .map(path -> search.described(path, own.lower()))
                    .filter(route -> route.exposure() < own.exposure())
                    .filter(isAllowed)
                    .orElse(own);
        });
        for (int i = 0; i < better.length; i++) {
            routes.set(i, better[i]);
        }
    }

    /** A path that joins a route at a corner nearby, and leads on along it, first along the part that counts. */
    private Optional<RoutePath> along(RoutePath way, RoutePath counted, WeakestRoute route) {
        return junction.best(way, counted, Double.POSITIVE_INFINITY)
                .map(path -> search.whole(path, route.path().after(counted)));
    }

    /** Lets each route, the least exposed first, leave its course for that of less exposed ones nearby. */
    private void joinNearby(Predicate<WeakestRoute> isAllowed) {
        List<Integer> leastFirst = IntStream.range(0, routes.size())
                .boxed()
                .sorted(Comparator.comparingDouble(i -> routes.get(i).exposure()))
                .toList();
        for (int own : leastFirst) {
            WeakestRoute better = joinedNearby(routes.get(own));
            routes.set(own, isAllowed.test(better) ? better : routes.get(own));
        }
    }

    /** The least exposed of a route and those that begin like it, but then join a less exposed one. */
    private WeakestRoute joinedNearby(WeakestRoute own) {
        RoutePath counted = search.counted(own.path());
        Optional<RoutePath> head = Optional.empty();
        RoutePath rest = own.path();
        for (WeakestRoute other : routes) {
            if (other.exposure() < own.exposure()) {
                RoutePath before = search.counted(other.path());
                Optional<RoutePath> better = junction.best(head.orElse(counted), before);
                if (better.isPresent()) {
                    head = better;
                    rest = other.path().after(before);
                }
            }
        }
        RoutePath last = rest;
        return head.map(path -> search.described(search.whole(path, last), own.lower()))
                .filter(route -> route.exposure() < own.exposure())
                .orElse(own);
    }
}
