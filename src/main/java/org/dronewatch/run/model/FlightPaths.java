package org.dronewatch.run.model;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.FlightLimits;
import org.dronewatch.flight.Displaced;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlownPath;
import org.dronewatch.flight.Leg;
import org.dronewatch.flight.Recorded;
import org.dronewatch.flight.Steered;
import org.dronewatch.flight.file.DroneSpeeds;
import org.dronewatch.flight.file.FlightFromFile;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.Places;

/**
 * Creates the paths of a scene's drones; the drones of a swarm share the path of their leader, which may have been
 * costly to fit to the ground.
 */
public final class FlightPaths {
    private final Places places;
    private final double end;
    private final ModelCache files;
    private final Map<DroneSettings, FlightPath> leaders = new HashMap<>();

    /**
     * Begins without any paths.
     *
     * @param places places of the site, with its ground
     * @param end end of the run, seconds since its start
     * @param files reads the files of flights
     */
    public FlightPaths(Places places, double end, ModelCache files) {
        this.places = places;
        this.end = end;
        this.files = files;
    }

    /**
     * The path of a drone.
     *
     * @throws InputException when the path follows the ground and there is none, or when it was recorded in an invalid
     *     file
     */
    public FlightPath of(String id, DroneSettings drone) {
        try {
            return drone.flight() instanceof Displaced follower ? beside(id, drone, follower) : alone(id, drone);
        } catch (IllegalArgumentException | InputException e) {
            throw new InputException("drone '" + id + "': flight: " + e.getMessage(), e);
        }
    }

    /**
     * The path of a drone in a swarm: each drone is steered separately, and repeats its own flight unless another's is
     * named.
     */
    private FlightPath beside(String id, DroneSettings drone, Displaced follower) {
        if (follower.leader() instanceof Steered leader) {
            return drone.withFlight(leader.beside(follower.offset())).createFlight(places.ground());
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
        if (drone.flight() instanceof Recorded recorded) {
            return drone.leaning(replayed(id, recorded));
        }
        return drone.flight() instanceof FlightFromFile settings
                ? drone.leaning(fromFile(id, drone, settings))
                : drone.createFlight(places.ground());
    }

    private FlightPath fromFile(String id, DroneSettings drone, FlightFromFile settings) {
        FlightLimits limits = drone.flightLimits();
        FlightPath path = files.flight(settings)
                .path(
                        places,
                        new DroneSpeeds(drone.speed(), drone.acceleration(), limits.climb(), limits.sink()),
                        line -> files.warn("drone '" + id + "': flight: " + line));
        if (path instanceof FlownPath flown) {
            warnOfEnd(id, flown);
        }
        return path;
    }

    private FlownPath replayed(String id, Recorded recorded) {
        FlownPath path = files.flights(recorded.file())
                .flight(recorded.run(), recorded.drone().orElse(id));
        warnOfEnd(id, path);
        return path;
    }

    private void warnOfEnd(String id, FlownPath path) {
        Leg last = path.legs().get(path.legs().size() - 1);
        if (last.time() < end) {
            double speed = last.start().velocity().length();
            files.warn(String.format(
                    Locale.ROOT,
                    "drone '%s': its recorded flight ends at %s s, the run at %s s: for the rest of the run the drone %s",
                    id,
                    last.time(),
                    end,
                    speed == 0.0 ? "hovers" : String.format(Locale.ROOT, "flies straight on at %.1f m/s", speed)));
        }
    }
}
