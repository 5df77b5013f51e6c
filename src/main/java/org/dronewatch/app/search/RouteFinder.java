package org.dronewatch.app.search;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.app.console.Interruption;
import org.dronewatch.app.console.TaskProgress;
import org.dronewatch.drone.Drone;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.report.route.RouteInputs;
import org.dronewatch.report.route.RouteResults;
import org.dronewatch.route.FlightMode;
import org.dronewatch.route.ModeField;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.proof.UnseenPlaces;
import org.dronewatch.route.search.TimeToGo;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;

/** Assesses how a drone is detected, searches for the routes on which it is least exposed, and flies them. */
public final class RouteFinder {
    private final SceneRunner runner;
    private final RouteInputs inputs;
    private final Stage stage;
    private final Interruption interruption;
    private final TaskProgress shown;

    /** The result of a search before the routes are flown. */
    private record Found(SiteRoutes routes, RouteSurvey survey, UnseenPlaces between, TimeToGo times) {}

    /**
     * A search.
     *
     * @param shown shows the progress
     */
    public RouteFinder(
            SceneRunner runner, RouteInputs inputs, Stage stage, Interruption interruption, TaskProgress shown) {
        this.runner = runner;
        this.inputs = inputs;
        this.stage = stage;
        this.interruption = interruption;
        this.shown = shown;
    }

    /**
     * Finds the routes.
     *
     * @param modes modes in which the drone may fly
     * @param launch the area from which the routes come; empty for the edge of the area searched
     * @param flights number of runs in which each route is flown, each with a different seed; 0 for none
     */
    public RouteResults find(List<FlightMode> modes, Optional<AreaZone> launch, int flights) {
        List<ModeField> fields = fields(modes);
        Found found = shown.during("routes", SiteRoutes.SECTORS + 1, progress -> {
            SiteRoutes routes = routes(fields, launch);
            UnseenPlaces between = UnseenPlaces.of(fields, inputs.settings());
            TimeToGo times = routes.timeToGo();
            progress.accept(1);
            RouteSurvey survey = RouteSurvey.of(
                    routes, inputs.settings().alert().response(), sector -> progress.accept(1), this::letFinish);
            return new Found(routes, survey, between, times);
        });
        return new RouteFlights(runner, inputs, interruption, shown, flights)
                .of(found.routes(), found.survey(), found.between(), found.times());
    }

    /**
     * Lets the routes that were found so far be flown if the user has interrupted the search, but not if the time is
     * up.
     */
    private void letFinish() {
        if (interruption.isOutOfTime()) {
            throw new CancellationException("the time is up");
        }
        interruption.letFinish();
    }

    private List<ModeField> fields(List<FlightMode> modes) {
        SceneSettings settings = inputs.settings();
        Drone drone = DetectionField.droneOf(stage, inputs.drone());
        LayerStore store =
                LayerStore.of(settings, runner.inputs().models(), LayerStore.standard(runner.store(), shown.notes()));
        List<FieldRequest> requests = modes.stream()
                .map(mode -> new FieldRequest(
                        settings,
                        stage,
                        inputs.drone(),
                        inputs.grid(),
                        mode.courses(settings.enabledSensors(), drone),
                        FieldCoverage.Choice.WORST,
                        FieldTerms.ONE_LOOK.withPointing(inputs.pointing()),
                        FieldCoverage.DEFAULT_COVERED))
                .toList();
        long looks = requests.stream().mapToLong(FieldRequest::looksOfField).sum();
        return shown.during("detection field", looks, progress -> {
            List<ModeField> fields = new ArrayList<>();
            for (int mode = 0; mode < modes.size(); mode++) {
                DetectionField field = FieldAssessment.of(requests.get(mode), store, progress);
                fields.add(modes.get(mode).with(field, drone.settings()));
            }
            return fields;
        });
    }

    private SiteRoutes routes(List<ModeField> fields, Optional<AreaZone> launch) {
        try {
            return SiteRoutes.of(fields, inputs.settings(), stage, inputs.drone(), launch);
        } catch (IllegalArgumentException e) {
            throw new InputException(e.getMessage(), e);
        }
    }
}
