package org.dronewatch.placement.route;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronewatch.parallel.Workers;
import org.dronewatch.placement.RowOracle;
import org.dronewatch.route.LayoutRoutes;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.setting.InputException;

/** The weakest route from each direction past a layout, by its exposure to each candidate. */
final class RouteRows implements RowOracle {
    private final LayoutRoutes routes;
    private final List<String> candidates;

    /** By the names of the sensors: the routes past them, the weakest first. */
    private final Map<Set<String>, List<DirectedRoute>> known = new HashMap<>();

    /**
     * The routes of a site.
     *
     * @param candidates their names
     */
    RouteRows(LayoutRoutes routes, List<String> candidates) {
        this.routes = routes;
        this.candidates = List.copyOf(candidates);
    }

    @Override
    public List<double[]> weakest(List<Integer> chosen) {
        Set<String> names = names(chosen);
        SiteRoutes past = routes.past(List.copyOf(names));
        List<DirectedRoute> found = fromAllDirections(past);
        List<double[]> rows = new ArrayList<>();
        for (DirectedRoute one : found) {
            Workers.checkInterrupted();
            rows.add(candidates.stream()
                    .mapToDouble(name -> Math.min(WeakestRouteSearch.ENOUGH, routes.exposure(past, one.route(), name)))
                    .toArray());
        }
        known.put(names, found);
        return rows;
    }

    private Set<String> names(List<Integer> chosen) {
        Set<String> names = new LinkedHashSet<>();
        chosen.forEach(one -> names.add(candidates.get(one)));
        return names;
    }

    /** The weakest routes past some of the sensors from each direction, the weakest of all first. */
    List<DirectedRoute> past(Set<String> names) {
        List<DirectedRoute> before = known.get(names);
        if (before != null) {
            return before;
        }
        List<DirectedRoute> found = fromAllDirections(routes.past(List.copyOf(names)));
        known.put(names, found);
        return found;
    }

    /** The same for candidates, by their numbers. */
    List<DirectedRoute> pastCandidates(List<Integer> chosen) {
        return past(names(chosen));
    }

    private static List<DirectedRoute> fromAllDirections(SiteRoutes past) {
        List<DirectedRoute> all = new ArrayList<>();
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            Workers.checkInterrupted();
            int from = sector;
            past.from(sector).ifPresent(route -> all.add(new DirectedRoute(from, route)));
        }
        if (all.isEmpty()) {
            throw new InputException("air: no route leads from the edge of the square to the protected zone");
        }
        if (all.stream().anyMatch(one -> one.route().seconds() == 0.0)) {
            throw new InputException("air.side must be larger: the protected zone reaches the edge of the square");
        }
        List<WeakestRoute> joined =
                past.joined(all.stream().map(DirectedRoute::route).toList());
        for (int i = 0; i < joined.size(); i++) {
            all.set(i, new DirectedRoute(all.get(i).sector(), joined.get(i)));
        }
        all.sort(Comparator.comparingDouble(DirectedRoute::exposure)
                .thenComparingDouble(one -> one.route().seconds()));
        return all;
    }
}
