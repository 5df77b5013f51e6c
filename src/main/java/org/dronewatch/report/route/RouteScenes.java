package org.dronewatch.report.route;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.flight.RouteLeg;
import org.dronewatch.report.OutputDirectory;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.SettingsForm;

/** A scene file for each route, in which the drone alone flies it, at the speeds of the search, until it arrives. */
public final class RouteScenes {
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
     * Writes them, or none of them.
     *
     * @return why there are none; empty if they were written
     */
    Optional<String> write(RouteSurvey survey, Path target, OutputDirectory directory) throws IOException {
        Map<String, String> scenes = new LinkedHashMap<>();
        for (SectorRoute route : survey.routes()) {
            String name = name(route);
            try {
                scenes.put(name, text.apply(settings(route, survey), target.resolve(name)));
            } catch (InputException e) {
                return Optional.of("no scenes of the routes are written: " + e.getMessage());
            }
        }
        for (Map.Entry<String, String> scene : scenes.entrySet()) {
            Files.write(directory.file(scene.getKey()), scene.getValue().getBytes(StandardCharsets.UTF_8));
        }
        return Optional.empty();
    }

    /** The scene in which the drone flies a route. */
    SceneSettings settings(SectorRoute route, RouteSurvey survey) {
        SceneSettings scene = inputs.settings();
        DroneSettings drone = scene.individualDrones().get(inputs.drone());
        List<RoutePoint> corners = route.corners();
        List<RouteLeg> legs = new ArrayList<>();
        for (int i = 1; i < corners.size(); i++) {
            RoutePoint from = corners.get(i - 1);
            RoutePoint to = corners.get(i);
            double speed = (to.distance() - from.distance()) / (to.time() - from.time());
            boolean isPowered = !survey.modes().get(from.mode()).isGlide();
            legs.add(new RouteLeg(to.position(), Optional.of(speed), isPowered));
        }
        RouteFlight flight = new RouteFlight(corners.get(0).position(), legs);
        return SettingsForm.with(
                scene.withoutSweep(),
                Map.of(
                        "drones", Map.of(inputs.drone(), drone.withFlight(flight)),
                        "run", scene.run().withDuration(route.profile().end().time())));
    }
}
