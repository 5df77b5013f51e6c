package org.dronewatch.placement.route;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.placement.RowOracle;
import org.dronewatch.route.SectorRoute;

/**
 * The weakest known route from each direction past a layout, in the scene as it is and under each condition, by its
 * exposure to each candidate. Not thread-safe.
 */
final class RouteRows implements RowOracle {
    private final List<SceneRoutes> scenes;
    private final List<String> candidates;

    /**
     * The routes of a plan.
     *
     * @param scenes the scene as it is, and under each condition
     * @param candidates their names
     */
    RouteRows(List<SceneRoutes> scenes, List<String> candidates) {
        this.scenes = List.copyOf(scenes);
        this.candidates = List.copyOf(candidates);
    }

    @Override
    public List<double[]> weakest(List<Integer> chosen) {
        Set<String> names = names(chosen);
        return scenes.stream()
                .flatMap(scene -> scene.searched(names, candidates).stream())
                .toList();
    }

    @Override
    public List<double[]> known() {
        return scenes.stream()
                .flatMap(scene -> scene.known(candidates).stream())
                .toList();
    }

    /** Adds routes that were found in another way, in the scene as it is. */
    void learn(List<SectorRoute> found) {
        scenes.get(0).learn(found);
    }

    private Set<String> names(List<Integer> chosen) {
        Set<String> names = new LinkedHashSet<>();
        chosen.forEach(one -> names.add(candidates.get(one)));
        return names;
    }

    /**
     * The weakest known routes past some of the sensors from each direction under each condition, the weakest of all
     * first.
     */
    List<DirectedRoute> past(Set<String> names) {
        return scenes.stream()
                .flatMap(scene -> scene.past(names).stream())
                .sorted(SceneRoutes.WEAKEST_FIRST)
                .toList();
    }

    /** The weakest known routes past some of the candidates, given by their numbers, as {@link #past}. */
    List<DirectedRoute> pastCandidates(List<Integer> chosen) {
        return past(names(chosen));
    }

    /**
     * The least exposure to some candidates on all routes that are known, by condition; under an empty name, in the
     * scene as it is.
     */
    Map<Optional<String>, Double> values(List<Integer> chosen) {
        Map<Optional<String>, Double> values = new LinkedHashMap<>();
        scenes.forEach(scene -> values.put(scene.condition(), counted(scene.past(names(chosen)))));
        return values;
    }

    /** The least exposure under all conditions; no route is searched for if one is known without exposure. */
    double value(List<Integer> chosen) {
        return most(chosen) == 0.0 ? 0.0 : counted(pastCandidates(chosen));
    }

    /** The part that counts of the exposure on the first, the weakest, of some routes. */
    static double counted(List<DirectedRoute> routes) {
        return Math.min(WeakestRouteSearch.ENOUGH, routes.get(0).exposure());
    }

    /** An upper bound on the least exposure to some candidates, by the routes known so far. */
    double most(List<Integer> chosen) {
        Set<String> names = names(chosen);
        return scenes.stream().mapToDouble(scene -> scene.least(names)).min().orElseThrow();
    }

    /** The mean over all known routes of the exposure that counts on each. */
    double mean(List<Integer> chosen) {
        return known().stream()
                .mapToDouble(row -> Math.min(
                        WeakestRouteSearch.ENOUGH,
                        chosen.stream().mapToDouble(one -> row[one]).sum()))
                .average()
                .orElse(0.0);
    }
}
