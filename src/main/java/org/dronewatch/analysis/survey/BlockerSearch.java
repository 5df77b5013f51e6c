package org.dronewatch.analysis.survey;

import java.util.List;
import java.util.Optional;
import org.dronewatch.buildings.BuildingOutline;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.run.Stage;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.Visibility;

/**
 * Finds what hides a drone, and which building of a map that is: all buildings of a map are one model, so the building
 * is the one whose outline contains the point just behind its surface. Keeps scratch memory: for use by one thread at a
 * time.
 */
final class BlockerSearch {
    /** How far behind the surface the point is, in plan view, m: the corners of the map's meshes are rounded. */
    private static final double BEHIND = 0.01;

    private final Visibility visibility;
    private final List<Building> buildings;

    /** An outline with its corners, which it would copy at every call. */
    private record Building(BuildingOutline outline, double[] outer) {
        boolean contains(double x, double y) {
            boolean inside = false;
            for (int i = 0, j = outer.length - 2; i < outer.length; j = i, i += 2) {
                boolean crosses = outer[i + 1] > y != outer[j + 1] > y;
                if (crosses
                        && x < (outer[j] - outer[i]) * (y - outer[i + 1]) / (outer[j + 1] - outer[i + 1]) + outer[i]) {
                    inside = !inside;
                }
            }
            return inside;
        }
    }

    BlockerSearch(Stage stage) {
        this.visibility = new Visibility(stage.world());
        this.buildings = stage.buildings()
                .map(map -> map.outlines().stream()
                        .map(outline -> new Building(outline, outline.outer()))
                        .toList())
                .orElse(List.of());
    }

    /**
     * What hides a drone.
     *
     * @param sensor where the sensor is, m
     * @param drone where the drone is, m
     * @param named what the sensor's assessment names
     */
    Blocker between(Position sensor, Position drone, Obstacle named) {
        Position along = drone.minus(sensor);
        boolean isHidden =
                visibility.findFirstAlong(sensor.x(), sensor.y(), sensor.z(), along.x(), along.y(), along.z(), 1.0);
        // Where only a part of the drone is hidden, the obstacle is not on this line.
        if (!isHidden
                || named.model().role() != ModelRole.BUILDING
                || !visibility.world().obstacle(visibility.triangle()).equals(named)) {
            return new Blocker(named, Optional.empty());
        }
        double behind = visibility.distance() + BEHIND / Math.max(BEHIND, Math.hypot(along.x(), along.y()));
        return new Blocker(named, building(sensor.x() + behind * along.x(), sensor.y() + behind * along.y()));
    }

    /** The building at a place: one with a name if any of those there has one, as a building and its parts overlap. */
    private Optional<BuildingOutline> building(double x, double y) {
        List<BuildingOutline> there = buildings.stream()
                .filter(one -> one.contains(x, y))
                .map(Building::outline)
                .toList();
        return there.stream().filter(one -> one.name().isPresent()).findFirst().or(() -> there.stream()
                .findFirst());
    }
}
