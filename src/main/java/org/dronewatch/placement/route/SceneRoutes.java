package org.dronewatch.placement.route;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.LayoutRoutes;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * The weakest known route from each direction past any layout, in the scene as it is or under one of the conditions of
 * a plan. Whatever a route was found for, every layout is compared on it from then on. Not thread-safe.
 */
final class SceneRoutes {
    /** The weakest first; among equals, the fastest. */
    static final Comparator<DirectedRoute> WEAKEST_FIRST = Comparator.comparingDouble(DirectedRoute::exposure)
            .thenComparingDouble(one -> one.route().seconds());

    /** Exposures that differ by a smaller fraction are those of one route, except for rounding. */
    private static final double ROUNDING = 1e-9;

    private final Optional<String> condition;
    private final LayoutRoutes routes;
    private final Set<String> disabled;
    private final List<String> sensors;

    /** By the names of the sensors: the routes that a search past them has found. */
    private final Map<Set<String>, List<DirectedRoute>> searched = new HashMap<>();

    private final Map<RoutePath, KnownRoute> known = new LinkedHashMap<>();

    /** The routes past any layout, since which part of a route counts does not depend on the sensors. */
    private Optional<SiteRoutes> site = Optional.empty();

    /** A route with the exposure, on the part that counts, to each sensor by its name. */
    private record KnownRoute(DirectedRoute route, Map<String, Double> exposures) {
        double exposure(Collection<String> names) {
            return names.stream().mapToDouble(exposures::get).sum();
        }
    }

    /**
     * The routes of a scene.
     *
     * @param condition name of the condition; empty for the scene as it is
     * @param disabled names of the sensors that the condition switches off: they detect nothing
     * @param sensors names of all candidates and of the scene's own sensors
     */
    SceneRoutes(Optional<String> condition, LayoutRoutes routes, Set<String> disabled, List<String> sensors) {
        this.condition = condition;
        this.routes = routes;
        this.disabled = Set.copyOf(disabled);
        this.sensors = List.copyOf(sensors);
    }

    /** The name of the condition; empty for the scene as it is. */
    Optional<String> condition() {
        return condition;
    }

    /**
     * Searches for the weakest routes past some of the sensors, unless that was done before.
     *
     * @return for each route that the search has found, the exposures to some sensors
     */
    List<double[]> searched(Set<String> names, List<String> to) {
        return search(names).stream()
                .map(one -> row(known.get(one.route().path()), to))
                .toList();
    }

    /** For each known route, the exposures to some sensors. */
    List<double[]> known(List<String> to) {
        return known.values().stream().map(one -> row(one, to)).toList();
    }

    private static double[] row(KnownRoute one, List<String> to) {
        return to.stream().mapToDouble(one.exposures()::get).toArray();
    }

    /**
     * The weakest known routes past some of the sensors from each direction, the weakest of all first; they are
     * searched for unless that was done before.
     */
    List<DirectedRoute> past(Set<String> names) {
        Map<Integer, DirectedRoute> weakest = new TreeMap<>();
        search(names).forEach(one -> weakest.put(one.sector(), one));
        double lower = weakest.values().stream()
                .mapToDouble(one -> one.route().lower())
                .min()
                .orElse(0.0);
        for (KnownRoute one : known.values()) {
            DirectedRoute before = weakest.get(one.route().sector());
            double exposure = one.exposure(names);
            double least = before == null ? Double.POSITIVE_INFINITY : before.exposure();
            if (exposure < (1.0 - ROUNDING) * Math.min(WeakestRouteSearch.ENOUGH, least)) {
                double bound = before == null ? lower : before.route().lower();
                weakest.put(one.route().sector(), one.route().exposed(exposure, Math.min(bound, exposure)));
            }
        }
        return weakest.values().stream().sorted(WEAKEST_FIRST).toList();
    }

    /** The least exposure to some of the sensors on a known route, without a search; at most what counts. */
    double least(Set<String> names) {
        return known.values().stream()
                .mapToDouble(one -> one.exposure(names))
                .reduce(WeakestRouteSearch.ENOUGH, Math::min);
    }

    /** Adds routes that were found in another way, such as by repeated searches. */
    void learn(List<SectorRoute> found) {
        SiteRoutes any = site.orElseGet(() -> site(Set.of()));
        found.forEach(one -> learn(any, new DirectedRoute(one.sector(), condition, one.route())));
    }

    private void learn(SiteRoutes past, DirectedRoute one) {
        if (!known.containsKey(one.route().path())) {
            Workers.checkInterrupted();
            Map<String, Double> exposures = new HashMap<>();
            sensors.forEach(name -> exposures.put(name, exposure(past, one.route(), name)));
            known.put(one.route().path(), new KnownRoute(one, exposures));
        }
    }

    private double exposure(SiteRoutes past, WeakestRoute route, String name) {
        return disabled.contains(name) ? 0.0 : Math.min(WeakestRouteSearch.ENOUGH, routes.exposure(past, route, name));
    }

    private List<DirectedRoute> search(Set<String> names) {
        List<DirectedRoute> before = searched.get(names);
        if (before != null) {
            return before;
        }
        SiteRoutes past = site(names);
        List<DirectedRoute> found = fromAllDirections(past);
        found.forEach(one -> learn(past, one));
        searched.put(Set.copyOf(names), found);
        return found;
    }

    private SiteRoutes site(Set<String> names) {
        SiteRoutes past = routes.past(
                names.stream().filter(name -> !disabled.contains(name)).toList());
        site = Optional.of(past);
        return past;
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
        return all;
    }

    /** {@code , under the condition 'fog'}; an empty text for the scene as it is. */
    static String under(Optional<String> condition) {
        return condition
                .map(name -> ", under the condition '" + PlainText.value(name) + "'")
                .orElse("");
    }
}
