package org.dronewatch.fusion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.World;

/**
 * The protected zones of a world: distances are those to the nearest zone, and the first zone entered counts.
 *
 * @param zone the sphere, if there is one
 * @param areas the protected areas, placed on the ground, in the order of the scene
 */
public record Protection(Optional<ProtectedZone> zone, List<AreaZone> areas) {
    /** The name of the sphere in results, since it has none in the settings. */
    public static final String ZONE = "protected";

    /** Copies the list: later changes by the caller have no effect. */
    public Protection {
        areas = List.copyOf(areas);
    }

    /**
     * The protected zones that settings describe, placed in a world.
     *
     * @throws org.dronewatch.setting.InputException with a one-line message when there is no ground below an area
     */
    public static Protection of(AlertSettings alert, World world) {
        List<AreaZone> areas = new ArrayList<>();
        alert.zones().forEach((name, area) -> areas.add(AreaZone.of(name, area, world)));
        return new Protection(alert.protect(), areas);
    }

    /** Whether nothing is protected. */
    public boolean isEmpty() {
        return zone.isEmpty() && areas.isEmpty();
    }

    /** The distance from a point to the nearest zone, m: 0 inside it; infinite if nothing is protected. */
    public double distance(Position position) {
        double nearest = zone.map(ball -> ball.distance(position)).orElse(Double.POSITIVE_INFINITY);
        for (AreaZone area : areas) {
            nearest = Math.min(nearest, area.distance(position));
        }
        return nearest;
    }

    /** The name of the nearest zone; empty if nothing is protected. */
    public Optional<String> nearest(Position position) {
        double distance = distance(position);
        if (zone.isPresent() && zone.get().distance(position) <= distance) {
            return Optional.of(ZONE);
        }
        return areas.stream()
                .filter(area -> area.distance(position) <= distance)
                .map(AreaZone::name)
                .findFirst();
    }

    /**
     * The position along a straight segment at which a zone is first reached.
     *
     * @return fraction of the segment before that position, 0 when the segment begins inside a zone; empty when it
     *     stays outside all zones
     */
    public OptionalDouble entry(Position from, Position to) {
        OptionalDouble first = zone.map(ball -> ball.entry(from, to)).orElse(OptionalDouble.empty());
        for (AreaZone area : areas) {
            OptionalDouble share = area.entry(from, to);
            if (share.isPresent() && share.getAsDouble() < first.orElse(Double.POSITIVE_INFINITY)) {
                first = share;
            }
        }
        return first;
    }
}
