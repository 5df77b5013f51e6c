package org.dronewatch.report.route;

import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.TimelyDetection;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.route.proof.UnseenPlaces;
import org.dronewatch.route.search.TimeToGo;

/**
 * What {@code route} found.
 *
 * @param survey the weakest routes
 * @param found all routes that the search has found, including routes of repeated searches that are not among the
 *     weakest as flown, and routes that repeated searches replaced
 * @param between what was found between the centres of the cells, which shows whether the cells of the search are small
 *     enough
 * @param times the shortest times to the end of a route
 * @param proofs how often flights along each sector's route are detected, by sector; empty if no proof was requested
 * @param isComplete whether everything that was requested was completed
 */
public record RouteResults(
        RouteSurvey survey,
        List<SectorRoute> found,
        UnseenPlaces between,
        TimeToGo times,
        Map<Integer, RouteProof> proofs,
        boolean isComplete) {
    /** Copies the lists and maps. */
    public RouteResults {
        found = List.copyOf(found);
        proofs = Collections.unmodifiableMap(new LinkedHashMap<>(proofs));
    }

    /**
     * The route that is least exposed according to the search, whatever flights show; empty if all routes end where
     * they begin.
     */
    public Optional<SectorRoute> leastExposed() {
        return found.stream()
                .filter(one -> one.route().seconds() > 0.0)
                .min(Comparator.comparingDouble(one -> one.route().exposure()));
    }

    /**
     * The probability that the drone is stopped on a route, {@code P_E = P_I P_N} in the EASI model; empty where the
     * probability of an alert in time cannot be computed, or P_N is not given.
     *
     * @param inputs the inputs, which state P_N
     */
    static OptionalDouble effectiveness(SectorRoute route, RouteInputs inputs) {
        return route.alertInTime().isPresent() && inputs.stopped().isPresent()
                ? OptionalDouble.of(TimelyDetection.effectiveness(
                        route.alertInTime().getAsDouble(), inputs.stopped().get()))
                : OptionalDouble.empty();
    }
}
