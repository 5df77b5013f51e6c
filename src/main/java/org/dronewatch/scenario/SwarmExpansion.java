package org.dronewatch.scenario;

import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.drone.DroneSettings;

/** Expands a scene's drones: each drone, with each swarm replaced by its members. */
final class SwarmExpansion {
    private static final int MOST = 1000;

    private SwarmExpansion() {}

    /**
     * All drones that fly, by id: the drones of swarm {@code x} are {@code x-1}, {@code x-2} and so on.
     *
     * @throws IllegalArgumentException when two get the same id, or when there are too many
     */
    static Map<String, DroneSettings> of(Map<String, DroneSettings> drones) {
        long count = drones.values().stream()
                .mapToLong(drone -> drone.swarm().map(swarm -> swarm.count()).orElse(1))
                .sum();
        if (count > MOST) {
            throw new IllegalArgumentException(
                    "drones: " + count + " in all, including swarms; there must be at most " + MOST);
        }
        Map<String, DroneSettings> individuals = new LinkedHashMap<>();
        Map<String, String> sources = new HashMap<>();
        drones.forEach((id, drone) -> {
            List<DroneSettings> flying = drone.members();
            for (int i = 0; i < flying.size(); i++) {
                String name = drone.swarm().isPresent() ? id + "-" + (i + 1) : id;
                String other = sources.put(name, id);
                if (other != null) {
                    throw new IllegalArgumentException("drones '" + other + "' and '" + id + "' both produce a drone '"
                            + name + "', since the drones of a swarm are numbered: rename one");
                }
                individuals.put(name, flying.get(i));
            }
        });
        return Collections.unmodifiableMap(individuals);
    }
}
