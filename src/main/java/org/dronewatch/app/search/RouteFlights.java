package org.dronewatch.app.search;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import org.dronewatch.app.console.Interruption;
import org.dronewatch.app.console.TaskProgress;
import org.dronewatch.report.route.RouteInputs;
import org.dronewatch.report.route.RouteResults;
import org.dronewatch.report.route.RouteScenes;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.proof.FlownRoute;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.route.proof.UnforeseenExposure;
import org.dronewatch.route.proof.UnseenPlaces;
import org.dronewatch.route.search.TimeToGo;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;

/** Flies the routes that were found: every look along them is assessed and, if asked for, many seeds are run. */
final class RouteFlights {
    /** The greatest number of runs of each route with cues: all of these are whole runs, which take long. */
    private static final int MOST_CUED = 100;

    /** The greatest number of searches past what flights have shown. */
    private static final int MOST_SEARCHES = 4;

    private final SceneRunner runner;
    private final RouteInputs inputs;
    private final Interruption interruption;
    private final TaskProgress shown;
    private final int runs;

    /** By sector, in the order of the routes. */
    private final Map<Integer, Assessed> kept = new LinkedHashMap<>();

    private final Map<Integer, RouteProof> proofs = new LinkedHashMap<>();

    /**
     * A route, and its flight.
     *
     * @param route with the exposure to its looks if these have been assessed
     * @param scene in which the drone flies it; empty if it is too short to be flown
     * @param flight empty if it is too short to be flown
     * @param timely the probability of a timely alert; empty if it is not known
     */
    private record Assessed(
            SectorRoute route, Optional<SceneSettings> scene, Optional<FlownRoute> flight, OptionalDouble timely) {}

    /**
     * Flights of routes.
     *
     * @param runs number of seeds with which each route is flown; 0 for none
     */
    RouteFlights(SceneRunner runner, RouteInputs inputs, Interruption interruption, TaskProgress shown, int runs) {
        this.runner = runner;
        this.inputs = inputs;
        this.interruption = interruption;
        this.shown = shown;
        this.runs = runs;
    }

    /**
     * Flies the routes, and searches again where the flights show that the search expected too little.
     *
     * @param routes the search
     * @param survey what it has found
     * @param between whether its cells are small enough
     * @param times the least times to the end of a route
     * @return after an interruption, only the routes that were assessed
     */
    RouteResults of(SiteRoutes routes, RouteSurvey survey, UnseenPlaces between, TimeToGo times) {
        int all = survey.routes().size();
        try {
            shown.during("looks along the routes", all, progress -> {
                for (SectorRoute route : survey.routes()) {
                    kept.put(route.sector(), assess(route, survey));
                    progress.accept(1);
                }
                return all;
            });
            if (!underestimated(survey).isEmpty()) {
                shown.during("routes past what flights have shown", MOST_SEARCHES, progress -> {
                    searchAgain(routes, survey, progress);
                    return all;
                });
            }
            shown.during("flights", (long) runs * all, progress -> {
                if (runs > 0) {
                    kept.forEach((sector, one) ->
                            one.flight().ifPresent(flight -> proofs.put(sector, flight.prove(runs, progress))));
                }
                return all;
            });
            flyWithCues();
        } catch (CancellationException e) {
            if (!interruption.happened() || kept.isEmpty()) {
                throw e;
            }
            return results(survey, between, times, false);
        }
        return results(survey, between, times, survey.isComplete());
    }

    private RouteResults results(RouteSurvey survey, UnseenPlaces between, TimeToGo times, boolean isComplete) {
        Map<Integer, Double> timely = new LinkedHashMap<>();
        kept.forEach((sector, one) -> one.timely().ifPresent(chance -> timely.put(sector, chance)));
        List<SectorRoute> flown = kept.values().stream().map(Assessed::route).toList();
        boolean isWhole = flown.size() == survey.routes().size();
        return new RouteResults(survey.with(flown, isWhole), between, times, proofs, timely, isComplete);
    }

    /** By sector, the routes on which the drone is more likely to be detected than the search expected. */
    private Map<Integer, SectorRoute> underestimated(RouteSurvey survey) {
        Map<Integer, SectorRoute> routes = new LinkedHashMap<>();
        kept.forEach((sector, one) -> {
            if (one.route().isUnderestimated(survey.response())) {
                routes.put(sector, one.route());
            }
        });
        return routes;
    }

    /** Keeps the routes of other searches on which the drone is less likely to be detected in time. */
    private void searchAgain(SiteRoutes routes, RouteSurvey survey, IntConsumer progress) {
        UnforeseenExposure unforeseen = UnforeseenExposure.none(routes.grid());
        Map<Integer, SectorRoute> latest = underestimated(survey);
        for (int search = 0; search < MOST_SEARCHES && !latest.isEmpty(); search++) {
            Map<Integer, WeakestRoute> before = new LinkedHashMap<>();
            for (SectorRoute route : latest.values()) {
                unforeseen = unforeseen.with(route, routes.modes());
                before.put(route.sector(), route.route());
            }
            latest = new LinkedHashMap<>();
            for (Map.Entry<Integer, WeakestRoute> found :
                    routes.past(before, unforeseen).entrySet()) {
                int sector = found.getKey();
                if (found.getValue().path().equals(before.get(sector).path())) {
                    continue;
                }
                Assessed other = assess(routes.describe(sector, found.getValue()), survey);
                if (other.route().inTime(survey.response())
                        < kept.get(sector).route().inTime(survey.response())) {
                    kept.put(sector, other);
                }
                if (other.route().isUnderestimated(survey.response())) {
                    latest.put(sector, other.route());
                }
            }
            progress.accept(1);
        }
    }

    /** Flies some of the proved flights again with cues, if these can make a difference. */
    private void flyWithCues() {
        int cued = RouteProof.hasCues(inputs.settings()) ? Math.min(runs, MOST_CUED) : 0;
        if (cued > 0) {
            shown.during("flights with cues", (long) cued * proofs.size(), progress -> {
                proofs.replaceAll((sector, proof) -> {
                    SceneSettings scene = kept.get(sector).scene().orElseThrow();
                    return proof.with(RouteProof.withCues(scene, runner.load(scene), cued, progress));
                });
                return cued;
            });
        }
    }

    private Assessed assess(SectorRoute route, RouteSurvey survey) {
        Optional<SceneSettings> scene = new RouteScenes(inputs, runner::text).settings(route, survey);
        if (scene.isEmpty()) {
            return new Assessed(route, scene, Optional.empty(), OptionalDouble.empty());
        }
        ModelCache models = runner.load(scene.get());
        FlownRoute flight =
                runs > 0 ? FlownRoute.toProve(scene.get(), models, runs) : FlownRoute.of(scene.get(), models, 1);
        if (inputs.isCued()) {
            // Flights have no cues: where positioners count as cued, the search alone knows what they see.
            return new Assessed(route, scene, Optional.of(flight), OptionalDouble.empty());
        }
        OptionalDouble timely =
                survey.response() > 0.0 ? flight.interruption(survey.response()) : OptionalDouble.empty();
        return new Assessed(route.with(flight.exposure()), scene, Optional.of(flight), timely);
    }
}
