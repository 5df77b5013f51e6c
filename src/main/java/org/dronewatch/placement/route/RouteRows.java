package org.dronewatch.placement.route;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.placement.RowOracle;

/**
 * The weakest route from each direction past a layout, in the scene as it is and under each condition, by its exposure
 * to each candidate.
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
        List<double[]> rows = new ArrayList<>();
        scenes.forEach(scene -> rows.addAll(scene.compared(names, candidates)));
        return rows;
    }

    private Set<String> names(List<Integer> chosen) {
        Set<String> names = new LinkedHashSet<>();
        chosen.forEach(one -> names.add(candidates.get(one)));
        return names;
    }

    /**
     * The weakest routes past some of the sensors from each direction under each condition, the weakest of all first.
     */
    List<DirectedRoute> past(Set<String> names) {
        return scenes.stream()
                .flatMap(scene -> scene.past(names).stream())
                .sorted(SceneRoutes.WEAKEST_FIRST)
                .toList();
    }

    /** The same for candidates, by their numbers. */
    List<DirectedRoute> pastCandidates(List<Integer> chosen) {
        return past(names(chosen));
    }

    /**
     * The least exposure to some candidates on all routes that are known, by condition; under an empty name, in the
     * scene as it is.
     */
    Map<Optional<String>, Double> values(List<Integer> chosen) {
        Map<Optional<String>, Double> values = new LinkedHashMap<>();
        scenes.forEach(scene -> values.put(scene.condition(), scene.value(chosen, names(chosen))));
        return values;
    }
}
