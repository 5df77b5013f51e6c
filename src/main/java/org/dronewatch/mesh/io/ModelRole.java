package org.dronewatch.mesh.io;

/** The role of a model on the site. */
public enum ModelRole {
    /** The ground: hills, dams, pits. */
    TERRAIN,
    /** Structures: houses, walls, masts. */
    BUILDING,
    /** Plants: trees, hedges. */
    VEGETATION,
    /** Anything else, such as parked vehicles. */
    OTHER
}
