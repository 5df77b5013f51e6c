package org.dronewatch.route.proof;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.FlightPerformance;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.Spelling;

/** A route as a scene that can be run: the drone flies the route alone, and the run ends when the drone arrives. */
public final class RouteScene {
    private RouteScene() {}

    /**
     * A scene in which only this drone flies, on the given flight, until it arrives. The drone keeps its name, so that
     * sensors draw the same random numbers; of a swarm, only this member flies.
     *
     * @param drone name of the drone in {@link SceneSettings#individualDrones()}
     * @throws IllegalArgumentException if there is no such drone
     */
    public static SceneSettings of(SceneSettings scene, String drone, RouteFlight flight) {
        return with(scene, drone, Map.of(drone, flight));
    }

    /**
     * A scene in which the route begins later: the drone waits where the route begins, which does not count towards its
     * endurance.
     *
     * @param scene a scene with one drone
     * @param delay additional delay, s
     * @throws IllegalArgumentException if the drone does not fly a {@link RouteFlight}
     */
    static SceneSettings later(SceneSettings scene, double delay) {
        if (delay == 0.0) {
            return scene;
        }
        Map.Entry<String, DroneSettings> drone =
                scene.individualDrones().entrySet().iterator().next();
        if (!(drone.getValue().flight() instanceof RouteFlight flight)) {
            throw new IllegalArgumentException("drone '" + drone.getKey() + "' does not fly a route");
        }
        FlightPerformance stated = drone.getValue().performance().orElse(FlightPerformance.TYPICAL);
        double endurance = Math.min(
                FlightPerformance.LONGEST, drone.getValue().flightLimits().endurance() + delay);
        DroneSettings waiting = drone.getValue().withPerformance(stated.withEndurance(endurance));
        return of(scene.withDrone(drone.getKey(), waiting), drone.getKey(), flight.withDelay(flight.delay() + delay));
    }

    /** When the route of a scene with one drone begins, s since the start of the run. */
    static double begin(SceneSettings scene) {
        return scene.individualDrones().values().iterator().next().flight() instanceof RouteFlight flight
                ? flight.delay()
                : 0.0;
    }

    /**
     * A scene in which copies of a drone fly several routes at the same time, until the last one arrives. Such a scene
     * is for watching, not for checking the routes, since positioners turn to one drone at a time.
     *
     * @param drone name of the drone; a copy of it flies each route
     * @param flights the flights, at least one, by the names of the copies that fly them
     * @throws IllegalArgumentException if there is no such drone
     */
    public static SceneSettings with(SceneSettings scene, String drone, Map<String, RouteFlight> flights) {
        DroneSettings flown = scene.individualDrones().get(drone);
        if (flown == null) {
            throw new IllegalArgumentException(Spelling.unknown(
                    "drone", drone, "the scene", scene.individualDrones().keySet()));
        }
        Map<String, DroneSettings> drones = new LinkedHashMap<>();
        flights.forEach((name, flight) -> drones.put(name, flown.withFlight(flight)));
        double duration = flights.values().stream()
                .mapToDouble(flight -> flight.duration(flown.speed()))
                .max()
                .orElseThrow();
        return new SceneSettings(
                scene.world(),
                drones,
                scene.sensors(),
                scene.disabled(),
                scene.alert(),
                scene.prices(),
                scene.run().withDuration(duration),
                Optional.empty());
    }

    /**
     * A scene without its cues: positioners only search. No sensor cues them, and they do not follow what their own
     * sensors see, so that where they point does not depend on chance.
     */
    public static SceneSettings withoutCues(SceneSettings scene) {
        SceneSettings changed = scene;
        for (Map.Entry<String, SensorSettings<?>> sensor : scene.sensors().entrySet()) {
            Optional<PositionerSettings> positioner = Mounted.positioner(sensor.getValue());
            if (positioner.isPresent()) {
                changed = changed.withSensor(sensor.getKey(), searching(sensor.getValue(), positioner.get()));
            }
        }
        return changed;
    }

    private static SensorSettings<?> searching(SensorSettings<?> sensor, PositionerSettings positioner) {
        // A positioner loses a contact that has not been seen for longer than it holds it: at once.
        PositionerSettings alone = positioner.withCues().withHold(0.0);
        return (SensorSettings<?>) SettingsForm.with((Record) sensor, "positioner", Optional.of(alone));
    }
}
