package org.dronewatch.run;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Function;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.Displaced;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightsFile;
import org.dronewatch.flight.Recorded;
import org.dronewatch.flight.Steered;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.Ground;

/**
 * Creates the paths of a scene's drones; a swarm shares its leader's, which may have been costly to fit to the ground.
 */
final class FlightPaths {
    private final Ground ground;
    private final Function<String, FlightsFile> files;
    private final Map<DroneSettings, FlightPath> leaders = new HashMap<>();

    /**
     * No paths yet.
     *
     * @param files reads the file of a recorded flight by its name in the settings
     */
    FlightPaths(Ground ground, Function<String, FlightsFile> files) {
        this.ground = ground;
        this.files = files;
    }

    /**
     * The path of a drone.
     *
     * @throws InputException when it follows the ground and there is none, or was recorded in a file that is wrong
     */
    FlightPath of(String id, DroneSettings drone) {
        try {
            return drone.flight() instanceof Displaced follower ? beside(id, drone, follower) : alone(id, drone);
        } catch (IllegalArgumentException | InputException e) {
            throw new InputException("drone '" + id + "': flight: " + e.getMessage(), e);
        }
    }

    /** In a swarm: each drone is steered by itself, and repeats its own flight unless another's is named. */
    private FlightPath beside(String id, DroneSettings drone, Displaced follower) {
        if (follower.leader() instanceof Steered leader) {
            return drone.withFlight(leader.beside(follower.offset())).createFlight(ground);
        }
        DroneSettings leader = drone.withFlight(follower.leader());
        if (follower.leader() instanceof Recorded recorded && recorded.drone().isEmpty()) {
            return alone(id, leader);
        }
        FlightPath known = leaders.get(leader);
        if (known == null) {
            known = alone(id, leader);
            leaders.put(leader, known);
        }
        return follower.beside(known);
    }

    private FlightPath alone(String id, DroneSettings drone) {
        return drone.flight() instanceof Recorded recorded
                ? drone.leaning(files.apply(recorded.file())
                        .flight(recorded.run(), recorded.drone().orElse(id)))
                : drone.createFlight(ground);
    }
}
