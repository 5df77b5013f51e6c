package org.dronewatch.run;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.Displaced;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightsFile;
import org.dronewatch.flight.FlownPath;
import org.dronewatch.flight.Leg;
import org.dronewatch.flight.Recorded;
import org.dronewatch.flight.Steered;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.Ground;

/**
 * Creates the paths of a scene's drones; a swarm shares its leader's, which may have been costly to fit to the ground.
 */
final class FlightPaths {
    private final Ground ground;
    private final double end;
    private final Function<String, FlightsFile> files;
    private final Consumer<String> warnings;
    private final Map<DroneSettings, FlightPath> leaders = new HashMap<>();

    /**
     * No paths yet.
     *
     * @param end of the run, s
     * @param files reads the file of a recorded flight by its name in the settings
     * @param warnings receives a line for each recorded flight that ends before the run does
     */
    FlightPaths(Ground ground, double end, Function<String, FlightsFile> files, Consumer<String> warnings) {
        this.ground = ground;
        this.end = end;
        this.files = files;
        this.warnings = warnings;
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
                ? drone.leaning(replayed(id, recorded))
                : drone.createFlight(ground);
    }

    private FlownPath replayed(String id, Recorded recorded) {
        FlownPath path = files.apply(recorded.file())
                .flight(recorded.run(), recorded.drone().orElse(id));
        Leg last = path.legs().get(path.legs().size() - 1);
        if (last.time() < end) {
            double speed = last.start().velocity().length();
            warnings.accept(String.format(
                    Locale.ROOT,
                    "drone '%s': its recorded flight ends at %s s, the run at %s s: for the rest of the run the drone %s",
                    id,
                    last.time(),
                    end,
                    speed == 0.0 ? "hovers" : String.format(Locale.ROOT, "flies straight on at %.1f m/s", speed)));
        }
        return path;
    }
}
