package org.dronewatch.run;

import java.util.HashMap;
import java.util.Map;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.Displaced;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.Ground;

/**
 * Creates the paths of a scene's drones; a swarm shares its leader's, which may have been costly to fit to the ground.
 */
final class FlightPaths {
    private final Ground ground;
    private final Map<DroneSettings, FlightPath> leaders = new HashMap<>();

    FlightPaths(Ground ground) {
        this.ground = ground;
    }

    /**
     * The path of a drone.
     *
     * @throws InputException when it follows the ground and there is none
     */
    FlightPath of(String id, DroneSettings drone) {
        try {
            return drone.flight() instanceof Displaced follower
                    ? follower.beside(leaders.computeIfAbsent(
                            drone.withFlight(follower.leader()), leader -> leader.createFlight(ground)))
                    : drone.createFlight(ground);
        } catch (IllegalArgumentException e) {
            throw new InputException("drone '" + id + "': flight: " + e.getMessage(), e);
        }
    }
}
