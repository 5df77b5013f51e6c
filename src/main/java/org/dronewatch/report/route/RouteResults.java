package org.dronewatch.report.route;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.proof.RouteProof;

/**
 * What {@code route} found.
 *
 * @param survey the weakest routes
 * @param proofs by sector, how often flights of its route are detected; empty if none were asked for
 * @param timely by sector, the probability that an alert on its route is in time, by the scene's rule; only where it
 *     can be computed
 * @param isComplete whether all that was asked for was completed
 */
public record RouteResults(
        RouteSurvey survey, Map<Integer, RouteProof> proofs, Map<Integer, Double> timely, boolean isComplete) {
    /** Copies the maps. */
    public RouteResults {
        proofs = Collections.unmodifiableMap(new LinkedHashMap<>(proofs));
        timely = Collections.unmodifiableMap(new LinkedHashMap<>(timely));
    }
}
