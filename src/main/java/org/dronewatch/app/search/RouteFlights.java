package org.dronewatch.app.search;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import org.dronewatch.app.console.Interruption;
import org.dronewatch.app.console.TaskProgress;
import org.dronewatch.report.route.RouteInputs;
import org.dronewatch.report.route.RouteResults;
import org.dronewatch.report.route.RouteScenes;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.proof.FlownRoute;
import org.dronewatch.route.proof.RepeatedSearch;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.route.proof.UnseenPlaces;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.TimeToGo;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;

/** Flies the routes that were found: every look along them is assessed and, if asked for, many seeds are run. */
final class RouteFlights {
    /** The greatest number of runs of each route with cues: each of these is a whole run, which takes long. */
    private static final int MOST_CUED = 100;

    private final SceneRunner runner;
    private final RouteInputs inputs;
    private final Interruption interruption;
    private final TaskProgress shown;
    private final int runs;

    /** The flights by their paths, including those of the routes that repeated searches have found. */
    private final Map<RoutePath, Flight> flights = new HashMap<>();

    private final List<SectorRoute> found = new ArrayList<>();

    private final Map<Integer, RouteProof> proofs = new LinkedHashMap<>();

    /**
     * The flight of a route that is long enough to be flown.
     *
     * @param scene scene in which the drone flies it
     * @param flown the route with all looks along it
     */
    private record Flight(SceneSettings scene, FlownRoute flown) {}

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
        RepeatedSearch search = new RepeatedSearch(routes, survey, route -> assess(route, survey));
        try {
            shown.during("looks along the routes", all, progress -> {
                search.assess(progress);
                return all;
            });
            avoidLateDetections(search);
            if (search.isNeeded()) {
                shown.during("repeated search for routes", RepeatedSearch.MOST, progress -> {
                    search.repeat(progress);
                    return all;
                });
            }
            avoidLateDetections(search);
            shown.during("flights", (long) runs * all, progress -> {
                if (runs > 0) {
                    flown(search)
                            .forEach((sector, flight) ->
                                    proofs.put(sector, flight.flown().prove(runs, progress)));
                }
                return all;
            });
            flyWithCues(flown(search));
        } catch (CancellationException e) {
            if (!interruption.happened() || search.survey().routes().isEmpty()) {
                throw e;
            }
            return results(search, between, times, false);
        }
        return results(search, between, times, survey.isComplete());
    }

    private void avoidLateDetections(RepeatedSearch search) {
        if (search.isTooLate()) {
            shown.during("routes least exposed all the way", RepeatedSearch.MOST + 1L, progress -> {
                search.avoidLateDetections(progress);
                return search.survey().routes().size();
            });
        }
    }

    private RouteResults results(RepeatedSearch search, UnseenPlaces between, TimeToGo times, boolean isComplete) {
        return new RouteResults(search.survey(), found, between, times, proofs, isComplete);
    }

    /** By sector, the flights of the routes that were kept. */
    private Map<Integer, Flight> flown(RepeatedSearch search) {
        Map<Integer, Flight> flown = new LinkedHashMap<>();
        for (SectorRoute route : search.survey().routes()) {
            Flight flight = flights.get(route.route().path());
            if (flight != null) {
                flown.put(route.sector(), flight);
            }
        }
        return flown;
    }

    /** Flies some of the proved flights again with cues, if these can make a difference. */
    private void flyWithCues(Map<Integer, Flight> flown) {
        int cued = RouteProof.hasCues(inputs.settings()) ? Math.min(runs, MOST_CUED) : 0;
        if (cued > 0) {
            shown.during("flights with cues", (long) cued * proofs.size(), progress -> {
                proofs.replaceAll((sector, proof) -> {
                    SceneSettings scene = flown.get(sector).scene();
                    return proof.with(RouteProof.withCues(scene, runner.load(scene), cued, progress));
                });
                return cued;
            });
        }
    }

    /** The route with the exposure to all looks along it, if these looks reveal anything. */
    private SectorRoute assess(SectorRoute route, RouteSurvey survey) {
        found.add(route);
        Optional<SceneSettings> scene = new RouteScenes(inputs, runner::text).settings(route, survey);
        if (scene.isEmpty()) {
            return route;
        }
        ModelCache models = runner.load(scene.get());
        FlownRoute flown =
                runs > 0 ? FlownRoute.toProve(scene.get(), models, runs) : FlownRoute.of(scene.get(), models, 1);
        flights.put(route.route().path(), new Flight(scene.get(), flown));
        // Flights have no cues: if positioners count as cued, only the search knows what they see.
        if (inputs.isCued()) {
            return route;
        }
        double response = survey.response();
        return route.with(flown.exposure()
                .withAlertInTime(response > 0.0 ? flown.interruption(response) : OptionalDouble.empty()));
    }
}
