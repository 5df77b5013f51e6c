package org.dronewatch.placement.route;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.LayoutRoutes;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * The weakest route from each direction past any layout, in the scene as it is or under one of the conditions of a
 * plan, and the exposures along these routes. Not thread-safe.
 */
final class SceneRoutes {
    /** The weakest first; among equals, the fastest. */
    static final Comparator<DirectedRoute> WEAKEST_FIRST = Comparator.comparingDouble(DirectedRoute::exposure)
            .thenComparingDouble(one -> one.route().seconds());

    private final Optional<String> condition;
    private final LayoutRoutes routes;
    private final Set<String> disabled;

    /** By the names of the sensors: the routes past them, the weakest first. */
    private final Map<Set<String>, List<DirectedRoute>> known = new HashMap<>();

    /** By route that layouts have been compared on: the exposures to all candidates. */
    private final List<double[]> compared = new ArrayList<>();

    /**
     * The routes of a scene.
     *
     * @param condition name of the condition; empty for the scene as it is
     * @param disabled names of the sensors that the condition switches off: they detect nothing
     */
    SceneRoutes(Optional<String> condition, LayoutRoutes routes, Set<String> disabled) {
        this.condition = condition;
        this.routes = routes;
        this.disabled = Set.copyOf(disabled);
    }

    /** The name of the condition; empty for the scene as it is. */
    Optional<String> condition() {
        return condition;
    }

    /** The weakest routes past some of the sensors from each direction, the weakest of all first. */
    List<DirectedRoute> past(Set<String> names) {
        List<DirectedRoute> before = known.get(names);
        if (before != null) {
            return before;
        }
        List<DirectedRoute> found = fromAllDirections(site(names));
        known.put(names, found);
        return found;
    }

    private SiteRoutes site(Set<String> names) {
        return routes.past(
                names.stream().filter(name -> !disabled.contains(name)).toList());
    }

    /**
     * Searches for the weakest routes past some of the sensors, on which layouts are compared from now on.
     *
     * @param candidates names of all candidates
     * @return for each route, the exposures to all candidates
     */
    List<double[]> compared(Set<String> names, List<String> candidates) {
        SiteRoutes past = site(names);
        List<DirectedRoute> found = fromAllDirections(past);
        List<double[]> rows = new ArrayList<>();
        for (DirectedRoute one : found) {
            Workers.checkInterrupted();
            rows.add(candidates.stream()
                    .mapToDouble(name -> exposure(past, one.route(), name))
                    .toArray());
        }
        known.put(names, found);
        compared.addAll(rows);
        return rows;
    }

    private double exposure(SiteRoutes past, WeakestRoute route, String name) {
        return disabled.contains(name) ? 0.0 : Math.min(WeakestRouteSearch.ENOUGH, routes.exposure(past, route, name));
    }

    /**
     * The least exposure to some candidates on the routes past them, and on those that layouts have been compared on.
     *
     * @param chosen the candidates, by their numbers
     * @param names their names
     */
    double value(List<Integer> chosen, Set<String> names) {
        double least = Math.min(WeakestRouteSearch.ENOUGH, past(names).get(0).exposure());
        for (double[] row : compared) {
            double sum = 0.0;
            for (int one : chosen) {
                sum += row[one];
            }
            least = Math.min(least, sum);
        }
        return least;
    }

    private List<DirectedRoute> fromAllDirections(SiteRoutes past) {
        List<DirectedRoute> all = new ArrayList<>();
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            Workers.checkInterrupted();
            int from = sector;
            past.from(sector).ifPresent(route -> all.add(new DirectedRoute(from, condition, route)));
        }
        if (all.isEmpty()) {
            throw new InputException(
                    "air: no route leads from the edge of the square to the protected zone" + under(condition));
        }
        if (all.stream().anyMatch(one -> one.route().seconds() == 0.0)) {
            throw new InputException("air.side must be larger: the protected zone reaches the edge of the square");
        }
        List<WeakestRoute> joined =
                past.joined(all.stream().map(DirectedRoute::route).toList());
        for (int i = 0; i < joined.size(); i++) {
            all.set(i, new DirectedRoute(all.get(i).sector(), condition, joined.get(i)));
        }
        all.sort(WEAKEST_FIRST);
        return all;
    }

    /** {@code , under the condition 'fog'}; an empty text for the scene as it is. */
    static String under(Optional<String> condition) {
        return condition
                .map(name -> ", under the condition '" + PlainText.value(name) + "'")
                .orElse("");
    }
}
