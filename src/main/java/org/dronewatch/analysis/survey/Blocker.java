package org.dronewatch.analysis.survey;

import java.util.Optional;
import org.dronewatch.buildings.BuildingOutline;
import org.dronewatch.world.Obstacle;

/**
 * What hides a drone from a sensor.
 *
 * @param obstacle the first surface on the line of sight
 * @param building the building to which the obstacle belongs, if this comes from a map of buildings
 */
public record Blocker(Obstacle obstacle, Optional<BuildingOutline> building) {}
