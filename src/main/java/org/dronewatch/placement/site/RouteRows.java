package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.placement.RowOracle;
import org.dronewatch.route.LayoutRoutes;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.WeakestRoute;
import org.dronewatch.setting.InputException;

/** The weakest route from each direction past a layout, by what it is exposed to each candidate. */
final class RouteRows implements RowOracle {
    private final LayoutRoutes routes;
    private final Set<String> assessed;
    private final List<String> candidates;

    /**
     * The routes of a site.
     *
     * @param assessed names of the sensors that have been assessed
     * @param candidates their names; one that has not been assessed counts as if it detected nothing
     */
    RouteRows(LayoutRoutes routes, List<String> assessed, List<String> candidates) {
        this.routes = routes;
        this.assessed = Set.copyOf(assessed);
        this.candidates = List.copyOf(candidates);
    }

    @Override
    public List<double[]> weakest(List<Integer> chosen) {
        SiteRoutes past = past(names(chosen));
        List<double[]> rows = new ArrayList<>();
        for (WeakestRoute route : fromAllDirections(past)) {
            double[] row = new double[candidates.size()];
            for (int candidate = 0; candidate < row.length; candidate++) {
                String name = candidates.get(candidate);
                row[candidate] = assessed.contains(name)
                        ? Math.min(WeakestRouteSearch.ENOUGH, routes.exposure(past, route, name))
                        : 0.0;
            }
            rows.add(row);
        }
        return rows;
    }

    private List<String> names(List<Integer> chosen) {
        return chosen.stream().map(candidates::get).toList();
    }

    private SiteRoutes past(List<String> names) {
        return routes.past(names.stream().filter(assessed::contains).toList());
    }

    private static List<WeakestRoute> fromAllDirections(SiteRoutes past) {
        List<WeakestRoute> all = new ArrayList<>();
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            past.from(sector).ifPresent(all::add);
        }
        if (all.isEmpty()) {
            throw new InputException("air: no route leads from the edge of the square to the protected zone");
        }
        if (all.stream().anyMatch(route -> route.seconds() == 0.0)) {
            throw new InputException("air.side: the protected zone reaches the edge of the square: must be larger");
        }
        return all;
    }

    /** The weakest routes past some of the sensors from each direction, the weakest of all first. */
    List<WeakestRoute> past(Set<String> names) {
        return fromAllDirections(past(List.copyOf(names))).stream()
                .sorted(Comparator.comparingDouble(WeakestRoute::exposure).thenComparingDouble(WeakestRoute::seconds))
                .toList();
    }

    /** The same for candidates, by their numbers. */
    List<WeakestRoute> pastCandidates(List<Integer> chosen) {
        return past(Set.copyOf(names(chosen)));
    }

    /** The exposure on the weakest route past some sensors. */
    Optional<Double> least(Set<String> names) {
        return past(names).stream().findFirst().map(route -> Math.min(WeakestRouteSearch.ENOUGH, route.exposure()));
    }
}
