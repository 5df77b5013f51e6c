package org.dronewatch.report.route;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.report.file.OutputDirectory;
import org.dronewatch.report.provenance.SceneDirectories;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.proof.RouteScene;
import org.dronewatch.route.proof.RouteStarts;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.OutsideFileException;

/**
 * A scene file for each route, in which only the drone of the search flies, along the route and at the speeds of the
 * search, until it arrives.
 */
public final class RouteScenes {
    private static final String NONE = "warning: no scenes of the routes are written: ";

    private final RouteInputs inputs;
    private final BiFunction<SceneSettings, Path, String> text;

    /**
     * The scenes of a search.
     *
     * @param text writes settings as the text of a scene file; throws {@link org.dronewatch.setting.InputException}
     *     where they cannot be written
     */
    public RouteScenes(RouteInputs inputs, BiFunction<SceneSettings, Path, String> text) {
        this.inputs = inputs;
        this.text = text;
    }

    /** The name of the scene file of a route. */
    static String name(SectorRoute route) {
        return "route-" + RouteWords.sector(route) + ".yaml";
    }

    /**
     * Writes the scenes, either all or none of them.
     *
     * @param directories where the scenes can be written if not into the target
     * @return why none are written, or which of several flights each has; empty if there is nothing to say
     */
    Optional<String> write(RouteSurvey survey, Path target, SceneDirectories directories, OutputDirectory directory)
            throws IOException {
        Map<String, String> scenes;
        try {
            scenes = texts(target, survey);
        } catch (OutsideFileException e) {
            return Optional.of(NONE + e.fact() + "; " + directories.advice(other -> texts(other, survey)));
        } catch (InputException e) {
            return Optional.of(NONE + e.getMessage());
        }
        for (Map.Entry<String, String> scene : scenes.entrySet()) {
            Files.write(directory.file(scene.getKey()), scene.getValue().getBytes(StandardCharsets.UTF_8));
        }
        return flights() == 1 || scenes.isEmpty()
                ? Optional.empty()
                : Optional.of("the scene of each route has the first of its " + flights()
                        + " flights; comments in it say how to fly another");
    }

    /** The scenes of all routes for a directory, as {@link #text} writes them. */
    private Map<String, String> texts(Path target, RouteSurvey survey) {
        Map<String, String> scenes = new LinkedHashMap<>();
        for (SectorRoute route : survey.routes()) {
            String name = name(route);
            settings(route, survey)
                    .ifPresent(scene -> scenes.put(name, commented(text.apply(scene, target.resolve(name)))));
        }
        return scenes;
    }

    /** The number of flights of each route. */
    private int flights() {
        return RouteStarts.of(inputs.settings().enabledSensors().values()).size();
    }

    /** Says after the first line which of the flights the drone flies, if the figures are means over several. */
    private String commented(String scene) {
        int first = scene.indexOf('\n') + 1;
        return flights() == 1
                ? scene
                : scene.substring(0, first)
                        + "# The figures of 'route' are means over " + flights()
                        + " flights that begin at different moments; this is the first of them.\n"
                        + "# For another one, add one of the times in starts_s of route.json to the delay of the flight and"
                        + " to the duration of the run.\n"
                        + scene.substring(first);
    }

    /** The scene in which the drone flies a route; empty if the route begins where it ends. */
    public Optional<SceneSettings> settings(SectorRoute route, RouteSurvey survey) {
        return route.route()
                .path()
                .flight(survey.modes())
                .map(flight -> RouteScene.of(inputs.settings(), inputs.drone(), flight));
    }

    /** A scene in which all routes are flown at the same time, each by one drone; empty if there is no route to fly. */
    public Optional<SceneSettings> together(RouteSurvey survey) {
        Map<String, RouteFlight> flights = new LinkedHashMap<>();
        for (SectorRoute route : survey.routes()) {
            route.route()
                    .path()
                    .flight(survey.modes())
                    .ifPresent(flight -> flights.put(RouteWords.sector(route), flight));
        }
        return flights.isEmpty()
                ? Optional.empty()
                : Optional.of(RouteScene.with(inputs.settings(), inputs.drone(), flights));
    }
}
