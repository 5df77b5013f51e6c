package org.dronewatch.app.search;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.dronewatch.app.console.Interruption;
import org.dronewatch.app.console.TaskProgress;
import org.dronewatch.report.route.RouteInputs;
import org.dronewatch.report.route.RouteResults;
import org.dronewatch.report.route.RouteScenes;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.proof.FlownRoute;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.route.proof.UnseenPlaces;
import org.dronewatch.route.search.TimeToGo;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;

/** Flies the routes that were found: every look along them is assessed and, if asked for, many seeds are run. */
final class RouteFlights {
    /** The greatest number of runs of each route with cues: all of these are whole runs, which take long. */
    private static final int MOST_CUED = 100;

    private final SceneRunner runner;
    private final RouteInputs inputs;
    private final Interruption interruption;
    private final TaskProgress shown;
    private final Map<Integer, FlownRoute> flown = new LinkedHashMap<>();
    private final Map<Integer, SceneSettings> scenes = new LinkedHashMap<>();
    private final Map<Integer, RouteProof> proofs = new LinkedHashMap<>();
    private final Map<Integer, Double> timely = new LinkedHashMap<>();

    RouteFlights(SceneRunner runner, RouteInputs inputs, Interruption interruption, TaskProgress shown) {
        this.runner = runner;
        this.inputs = inputs;
        this.interruption = interruption;
        this.shown = shown;
    }

    /**
     * Flies them.
     *
     * @param survey what the search has found
     * @param between whether the cells of the search are small enough
     * @param times the least times to the end of a route
     * @param runs number of seeds with which each route is flown; 0 for none
     * @return after an interruption, only the routes that were assessed
     */
    RouteResults of(RouteSurvey survey, UnseenPlaces between, TimeToGo times, int runs) {
        List<SectorRoute> assessed = new ArrayList<>();
        int all = survey.routes().size();
        try {
            shown.during("looks along the routes", all, progress -> {
                for (SectorRoute route : survey.routes()) {
                    assessed.add(assess(route, survey, runs));
                    progress.accept(1);
                }
                return all;
            });
            shown.during("flights", (long) runs * all, progress -> {
                if (runs > 0) {
                    flown.forEach((sector, route) -> proofs.put(sector, route.prove(runs, progress)));
                }
                return all;
            });
            flyWithCues(runs);
        } catch (CancellationException e) {
            if (!interruption.happened() || assessed.isEmpty()) {
                throw e;
            }
            return new RouteResults(
                    survey.with(assessed, assessed.size() == all), between, times, proofs, timely, false);
        }
        return new RouteResults(survey.with(assessed, true), between, times, proofs, timely, survey.isComplete());
    }

    /** Flies some of the proved flights again with cues, if these can make a difference. */
    private void flyWithCues(int runs) {
        int cued = RouteProof.hasCues(inputs.settings()) ? Math.min(runs, MOST_CUED) : 0;
        if (cued > 0) {
            shown.during("flights with cues", (long) cued * proofs.size(), progress -> {
                proofs.replaceAll((sector, proof) -> {
                    SceneSettings scene = scenes.get(sector);
                    return proof.with(RouteProof.withCues(scene, runner.load(scene), cued, progress));
                });
                return cued;
            });
        }
    }

    private SectorRoute assess(SectorRoute route, RouteSurvey survey, int runs) {
        Optional<SceneSettings> scene = new RouteScenes(inputs, runner::text).settings(route, survey);
        if (scene.isEmpty()) {
            return route;
        }
        ModelCache models = runner.load(scene.get());
        FlownRoute flight =
                runs > 0 ? FlownRoute.toProve(scene.get(), models, runs) : FlownRoute.of(scene.get(), models, 1);
        flown.put(route.sector(), flight);
        scenes.put(route.sector(), scene.get());
        if (inputs.isCued()) {
            // Flights have no cues: where positioners count as cued, the search alone knows what they see.
            return route;
        }
        if (survey.response() > 0.0) {
            flight.interruption(survey.response()).ifPresent(p -> timely.put(route.sector(), p));
        }
        return route.with(flight.exposure());
    }
}
