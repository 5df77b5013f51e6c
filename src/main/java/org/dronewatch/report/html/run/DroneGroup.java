package org.dronewatch.report.html.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.ThreatLabel;
import org.dronewatch.flight.Swarm;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.Counted;

/**
 * A unit of the report: a single drone, or all drones of a swarm.
 *
 * @param name name of the drone or the swarm in the scene
 * @param isSwarm whether it is a swarm, even of one drone
 * @param members names of its drones
 * @param role its role
 */
record DroneGroup(String name, boolean isSwarm, List<String> members, ThreatLabel.Role role) {
    /** Copies the list. */
    DroneGroup {
        members = List.copyOf(members);
    }

    /** All groups of drones of a scene, in the scene's order; without birds. */
    static List<DroneGroup> of(SceneSettings scene) {
        return all(scene).stream()
                .filter(group -> group.role() != ThreatLabel.Role.BIRD)
                .toList();
    }

    /** Everything that flies in a scene, including birds. */
    static List<DroneGroup> all(SceneSettings scene) {
        List<DroneGroup> groups = new ArrayList<>();
        List<String> individuals = new ArrayList<>(scene.individualDrones().keySet());
        int next = 0;
        for (Map.Entry<String, DroneSettings> drone : scene.drones().entrySet()) {
            int count = drone.getValue().swarm().map(Swarm::count).orElse(1);
            groups.add(new DroneGroup(
                    drone.getKey(),
                    drone.getValue().swarm().isPresent(),
                    individuals.subList(next, next + count),
                    drone.getValue().label().role()));
            next += count;
        }
        return groups;
    }

    /** The words for a table: {@code wing (25 drones)}; with the role of the group unless it attacks. */
    String label() {
        String note = role == ThreatLabel.Role.DECOY ? "decoy" : role == ThreatLabel.Role.BYSTANDER ? "bystander" : "";
        String count = isSwarm ? Counted.of(members.size(), "drone") : "";
        String both = String.join(
                ", ",
                List.of(count, note).stream().filter(part -> !part.isEmpty()).toList());
        return both.isEmpty() ? name : name + " (" + both + ")";
    }
}
