package org.dronewatch.buildings;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The outline and the height of a building, for maps and plans.
 *
 * @param id identifier of the building on the map
 * @param name name of the building, if the map states one
 * @param isPart whether this is a part of a building, which may be lower or higher than the rest
 * @param outer the outline, counter-clockwise: x and y in the world frame of each corner in turn, m, at the level of
 *     the origin
 * @param courts courtyards, clockwise, in the same form as the outline
 * @param bottom height of the building's lowest point above the lowest ground below it, m; 0 if it stands on the ground
 * @param top height of the building's highest point above the same ground, m
 * @param isAssumed whether the height is assumed, since the map does not state it
 */
public record BuildingOutline(
        String id,
        Optional<String> name,
        boolean isPart,
        double[] outer,
        List<double[]> courts,
        double bottom,
        double top,
        boolean isAssumed) {
    /** Copies the list and the corners: later changes by the caller have no effect. */
    public BuildingOutline {
        outer = outer.clone();
        courts = courts.stream().map(double[]::clone).toList();
    }

    /** A copy of the outline's corners. */
    @Override
    public double[] outer() {
        return outer.clone();
    }

    /** Copies of the courtyards' corners. */
    @Override
    public List<double[]> courts() {
        return courts.stream().map(double[]::clone).toList();
    }

    static BuildingOutline of(Building building, Dimensions dimensions) {
        return new BuildingOutline(
                building.id(),
                named(building.tags()),
                building.isPart(),
                building.footprint().outer(),
                building.footprint().courts(),
                dimensions.bottom(),
                dimensions.top(),
                dimensions.isAssumed());
    }

    private static Optional<String> named(Map<String, String> tags) {
        return Optional.ofNullable(tags.get("name")).map(String::strip).filter(text -> !text.isEmpty());
    }
}
