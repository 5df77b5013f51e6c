package org.dronewatch.run.store;

import org.dronewatch.terrain.KnownGround;
import org.dronewatch.terrain.LoadedTerrain;

/**
 * A terrain that was read, and the area in which its ground is known.
 *
 * @param terrain the terrain as read
 * @param ground the area in which the ground is known, by its triangles
 */
public record PreparedTerrain(LoadedTerrain terrain, KnownGround ground) {}
